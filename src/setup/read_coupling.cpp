// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "setup/any_flow.hpp"
#include "setup/averaging.hpp"
#include "setup/read_sections.hpp"

namespace packbed::setup {
namespace {

constexpr double per_mm = 1e3;

// A kernel narrower than a cell makes void fractions jump as beads pass from cell to cell.
void check_width(const Section& section, const Case& c) {
  const double reach = averaging_reach(c);
  const double cell = c.column.mesh->cell;
  if (reach < cell) {
    section.fail("averaging_width",
                 fmt::format("is narrower than a cell of the liquid ({:.4g} mm); "
                             "make it wider, or column.mesh.cell smaller",
                             per_mm * cell));
  }
  const double most = most_averaging_reach(c);
  if (reach <= most || !any_flow(c.protocol, c.liquid.has_value())) return;
  section.fail("averaging_width",
               fmt::format("{}is more than half of a periodic side, {:.4g} mm; make the column "
                           "wider, or the width smaller",
                           section.has("averaging_width")
                               ? ""
                               : fmt::format("({:.4g} mm by default) ", per_mm * reach),
                           per_mm * most));
}

}  // namespace

DragOptions read_drag(Section section) {
  DragOptions drag;
  drag.law = static_cast<DragLawName>(section.choice(
      "law", {"koch_hill", "ergun", "gidaspow", "di_felice", "beetstra"}, Fallback{"koch_hill"}));
  drag.min_void_fraction = section.quantity_or_word(
      "min_void_fraction", Dimension::fraction, bounds::between_0_and_1, "none", Fallback{"none"});
  section.finish();
  return drag;
}

CouplingOptions read_coupling(Section section, const Case& c) {
  Case with = c;  // with what is read here
  auto& coupling = with.coupling;
  coupling.overlap =
      static_cast<OverlapRuleName>(section.choice("overlap", {"full", "merged"}, Fallback{"full"}));
  coupling.scheme = static_cast<CouplingSchemeName>(
      section.choice("scheme", {"frozen_flux", "frozen_velocity"}, Fallback{"frozen_flux"}));
  coupling.averaging_width = section.quantity_or_word("averaging_width", Dimension::length,
                                                      bounds::positive, "auto", Fallback{"auto"});
  coupling.interval = section.quantity_or_word("interval", Dimension::time, bounds::positive,
                                               "auto", Fallback{"auto"});
  check_width(section, with);
  section.finish();
  return coupling;
}

}  // namespace packbed::setup
