// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/message_of.hpp"
#include "tests/support/sphere_box.hpp"

namespace packbed::dem {
namespace {

using namespace test;  // NOLINT

constexpr double factor = 1.1;

/// A pair and a bead on the floor with springs under load.
std::vector<BeadStart> three(double d) {
  return {with_weight(bead(0, {0, 0, 0.499 * d}, {1e-3, 0, 0}, d), 9.81),
          bead(1, {5 * d, 0, 5 * d}, {0, 1e-3, 0}, d), bead(2, {5.97 * d, 0, 5 * d}, {}, 1.02 * d)};
}

// A grown bed is the bed made with the larger diameters at the same places.
TEST(Growth, GivesTheForcesOfABedMadeThatLarge) {
  const auto o = options(HertzMindlin{.restitution = 0.5}, 1e-9);
  Dem grown(o, three(diameter_s), {floor_at(0)});
  grown.scale_diameters(factor);
  auto large = three(factor * diameter_s);
  const auto places = three(diameter_s);
  for (std::size_t i = 0; i < large.size(); ++i) large[i].x = places[i].x;
  Dem made(o, large, {floor_at(0)});
  for (int look = 0; look < 2; ++look) {
    const auto s = grown.snapshot();
    const auto t = made.snapshot();
    for (std::size_t i = 0; i < large.size(); ++i) {
      EXPECT_LT(norm(s.force[i] - t.force[i]), 1e-12 * norm(t.force[i])) << i;
      EXPECT_LT(norm(s.v[i] - t.v[i]), 1e-12) << i;
    }
    grown.run(100);
    made.run(100);
  }
}

TEST(Growth, KeepsSpringsAndDensity) {
  auto o = options(hooke(1.0), 1e-9, 0.5);
  Dem dem(o, three(diameter_s), {floor_at(0, 0.5)});
  dem.run(50);
  const auto spring = dem.contacts().pair(0).history.spring;
  const auto on_wall = dem.wall_contacts()[0][0].history.spring;
  const auto before = dem.particles().properties[0];
  ASSERT_GT(norm(spring), 0.0);
  ASSERT_GT(norm(on_wall), 0.0);
  dem.scale_diameters(factor);
  EXPECT_EQ(dem.contacts().pair(0).history.spring, spring);
  EXPECT_EQ(dem.wall_contacts()[0][0].history.spring, on_wall);
  const auto& after = dem.particles().properties[0];
  EXPECT_NEAR(after.mass / before.mass, std::pow(factor, 3), 1e-14);
  EXPECT_NEAR(after.weight / before.weight, std::pow(factor, 3), 1e-14);
  EXPECT_NEAR(
      dem.particles().motion[0].inv_inertia * 0.1 * after.mass * after.diameter * after.diameter,
      1.0, 1e-14);
}

TEST(Growth, ByOneChangesNoBit) {
  const auto o = options(hooke(0.5), 1e-9, 0.5);
  Dem plain(o, three(diameter_s), {floor_at(0, 0.5)});
  Dem scaled(o, three(diameter_s), {floor_at(0, 0.5)});
  plain.run(100);
  scaled.run(100);
  scaled.scale_diameters(1.0);
  plain.run(100);
  scaled.run(100);
  EXPECT_EQ(plain.snapshot().v, scaled.snapshot().v);
  EXPECT_EQ(plain.snapshot().w, scaled.snapshot().w);
}

TEST(Growth, RefusesWhatIsNoFactorAndOverlapsBeyondTheLimit) {
  Dem dem(options(hooke(0.5), 1e-9), head_on(0.0), {});
  for (const double wrong : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    EXPECT_NE(message_of([&] { dem.scale_diameters(wrong); }), "");
  }
  EXPECT_NE(message_of([&] { dem.scale_diameters(1.5); }).find("overlaps bead"), std::string::npos);
}

// P2 in small: at the edge of rigidity a frictionless packing has just one contact more than degrees
// of freedom, 3 (N - 1) + 1 for N beads that carry in a periodic box (validation/jamming.cpp: 2000).
TEST(Growth, FrictionlessPackingIsIsostaticAtTheEdge) {
  const ContactModel model{.contact = hooke(0.5, false), .rolling = NoRolling{}};
  SphereBox box(model, 64, 0.5, 3, 4);
  const auto rests = [&](double share) { return box.relax(share, 20000, 1e-5); };
  while (!rests(1e-3)) box.set_solid_fraction(box.solid_fraction() + 0.005);
  // Down by halves of what presses; p is about half the excess fraction.
  auto at_edge = box.figures();
  for (int halving = 0; halving < 7; ++halving) {
    box.set_solid_fraction(box.solid_fraction() - box.figures().pressure);
    if (!box.relax(1e-5, 20000)) break;
    at_edge = box.figures();
  }
  EXPECT_LT(at_edge.pressure, 2e-4);
  EXPECT_NEAR(at_edge.solid_fraction, 0.63,
              0.03);  // few beads: +- 0.01, O'Hern et al. 2003, fig. 6
  EXPECT_NEAR(static_cast<double>(at_edge.contacts),
              3.0 * static_cast<double>(at_edge.carrying - 1) + 1.0, 3.0);
  EXPECT_GT(at_edge.carrying, 50);
}

}  // namespace
}  // namespace packbed::dem
