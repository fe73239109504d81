// SPDX-License-Identifier: BSD-3-Clause
// What settling does gives the same bits on any number of ranks. Run under mpiexec; every rank also does
// it alone. Few steps: each takes an exchange.
#include <cstdio>

#include "column/protocol/settle_beads.hpp"
#include "core/ranks.hpp"
#include "tests/support/settling.hpp"

namespace packbed::column {
namespace {

constexpr std::int64_t few_steps = 20;

/// Slices, beads put in and taken out, a lid and another cloud, one after the other.
SettleState treat(test::Settling& s) {
  s.options.slice = few_steps;
  Settle step(s.options, s.start);
  step.advance(s.dem);
  const auto bed = look_at_bed(s.dem, mesh::cross_section(s.options.shape));
  const double volume = 0.5e-3 * mesh::cross_section(s.options.shape);
  const auto next = add_beads(s.options, bed.top, 0.5 * volume, step.state().next_id, s.dem);
  s.dem.run(few_steps);
  remove_highest(0.2 * volume, s.dem);
  place_plunger(5e-3, s.dem);
  step.advance(s.dem);
  make_new_cloud(s.options, 1, s.dem);
  step.advance(s.dem);
  auto state = step.state();
  state.next_id = next;
  return state;
}

int check() {
  const auto ranks = Ranks::all();
  auto shared = test::cloud_of(120, 0.1, ranks);
  auto alone = test::cloud_of(120);
  const auto a = treat(shared);
  const auto b = treat(alone);
  std::int64_t wrong[1] = {0};
  const auto expect = [&](bool good, const char* what) {
    if (good) return;
    std::printf("rank %d: other %s\n", ranks.rank(), what);
    ++wrong[0];
  };
  expect(a.phase == b.phase && a.slices == b.slices, "progress");
  expect(a.bed_height == b.bed_height && a.porosity == b.porosity, "bed");
  expect(a.unbalanced == b.unbalanced && a.coordination == b.coordination, "rest");
  expect(a.next_id == b.next_id && a.next_id > 120, "number of beads added");
  expect(shared.dem.bead_count() == alone.dem.bead_count(), "number of beads");
  expect(alone.dem.bead_count() < b.next_id, "beads taken out");
  expect(shared.dem.options().step == alone.dem.options().step, "time step");
  const auto s = shared.dem.snapshot();
  const auto t = alone.dem.snapshot();
  expect(s.elastic_energy == t.elastic_energy && t.elastic_energy > 0.0, "energy");
  if (ranks.is_first()) {
    expect(s.x == t.x, "places");
    expect(s.v == t.v, "velocities");
    expect(s.force == t.force, "forces");
  }
  ranks.sum(wrong);
  if (ranks.is_first()) {
    std::printf("%d ranks, %lld beads: %lld differences\n", ranks.size(),
                static_cast<long long>(shared.dem.bead_count()), static_cast<long long>(wrong[0]));
  }
  return wrong[0] == 0 ? 0 : 1;
}

}  // namespace
}  // namespace packbed::column

int main() {
  const packbed::MpiSession session;
  return packbed::column::check();
}
