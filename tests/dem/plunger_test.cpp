// SPDX-License-Identifier: BSD-3-Clause
// T2, T3, T8, T11, T12: walls that move, slope, slide, bend and end.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/beads.hpp"

namespace packbed::dem {
namespace {

using namespace test;  // NOLINT

constexpr double g = 9.81;
constexpr double radius = 0.5 * diameter_s;

Wall plunger_at(double z, double speed) {
  return {.name = "plunger",
          .surface = Plane{.point = {0, 0, z}, .normal = {0, 0, -1}},
          .material = plate,
          .velocity = {0, 0, -speed},
          .friction = 0.0};
}

// T12: v' = -e (v_b - v) + v for a bead that comes to meet the plunger.
TEST(Plunger, ThrowsAMovingBeadBack) {
  Dem dem(options(hooke(0.6), 1e-10), {bead(0, {0, 0, -1.001 * radius}, {0, 0, 0.05})},
          {plunger_at(0, 0.1)});
  dem.run(150000);
  EXPECT_NEAR(dem.snapshot().v[0].z, -0.6 * (0.05 + 0.1) - 0.1, 2e-5);
}

/// A short column of beads with weight, one a little aside so that it zigzags between two fixed ones.
std::vector<BeadStart> column(int count) {
  std::vector<BeadStart> beads;
  for (int k = 0; k < count; ++k)
    beads.push_back(with_weight(bead(k, {0, 0, (2 * k + 1) * radius}), g));
  return beads;
}

// T12: without friction and damping all the work of the plunger is found again as energy.
TEST(Plunger, DoesTheWorkThatIsStored) {
  constexpr int count = 5;
  const double dt = 5e-10;
  const double speed = 0.02;
  Dem dem(options(hooke(1.0), dt), column(count),
          {floor_at(0), plunger_at(2 * count * radius, speed)});
  const auto energy = [&](const Snapshot& s) {
    double potential = 0.0;
    for (const auto& x : s.x) potential += mass_of(diameter_s, density_s) * g * x.z;
    return s.kinetic_energy + s.elastic_energy + potential;
  };
  auto before = dem.snapshot();
  const double start = energy(before);
  double work = 0.0;
  for (int n = 0; n < 40000; ++n) {
    dem.run(1);
    const auto now = dem.snapshot();
    work -= 0.5 * dt * speed * (-before.wall_force[1].z - now.wall_force[1].z);
    before = now;
  }
  ASSERT_GT(std::abs(work), 1e-14);
  EXPECT_NEAR((energy(before) - start) / std::abs(work), 1.0, 1e-6);
}

// T12: the plunger bears the contacts of the beads that it touches, and all forces add up to nothing.
TEST(Plunger, BearsTheSumOfItsContacts) {
  std::vector<BeadStart> beads;
  for (int k = 0; k < 4; ++k)
    beads.push_back(bead(k, {k * 3 * radius, 0, -radius + (k + 1) * 1e-7}));
  const Dem dem(options(hooke(0.5), 1e-9), beads, {plunger_at(0, 0.0)});
  const double k_n = dem.wall_contacts()[0][0].coefficients.a;
  const auto s = dem.snapshot();
  EXPECT_NEAR(s.wall_force[0].z / (k_n * 10e-7), 1.0, 1e-9);
  Vec3 sum = s.wall_force[0];
  for (const auto& f : s.force) sum += f;
  EXPECT_LT(norm(sum), 1e-14 * norm(s.wall_force[0]));
}

// T3: spin-down of a bead on a floor without friction: only rolling resistance, d omega / dt = 5 mu_r g / (2 R).
TEST(Wall, RollingResistanceActsWithoutFriction) {
  auto b = with_weight(bead(0, {0, 0, radius}), g);
  b.x.z -= b.properties.weight / 98.011745;
  b.w.y = 1e-2 / radius;
  Dem dem(options(hooke(0.5), 2e-7, 0.0, ConstantTorque{0.1}), {b}, {floor_at(0, 0.0)});
  dem.run(5000);
  const auto first = dem.snapshot();
  dem.run(1000);
  const auto last = dem.snapshot();
  const double slowing = (first.w[0].y - last.w[0].y) / (last.time - first.time);
  EXPECT_NEAR(slowing / (2.5 * 0.1 * g / radius), 1.0, 5e-3);
  EXPECT_EQ(last.x[0].x, 0.0);
}

// T2: mu and mu_r above the slope's tangent: at rest, drift over 1 s.
TEST(Wall, BeadDoesNotCreepDownASlope) {
  const double a = 20.0 * std::numbers::pi / 180.0;
  const Vec3 normal{std::sin(a), 0, std::cos(a)};
  auto b = with_weight(bead(0, {}), g);
  b.x = (radius - b.properties.weight * std::cos(a) / 98.011745) * normal;
  Wall slope{.name = "slope",
             .surface = Plane{.point = {}, .normal = normal},
             .material = plate,
             .velocity = {},
             .friction = 0.5};
  Dem dem(options(hooke(0.5), 8e-7, 0.5, ElasticPlastic{0.4}), {b}, {slope});
  dem.run(25000);
  const auto first = dem.snapshot();
  dem.run(1250000);
  const auto last = dem.snapshot();
  EXPECT_LT(norm(last.x[0] - first.x[0]) / (last.time - first.time), 1e-8);
}

// T8, steep angles: sliding throughout takes mu times the normal momentum, whatever the law:
// v_t' = v_t - mu (v_n + v_n'), omega R = 5/2 of that.
TEST(Wall, SteepImpactsOfAluminumOxideSlideThroughout) {
  const Material oxide{.youngs_modulus = 380e9, .poisson_ratio = 0.23};
  const double r = 2.5e-3;
  const double mu = 0.092;
  for (const double degrees : {50.0, 70.0, 85.0}) {
    const double a = degrees * std::numbers::pi / 180.0;
    const double v_n = 3.9 * std::cos(a);
    const double v_t = 3.9 * std::sin(a);
    Dem dem(options(HertzMindlin{.restitution = 0.98}, 4e-9, mu),
            {bead(0, {0, 0, r}, {v_t, 0, -v_n}, 2 * r, 4000, oxide)}, {floor_at(0, mu, oxide)});
    dem.run(static_cast<std::int64_t>(7500 / std::cos(a)));
    const auto s = dem.snapshot();
    ASSERT_GT(s.x[0].z, r);
    const double taken = mu * (v_n + s.v[0].z);
    EXPECT_NEAR((v_t - s.v[0].x) / taken, 1.0, 0.01) << degrees;
    EXPECT_NEAR(s.w[0].y * r / (2.5 * taken), 1.0, 0.01) << degrees;
  }
}

Wall disc_of(double edge) {
  return {.name = "disc",
          .surface = Disc{.center = {}, .normal = {0, 0, 1}, .radius = edge},
          .material = plate,
          .velocity = {},
          .friction = 0.3};
}

/// Force on a bead at a place, at rest.
Vec3 force_at(const Vec3& x, const std::vector<Wall>& walls) {
  return Dem(options(hooke(0.5), 1e-9), {bead(0, x)}, walls).snapshot().force[0];
}

// T11: a plane, a disc and the inside of a tube press equally on a bead that is equally deep in them.
TEST(Wall, SurfacesPressEquallyAtEqualOverlap) {
  const double depth = 1e-7;
  const Wall tube{.name = "tube",
                  .surface = Tube{.radius = 1e-3},
                  .material = plate,
                  .velocity = {},
                  .friction = 0.0};
  const double on_plane = norm(force_at({0, 0, radius - depth}, {floor_at(0)}));
  EXPECT_NEAR(norm(force_at({0, 0, radius - depth}, {disc_of(1e-3)})) / on_plane, 1.0, 1e-12);
  // The overlap is a difference of numbers of 1 mm: eps 1e-3 / 1e-7.
  EXPECT_NEAR(norm(force_at({1e-3 - radius + depth, 0, 0}, {tube})) / on_plane, 1.0, 1e-11);
}

// T11: at the rim the face's force goes over into the rim's, once and not twice.
TEST(Wall, RimOfADiscPressesOnce) {
  const double edge = 1e-3;
  const double depth = 1e-7;
  const double inside = norm(force_at({edge - 1e-15, 0, radius - depth}, {disc_of(edge)}));
  const double outside = norm(force_at({edge + 1e-15, 0, radius - depth}, {disc_of(edge)}));
  EXPECT_NEAR(outside / inside, 1.0, 1e-12);
  const Vec3 beside = (radius - depth) * Vec3{0.6, 0, 0.8};
  const Vec3 f = force_at(Vec3{edge, 0, 0} + beside, {disc_of(edge)});
  EXPECT_NEAR(norm(f) / inside, 1.0, 1e-11);
  EXPECT_NEAR(f.x / norm(f), 0.6, 1e-9);
}

}  // namespace
}  // namespace packbed::dem
