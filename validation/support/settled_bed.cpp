// SPDX-License-Identifier: BSD-3-Clause
#include "validation/support/settled_bed.hpp"

#include <utility>
#include <variant>

#include "analysis/bed_height.hpp"
#include "analysis/profile.hpp"
#include "column/protocol/settle_stage.hpp"
#include "core/quantity.hpp"
#include "setup/make_settle.hpp"
#include "setup/read_case.hpp"

namespace packbed::validation {

Settled settle(const std::string& text) {
  const UnitSystem units;
  auto c = setup::read_case_text("title = \"validation\"\n" + text, "validation.toml", units);
  const auto choice = setup::step_of(c);
  auto dem = setup::make_dem(c, choice.step, Ranks::alone());
  const auto& step = std::get<setup::Settle>(c.protocol.front().what);
  column::SettleStage stage(setup::settle_options(c, step, choice, true), 1.0);
  stage.begin(dem);
  while (stage.advance(dem) != column::After::end) {}
  const auto steps = dem.steps();
  return {std::move(c), std::move(dem), steps};
}

double height_of(const Settled& bed) {
  return analysis::bed_figures(analysis::own_beads(bed.dem.particles()),
                               mesh::cross_section(bed.c.column.shape), bed.dem.ranks())
      .height;
}

double budget_error(const Settled& bed) {
  const auto s = bed.dem.snapshot();
  double weight = 0.0;
  for (const auto& bead : s.beads) weight += bead.weight;
  double carried = 0.0;
  for (const auto& force : s.wall_force) carried -= force.z;
  return 1.0 - carried / weight;
}

}  // namespace packbed::validation
