// SPDX-License-Identifier: BSD-3-Clause
// Integration and small assemblies against exact answers. Numbers: docs/verification.md.
#include "dem/dem.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/beads.hpp"
#include "tests/support/message_of.hpp"

namespace packbed::dem {
namespace {

using namespace test;  // NOLINT
using testing::HasSubstr;

constexpr double g = 9.81;

// I1: free flight for 1 s; velocity Verlet is exact.
TEST(Dem, FreeFallIsExact) {
  Dem dem(options(hooke(0.5), 1e-4), {with_weight(bead(0, {0, 0, 1}, {0.3, 0, 0.2}), g)}, {});
  dem.run(10000);
  const auto s = dem.snapshot();
  EXPECT_NEAR(s.x[0].z / (1.0 + 0.2 - 0.5 * g), 1.0, 1e-13);
  EXPECT_NEAR(s.x[0].x / 0.3, 1.0, 1e-13);
  EXPECT_NEAR(s.v[0].z / (0.2 - g), 1.0, 1e-13);
}

TEST(Dem, BackgroundDampingSlowsAFreeBead) {
  auto o = options(hooke(0.5), 1e-5);
  o.background_damping = 50.0;
  Dem dem(o, {bead(0, {}, {1, 0, 0})}, {});
  dem.run(2000);
  EXPECT_NEAR(dem.snapshot().v[0].x, std::exp(-1.0), 1e-6);
}

// I2: bounces of height h0 e^(2k), nearly hard.
TEST(Dem, BouncesToTheHeightsOfItsRestitution) {
  const double r = 1e-4;
  const Material hard{.youngs_modulus = 1e9, .poisson_ratio = 0.2};
  const auto b = with_weight(bead(0, {0, 0, r + 1e-3}, {}, 2 * r, density_s, hard), g);
  Dem dem(options(HertzMindlin{.restitution = 0.8, .tension = true}, 2e-8), {b}, {floor_at(0)});
  double top = 0.0;
  int bounces = 0;
  double before = 0.0;
  while (bounces < 2) {
    dem.run(1);
    const double v = dem.particles().motion[0].v.z;
    if (before > 0.0 && v <= 0.0) {
      ++bounces;
      top = dem.particles().motion[0].x.z - r;
      EXPECT_NEAR(top / (1e-3 * std::pow(0.8, 2 * bounces)), 1.0, 2e-3) << bounces;
    }
    before = v;
  }
}

// C12: ten beads S between two plates, pressed by 1 um: 3.8126922e-6 N (Hooke), 3.0699897e-6 (Hertz).
double chain_force(const ContactLaw& law) {
  std::vector<BeadStart> beads;
  const double d = diameter_s;
  const double length = 10 * d - 1e-6;
  for (int i = 0; i < 10; ++i) beads.push_back(bead(i, {0, 0, (i + 0.5) * length / 10.0}));
  Wall lid{.name = "lid",
           .surface = Plane{.point = {0, 0, length}, .normal = {0, 0, -1}},
           .material = plate,
           .velocity = {},
           .friction = 0.0};
  auto o = options(law, 5e-8);
  o.background_damping = 2e4;
  Dem dem(o, beads, {floor_at(0), lid});
  dem.run(200000);
  return dem.snapshot().wall_force[1].z;
}

TEST(Dem, ChainCarriesTheForceOfItsSprings) {
  EXPECT_NEAR(chain_force(hooke(0.5, false)) / 3.8126922e-6, 1.0, 1e-6);
  EXPECT_NEAR(chain_force(HertzMindlin{.restitution = 0.5}) / 3.0699897e-6, 1.0, 1e-6);
}

// I4: undamped frictionless beads keep their energy (shorter here; the long run is a validation).
TEST(Dem, UndampedBeadsKeepTheirEnergy) {
  std::vector<BeadStart> beads;
  const double d = diameter_s;
  for (int k = 0; k < 125; ++k) {
    const auto u = [&](int n) {
      return uniform(9, Stream::bead_position, static_cast<std::uint64_t>(10 * k + n));
    };
    const Vec3 x{(k % 5 + 0.5) * 1.2 * d, (k / 5 % 5 + 0.5) * 1.2 * d, (k / 25 + 0.5) * 1.2 * d};
    beads.push_back(bead(k, x, {u(0) - 0.5, u(1) - 0.5, u(2) - 0.5}));
  }
  auto o = options(hooke(1.0), 1e-8);
  o.domain = {.low = {0, 0, 0}, .size = {6 * d, 6 * d, 6 * d}, .periodic = {true, true, true}};
  Dem dem(o, beads, {});
  const auto energy = [&] {
    const auto s = dem.snapshot();
    return s.kinetic_energy + s.elastic_energy;
  };
  const double start = energy();
  for (int look = 0; look < 20; ++look) {
    dem.run(2000);
    EXPECT_NEAR(energy() / start, 1.0, 1e-5);
  }
}

TEST(Dem, FixedBeadsDoNotMove) {
  auto beads = head_on(0.1);
  beads[1].properties.fixed = true;
  beads[1].v = {};
  Dem dem(options(hooke(0.5), 1e-8), beads, {});
  dem.run(2000);
  EXPECT_EQ(dem.snapshot().x[1], beads[1].x);
  EXPECT_GT(dem.snapshot().v[0].x, 0.0);
}

TEST(Dem, InertiaScaleKeepsRestitutionAndStretchesTime) {
  const double s = 100.0;
  Dem plain(options(hooke(0.5), 1e-8), head_on(0.1), {});
  auto o = options(hooke(0.5), 1e-8 * std::sqrt(s));
  o.inertia_scale = s;
  Dem scaled(o, head_on(0.1 / std::sqrt(s)), {});
  EXPECT_NEAR(restitution_of(scaled), restitution_of(plain), 1e-9);
  EXPECT_NEAR(scaled.time() / plain.time(), std::sqrt(s), 1e-9);
}

// Damping follows the masses that move, of each bead its own.
TEST(Dem, InertiaScaledBySizeKeepsRestitution) {
  const auto uneven = [](double speed) { return head_on(speed, diameter_s, 0.4 * diameter_s); };
  Dem plain(options(hooke(0.5), 1e-9), uneven(0.1), {});
  auto o = options(hooke(0.5), 1e-8);
  o.inertia_scale = 100.0;
  o.inertia_diameter = diameter_s;
  Dem scaled(o, uneven(0.01), {});
  const auto& p = scaled.particles();
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto& bead = p.properties[i];
    const double factor = bead.id == 0 ? 100.0 : 1.0 + 99.0 * 4.375;
    EXPECT_NEAR(p.motion[i].inv_mass * factor * bead.mass, 1.0, 1e-12) << bead.id;
  }
  EXPECT_NEAR(restitution_of(scaled), restitution_of(plain), 1e-4);
}

TEST(Dem, StopsAtOverlapsBeyondTheLimitNamingTheBead) {
  const auto message = message_of([] {
    Dem(options(hooke(0.5), 1e-8), {bead(7, {}), bead(8, {0.5 * diameter_s, 0, 0})}, {});
  });
  EXPECT_THAT(message, HasSubstr("bead 7"));
  EXPECT_THAT(message, HasSubstr("0.5 of the smaller diameter"));
}

TEST(Dem, StopsAtNumbersThatAreNone) {
  auto wall = floor_at(-1.0);
  wall.material.youngs_modulus = std::nan("");
  const std::vector<BeadStart> beads = {bead(0, {0, 0, 0.6 * diameter_s}), bead(1, {1e-3, 0, 0})};
  Dem dem(options(hooke(0.5), 1e-8), beads, {wall});
  std::get<Plane>(dem.walls()[0].surface).point.z = 0.0;
  dem.walls()[0].velocity.z = 1.0;  // renews the list; the contact then gives NaN forces
  EXPECT_THAT(message_of([&] { dem.run(2000); }), HasSubstr("bead 0"));
}

// A sticking contact alone: w^2 = 3.5 k / m on a wall. Below the limit a disturbance stays small,
// above it grows until it slides.
double spin_after(double share_of_limit) {
  auto b = bead(0, {0, 0, 0.499 * diameter_s});
  b.properties.weight = 98.011745 * 0.001 * diameter_s;  // holds the overlap
  b.w.y = 1e-6;
  const double limit = 2.0 / std::sqrt(3.5 * 98.011745 / b.properties.mass);
  Dem dem(options(hooke(1.0), share_of_limit * limit, 0.5), {b}, {floor_at(0, 0.5)});
  EXPECT_NEAR(dem.stable().step, limit, 1e-8 * limit);  // k_n is given to 8 digits
  EXPECT_FALSE(dem.stable().of_all);
  dem.run(3000);
  return norm(dem.snapshot().w[0]);
}

TEST(StableStep, OfASingleContactIsWhereItBeginsToGrow) {
  EXPECT_LT(spin_after(0.99), 1e-4);
  EXPECT_GT(spin_after(1.01), 1e-1);
}

TEST(StableStep, NamesTheBeadAndItsContacts) {
  const double d = diameter_s;
  std::vector<BeadStart> beads;
  for (int k = 0; k < 27; ++k) {
    beads.push_back(bead(k, {(k % 3) * 0.99 * d, (k / 3 % 3) * 0.99 * d, (k / 9) * 0.99 * d}));
  }
  const auto limit = Dem(options(hooke(0.5), 1e-8), beads, {}).stable();
  EXPECT_EQ(limit.bead, 13);  // the one in the middle
  EXPECT_EQ(limit.contacts, 6);
  EXPECT_TRUE(limit.of_all);
}

}  // namespace
}  // namespace packbed::dem
