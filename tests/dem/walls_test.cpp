// SPDX-License-Identifier: BSD-3-Clause
// Single beads on walls against exact answers. T-numbers: docs/verification.md.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/beads.hpp"

namespace packbed::dem {
namespace {

using namespace test;  // NOLINT

constexpr double g = 9.81;
constexpr double radius = 0.5 * diameter_s;

/// A bead resting on a horizontal floor: its weight is carried by the overlap.
BeadStart resting(double k_n, Vec3 v = {}) {
  auto b = with_weight(bead(0, {0, 0, radius}, v), g);
  b.x.z -= b.properties.weight / k_n;
  return b;
}

constexpr double k_n_plate = 98.011745;  // N/m

// T1: a sphere set sliding rolls after t_s = 2 u0 / (7 mu g) with u = 5/7 u0. u0 = 1 mm/s, mu = 0.1:
// 2.91248e-4 s, 0.24964 um.
TEST(Wall, SlidingBeadBeginsToRoll) {
  Dem dem(options(hooke(0.5), 1e-7, 0.1), {resting(k_n_plate, {1e-3, 0, 0})}, {floor_at(0, 0.1)});
  dem.run(2912);
  const auto at_roll = dem.snapshot();
  EXPECT_NEAR(at_roll.x[0].x, 0.24964e-6, 2.5e-10);

  dem.run(3000);

  const auto s = dem.snapshot();
  EXPECT_NEAR(s.v[0].x / 1e-3, 5.0 / 7.0, 1e-3);
  EXPECT_NEAR(s.w[0].y * radius / 1e-3, 5.0 / 7.0, 1e-3);
}

/// Acceleration along a slope of `degrees` after a start-up time.
double slope_acceleration(double degrees, double mu, const RollingLaw& rolling) {
  const double a = degrees * std::numbers::pi / 180.0;
  const Vec3 normal{std::sin(a), 0, std::cos(a)};
  const Vec3 downhill{std::cos(a), 0, -std::sin(a)};
  auto b = with_weight(bead(0, {}), g);
  b.x = (radius - b.properties.weight * std::cos(a) / k_n_plate) * normal;
  Wall slope{.name = "slope",
             .surface = Plane{.point = {}, .normal = normal},
             .material = plate,
             .velocity = {},
             .friction = mu};
  Dem dem(options(hooke(0.5), 2e-7, mu, rolling), {b}, {slope});
  dem.run(20000);
  const auto first = dem.snapshot();
  dem.run(20000);
  const auto last = dem.snapshot();
  return dot(last.v[0] - first.v[0], downhill) / (last.time - first.time);
}

// T2, 20 degrees: rolls at 5/7 g sin = 2.396584 m/s2 if mu is enough, slips at 2.433379 for mu = 0.1,
// rolls against CDT friction 0.1 at 1.738128.
TEST(Wall, BeadRollsOrSlipsDownASlope) {
  EXPECT_NEAR(slope_acceleration(20, 0.3, NoRolling{}) / 2.396584, 1.0, 1e-3);
  EXPECT_NEAR(slope_acceleration(20, 0.1, NoRolling{}) / 2.433379, 1.0, 1e-3);
  EXPECT_NEAR(slope_acceleration(20, 0.3, ConstantTorque{0.1}) / 1.738128, 1.0, 1e-3);
}

TEST(Wall, BeadRestsOnASlopeThatRollingFrictionHolds) {
  EXPECT_NEAR(slope_acceleration(20, 0.5, ElasticPlastic{0.4}), 0.0, 1e-6);
}

// T3: constant torque slows a rolling bead by 5/7 mu_r g.
TEST(Wall, RollingBeadSlowsUnderConstantTorque) {
  auto b = resting(k_n_plate, {1e-2, 0, 0});
  b.w.y = 1e-2 / radius;
  Dem dem(options(hooke(0.5), 2e-7, 0.5, ConstantTorque{0.1}), {b}, {floor_at(0, 0.5)});
  dem.run(5000);
  const auto first = dem.snapshot();
  dem.run(20000);
  const auto last = dem.snapshot();
  const double a = (first.v[0].x - last.v[0].x) / (last.time - first.time);
  EXPECT_NEAR(a / (5.0 / 7.0 * 0.1 * g), 1.0, 5e-3);
}

// T4: at rest. The elastic-plastic law keeps rest; constant torque chatters within 2 torque dt / I.
TEST(Wall, BeadAtRestStaysAtRest) {
  Dem dem(options(hooke(0.5), 2e-7, 0.5, ElasticPlastic{0.35}), {resting(k_n_plate)},
          {floor_at(0, 0.5)});
  dem.run(1000000);
  const auto s = dem.snapshot();
  EXPECT_LT(norm(s.w[0]) * radius, 1e-9);
  EXPECT_LT(norm(s.v[0]), 1e-9);
}

TEST(Wall, ConstantTorqueChattersWithinItsBound) {
  const double dt = 2e-7;
  auto b = resting(k_n_plate);
  b.w.y = 1e-6 / radius;
  Dem dem(options(hooke(0.5), dt, 0.5, ConstantTorque{0.35}), {b}, {floor_at(0, 0.5)});
  dem.run(100000);
  const double m = b.properties.mass;
  const double bound = 0.35 * m * g * radius * dt / (0.4 * m * radius * radius);
  EXPECT_LT(norm(dem.snapshot().w[0]), 2.0 * bound);
}

struct Rebound {
  double v_t, w;  ///< tangential velocity and spin times radius, over the normal speed
};

/// Oblique impact on a wall: normal speed 0.1 m/s, tangential ratio * 0.1 m/s.
Rebound oblique(double ratio, double mu, double e, double v_n = 0.1) {
  auto b = bead(0, {0, 0, radius}, {ratio * v_n, 0, -v_n});
  Dem dem(options(hooke(e), 1e-9, mu), {b}, {floor_at(0, mu)});
  dem.run(10);
  while (distance_to(dem.walls()[0], dem.particles().motion[0].x).distance <
         dem.particles().radius(0)) {
    dem.run(1);
  }
  const auto s = dem.snapshot();
  return {s.v[0].x / v_n, s.w[0].y * radius / v_n};
}

// T5: gross sliding, mu = 0.1, v_t / v_n = 5, e = 1: v_t' = 4.8, spin 0.5.
TEST(Wall, ObliqueImpactThatSlidesThroughout) {
  const auto r = oblique(5.0, 0.1, 1.0, 1e-5);
  EXPECT_NEAR(r.v_t, 4.8, 4.8e-4);
  EXPECT_NEAR(r.w, 0.5, 5e-5);
}

// T6: sticking throughout, k_t = k_n, undamped: v_t'/v_t = 0.976796, spin -0.0580104 v_t... for a bead
// that hits softly, so that the arm R - overlap is R.
TEST(Wall, ObliqueImpactThatSticksThroughout) {
  const auto r = oblique(1.0, 1e6, 1.0, 1e-5);
  EXPECT_NEAR(r.v_t, 0.976796, 1e-4);
  EXPECT_NEAR(r.w, 0.0580104, 1e-4);
}

// T7: changes between sticking and sliding, undamped, v_t / v_n = 0.2.
TEST(Wall, ObliqueImpactWithStickAndSlip) {
  const auto low = oblique(0.2, 0.1, 1.0, 1e-5);
  EXPECT_NEAR(low.v_t, 0.137040, 1e-3);
  EXPECT_NEAR(low.w, 0.157399, 1e-3);
  const auto high = oblique(0.2, 0.5, 1.0, 1e-5);
  EXPECT_NEAR(high.v_t, 0.192601, 1e-3);
  EXPECT_NEAR(high.w, 0.018498, 1e-3);
}

// T8: Chung and Ooi's case 4, aluminum oxide of 2.5 mm radius at 3.9 m/s and 5 to 85 degrees on the
// same plate, mu = 0.092, e = 0.98: 100 steps a contact against a step twenty times finer.
Rebound kharaz(double degrees, double steps_per_contact) {
  const Material oxide{.youngs_modulus = 380e9, .poisson_ratio = 0.23};
  const double a = degrees * std::numbers::pi / 180.0;
  const double r = 2.5e-3;
  const double contact_time = 8e-6;
  auto b = bead(0, {0, 0, r}, {3.9 * std::sin(a), 0, -3.9 * std::cos(a)}, 2 * r, 4000, oxide);
  Dem dem(options(HertzMindlin{.restitution = 0.98, .tension = true},
                  contact_time / steps_per_contact, 0.092),
          {b}, {floor_at(0, 0.092, oxide)});
  dem.run(static_cast<std::int64_t>(3.0 / std::cos(a) * steps_per_contact));
  const auto s = dem.snapshot();
  EXPECT_GT(s.v[0].z, 0.0) << degrees;
  return {s.v[0].x / 3.9, s.w[0].y * r / 3.9};
}

TEST(Wall, ObliqueImpactsAgreeWithAFineStep) {
  for (int degrees = 5; degrees <= 85; degrees += 10) {
    const auto coarse = kharaz(degrees, 100);
    const auto fine = kharaz(degrees, 2000);
    EXPECT_NEAR(coarse.v_t, fine.v_t, 0.01 * std::max(std::abs(fine.v_t), 0.05)) << degrees;
    EXPECT_NEAR(coarse.w, fine.w, 0.01 * std::max(std::abs(fine.w), 0.05)) << degrees;
  }
}

// T10: period of a small swing at the bottom of a lying tube, R_c = 5 mm, r = 0.13035 mm: 0.165637 s
// rolling, 0.139989 s without friction. (A quarter of a period is timed.)
double swing_period(double mu) {
  const double r = 0.13035e-3;
  const double arm = 5e-3 - r;
  const double start = 0.05;  // rad; lengthens the period by 1.6e-4
  auto b = with_weight(bead(0, {arm * std::sin(start), 0, -arm * std::cos(start)}, {}, 2.0 * r), g);
  Wall tube{.name = "tube",
            .surface = Tube{.radius = 5e-3, .axis = {0, 1, 0}},
            .material = plate,
            .velocity = {},
            .friction = mu};
  Dem dem(options(hooke(0.5), 5e-7, mu), {b}, {tube});
  double before = b.x.x;
  while (true) {
    dem.run(1);
    const double x = dem.particles().motion[0].x.x;
    if (x <= 0.0) return 4.0 * (dem.time() - 5e-7 * x / (x - before));
    before = x;
  }
}

TEST(Wall, BeadSwingsAtTheBottomOfATube) {
  EXPECT_NEAR(swing_period(0.5) / 0.165637, 1.0, 2e-3);
  EXPECT_NEAR(swing_period(0.0) / 0.139989, 1.0, 2e-3);
}

// T11: the same drop on a plane and on a large disc gives the same force; beyond the rim only the
// rim is touched.
TEST(Wall, DiscIsAPlaneInsideItsRim) {
  Wall disc{.name = "disc",
            .surface = Disc{.center = {}, .normal = {0, 0, 1}, .radius = 1e-3},
            .material = plate,
            .velocity = {},
            .friction = 0.3};
  const std::vector<BeadStart> drop = {bead(0, {0.2e-3, 0, radius}, {0.01, 0.02, -0.1})};
  Dem on_disc(options(hooke(0.7), 1e-8, 0.3), drop, {disc});
  Dem on_plane(options(hooke(0.7), 1e-8, 0.3), drop, {floor_at(0, 0.3)});
  on_disc.run(400);
  on_plane.run(400);
  EXPECT_EQ(on_disc.snapshot().v[0], on_plane.snapshot().v[0]);
  const auto beside = distance_to(disc, {1e-3 + 3e-5, 0, 4e-5});
  EXPECT_NEAR(beside.distance, 5e-5, 1e-18);
  EXPECT_NEAR(beside.normal.x, 0.6, 1e-12);
}

// T12: a bead at rest hit by a plunger moving at v leaves with v (1 + e).
TEST(Wall, MovingPlungerThrowsABead) {
  Wall plunger{.name = "plunger",
               .surface = Plane{.point = {0, 0, 0}, .normal = {0, 0, -1}},
               .material = plate,
               .velocity = {0, 0, -0.1},
               .friction = 0.0};
  Dem dem(options(hooke(0.6), 1e-9), {bead(0, {0, 0, -1.001 * radius})}, {plunger});
  dem.run(20000);
  EXPECT_NEAR(dem.snapshot().v[0].z, -0.16, 1e-4);
}

// T9: springs live as long as the contact does, and no longer.
TEST(Wall, SpringsEndWithTheContact) {
  auto b = bead(0, {0, 0, radius - 1e-8}, {1e-3, 0, 0});
  Dem dem(options(hooke(1.0), 1e-9, 10.0), {b}, {floor_at(0, 10.0)});
  dem.run(100);
  EXPECT_GT(norm(dem.wall_contacts()[0][0].history.spring), 0.0);
  dem.run(10000);  // thrown off by the initial overlap
  ASSERT_GT(dem.snapshot().x[0].z, radius);
  for (const auto& contact : dem.wall_contacts()[0]) EXPECT_EQ(norm(contact.history.spring), 0.0);
}

}  // namespace
}  // namespace packbed::dem
