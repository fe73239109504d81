// SPDX-License-Identifier: BSD-3-Clause
// Figures of forces on a bed that has settled: what its contacts hand down is its weight.
#include <gtest/gtest.h>

#include "analysis/stress_profile.hpp"
#include "tests/support/settling.hpp"

namespace packbed::column {
namespace {

using namespace test;  // NOLINT

/// What the beads with centers above a height weigh, less what side walls carry of it [N].
double load_above(const dem::Dem& dem, double z) {
  double load = 0.0;
  for (std::size_t i = 0; i < dem.particles().size(); ++i) {
    if (dem.particles().motion[i].x.z > z) load += dem.particles().properties[i].weight;
  }
  for (const auto& c : dem.touching_contacts()) {
    const bool side_wall = c.id_j < -1;
    if (side_wall && c.x.z > z) load -= c.normal.z + c.tangential.z;
  }
  return load;
}

TEST(BedStress, HandsTheWeightDown) {
  auto s = cloud_of(200, 0.3);
  s.options.friction = 0.3;
  s.options.damping_after = 7.0;
  for (Settle step(s.options, s.start); step.advance(s.dem);) {}
  const auto reports = s.dem.touching_contacts();
  const auto contacts = analysis::contact_forces(reports);
  const auto tangential = analysis::tangential_forces(reports);
  const double area = 2e-3 * 0.7e-3;
  const double whole = load_above(s.dem, 0.0);
  ASSERT_GT(whole, 0.0);

  for (const double z : {1e-6, 0.3e-3, 0.8e-3, 1.2e-3, 1.9e-3}) {
    const std::vector<double> thin = {z, z + 1e-12};
    const auto bin = analysis::stress_profile(contacts, tangential, thin, area)[0];
    EXPECT_NEAR(bin.axial() * area, load_above(s.dem, z), 1e-4 * whole) << z;
  }
  EXPECT_LT(load_above(s.dem, 1.9e-3), 0.7 * whole);
}

}  // namespace
}  // namespace packbed::column
