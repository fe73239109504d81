// SPDX-License-Identifier: BSD-3-Clause
// Beads in a liquid that pulls with rate (target - v), implicit in v.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/beads.hpp"

namespace packbed::dem {
namespace {

using namespace test;  // NOLINT

constexpr double eta = 1e-3;
const double rate_s = 3.0 * std::numbers::pi * eta * diameter_s;  // Stokes

Dem falling(double step, double rate, const Vec3& target = {}) {
  const double weight_s = mass_of(diameter_s, density_s - 1000.0) * 9.81;
  auto start = bead(0, {});
  start.properties.weight = weight_s;
  Dem dem(options(hooke(0.5), step), {start}, {});
  dem.set_in_liquid(true);
  dem.drag()[0] = {target, rate};
  return dem;
}

// D5: S in water of 1 mPa s and 1000 kg/m3 falls at 5.761878e-4 m/s after t >> tau = 4.782687e-4 s.
TEST(Drag, OfStokesLetsABeadFallAtItsTerminalSpeed) {
  const double tau = mass_of(diameter_s, density_s) / rate_s;
  EXPECT_NEAR(tau, 4.782687e-4, 1e-9);
  const double terminal = mass_of(diameter_s, density_s - 1000.0) * 9.81 / rate_s;
  EXPECT_NEAR(terminal, 5.761878e-4, 1e-7 * terminal + 1e-10);
  auto dem = falling(tau / 2000.0, rate_s);
  for (int k = 1; k <= 5; ++k) {
    dem.run(1000);
    const auto s = dem.snapshot();
    EXPECT_NEAR(-s.v[0].z, terminal * (1.0 - std::exp(-0.5 * k)), 1e-3 * terminal);
  }
  dem.run(60000);
  EXPECT_NEAR(-dem.snapshot().v[0].z, terminal, 1e-9 * terminal);
}

// D9: tau = 1e-6 s, step 1e-3 s: monotone, no overshoot.
TEST(Drag, IsMonotoneHoweverStiff) {
  const double mass = mass_of(diameter_s, density_s);
  auto dem = falling(1e-3, mass / 1e-6, {2e-3, -1e-3, 0});
  double before = 0.0;
  for (int n = 0; n < 20; ++n) {
    dem.run(1);
    const double v = dem.state().beads[0].v.x;
    EXPECT_GE(v, before);
    EXPECT_LE(v, 2e-3 * (1.0 + 1e-14));
    before = v;
  }
  EXPECT_NEAR(before, 2e-3, 1e-14);
}

TEST(Drag, BalancesTheWeightOfABeadAtRest) {
  auto dem = falling(1e-7, rate_s);
  const double weight = dem.snapshot().beads[0].weight;
  dem.drag()[0] = {{0, 0, weight / rate_s}, rate_s};
  dem.run(1000);
  const auto s = dem.snapshot();
  EXPECT_NEAR(s.drag[0].z, weight, 1e-12 * weight);
  EXPECT_LT(s.mean_unbalanced_force, 1e-12 * weight);
  EXPECT_LT(norm(s.v[0]), 1e-18);
}

TEST(Drag, GoesWithTheInertiaScaleAndTheBackgroundDamping) {
  const double tau = mass_of(diameter_s, density_s) / rate_s;
  auto dem = falling(tau / 1000.0, rate_s);
  dem.set_inertia_scale(10.0);
  dem.set_background_damping(0.1 / tau);
  const double slowed = 1.0 / (1.0 + 0.1 * 10.0);  // c s m / rate
  const double terminal = slowed * dem.snapshot().beads[0].weight / rate_s;
  dem.run(5000);
  const double share = 1.0 - std::exp(-5.0 * (0.1 + 0.1));
  EXPECT_NEAR(-dem.snapshot().v[0].z, terminal * share, 1e-3 * terminal);
}

TEST(Drag, StaysWithItsBeadWhenBeadsAreOrderedAnew) {
  std::vector<BeadStart> beads;
  for (int k = 0; k < 50; ++k) beads.push_back(bead(k, {k % 5 * 1e-4, k / 5 * 1e-4, 0}));
  Dem dem(options(hooke(0.5), 1e-6), beads, {});
  dem.set_in_liquid(true);
  const auto speed_of = [](std::int64_t id) {
    return Vec3{0.1 * static_cast<double>(id), 0, 0.05};
  };
  for (std::size_t i = 0; i < 50; ++i) {
    dem.drag()[i] = {speed_of(dem.particles().properties[i].id), 1.0};
  }
  const auto renewals = dem.renewals();
  dem.run(5000);  // beads overtake each other far from one another
  EXPECT_GT(dem.renewals(), renewals + 2);
  const auto s = dem.snapshot();
  for (std::size_t i = 0; i < 50; ++i) EXPECT_LT(norm(s.v[i] - speed_of(s.beads[i].id)), 0.02);
  for (std::size_t i = 0; i < 50; ++i) {
    EXPECT_EQ(dem.drag()[i].target, speed_of(dem.particles().properties[i].id));
  }
}

TEST(Drag, IsGoneWhenBeadsLeaveTheLiquid) {
  auto dem = falling(1e-6, rate_s, {1, 0, 0});
  dem.set_in_liquid(false);
  dem.run(100);
  EXPECT_EQ(dem.snapshot().v[0].x, 0.0);
  EXPECT_EQ(dem.snapshot().drag[0], (Vec3{}));
}

}  // namespace
}  // namespace packbed::dem
