// SPDX-License-Identifier: BSD-3-Clause
// Integration and small assemblies against exact answers. Numbers: docs/theory/contact.md, section 9.
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
  EXPECT_NEAR(s.x[0].z, 1.0 + 0.2 - 0.5 * g, 1e-12);  // 10 000 additions of 1e-16 times 4
  EXPECT_NEAR(s.x[0].x, 0.3, 1e-13);
  EXPECT_NEAR(s.v[0].z, 0.2 - g, 1e-12);
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

// C11 (MFIX DEM03): two beads squeezed between plates 3.6 r apart, k = 1e3 N/m: rest heights.
TEST(Dem, TwoSqueezedBeadsRestWhereTheSpringsSay) {
  // A Hooke law of k_n = 1e3 N/m for every contact: a stand-in for the coefficients.
  const double r = 0.5e-3;
  std::vector<BeadStart> beads = {
      with_weight(bead(0, {0, 0, 0.25 * 3.6 * r}, {}, 2 * r, 20000), g),
      with_weight(bead(1, {0, 0, 0.75 * 3.6 * r}, {}, 2 * r, 10000), g)};
  Wall lid{.name = "lid",
           .surface = Plane{.point = {0, 0, 3.6 * r}, .normal = {0, 0, -1}},
           .material = plate,
           .velocity = {},
           .friction = 0.0};
  auto o = options(hooke(0.3), 1e-7);
  Dem dem(o, beads, {floor_at(0), lid});
  dem.run(400000);
  const auto s = dem.snapshot();
  // With the stiffnesses of this law k_ff (floor), k_pp, k_lid the rest state solves two linear
  // equations: force balances of both beads.
  const auto k_of = [&](std::size_t w) { return dem.wall_contacts()[w][0].coefficients.a; };
  const double k1 = k_of(0);
  const double k2 = dem.contacts().pair(0).coefficients.a;
  const double k3 = k_of(1);
  const double w1 = beads[0].properties.weight;
  const double w2 = beads[1].properties.weight;
  // unknown overlaps a (floor), b (pair), c (lid): a + b + c = 4 r - 3.6 r
  // k1 a - k2 b = w1,  k2 b - k3 c = w2
  const double total = 0.4 * r;
  const double b = (total - w1 / k1 + w2 / k3) / (1.0 + k2 / k1 + k2 / k3);
  const double a = (w1 + k2 * b) / k1;
  EXPECT_NEAR(s.x[0].z, r - a, 1e-9 * r);
  EXPECT_NEAR(s.x[1].z, r - a + 2.0 * r - b, 1e-9 * r);
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

// C13: uniaxial modulus k_n / d = 428183.28 Pa of a simple cubic lattice, by its wall-less periodic
// stress: force per area from the pair forces of one bead with its own images is not listed, so two
// cells per side.
TEST(Dem, CubicLatticeHasItsUniaxialModulus) {
  const double strain = 1e-4;
  const double d = diameter_s;
  const double pitch = d * (1.0 - strain);
  std::vector<BeadStart> beads;
  for (int k = 0; k < 27; ++k) {
    beads.push_back(bead(k, {(k % 3 + 0.5) * d, (k / 3 % 3 + 0.5) * d, (k / 9 + 0.5) * pitch}));
  }
  auto o = options(hooke(0.5), 1e-8);
  o.domain = {.low = {0, 0, 0}, .size = {3 * d, 3 * d, 3 * pitch}, .periodic = {true, true, true}};
  const Dem dem(o, beads, {});
  const auto s = dem.snapshot();
  // elastic energy per volume = 1/2 M strain^2
  const double volume = 3 * d * 3 * d * 3 * pitch;
  const double modulus = 2.0 * s.elastic_energy / (volume * strain * strain);
  EXPECT_NEAR(modulus / 428183.28, 1.0, 2e-4);     // volume at the strained length: 1 - strain
  EXPECT_NEAR(s.coordination_number, 2.0, 1e-12);  // the other four only just touch
  for (const auto& f : s.force) EXPECT_LT(norm(f), 1e-15);
}

// P1: ordered lattices have their coordination number (simple cubic 6, face-centered 12).
double coordination(const std::vector<Vec3>& basis, Vec3 cell) {
  std::vector<BeadStart> beads;
  for (int k = 0; k < 27; ++k) {
    const Vec3 corner{(k % 3) * cell.x, (k / 3 % 3) * cell.y, (k / 9) * cell.z};
    for (const auto& at : basis) {
      beads.push_back(bead(static_cast<std::int64_t>(beads.size()), corner + at));
    }
  }
  auto o = options(hooke(0.5), 1e-8);
  o.domain = {.low = {0, 0, 0},
              .size = {3 * cell.x, 3 * cell.y, 3 * cell.z},
              .periodic = {true, true, true}};
  return Dem(o, beads, {}).snapshot().coordination_number;
}

TEST(Dem, LatticesHaveTheirCoordinationNumber) {
  const double d = 0.9999 * diameter_s;
  EXPECT_EQ(coordination({{0, 0, 0}}, {d, d, d}), 6.0);
  const double a = std::sqrt(2.0) * d;
  EXPECT_EQ(
      coordination({{0, 0, 0}, {a / 2, a / 2, 0}, {a / 2, 0, a / 2}, {0, a / 2, a / 2}}, {a, a, a}),
      12.0);
  const double h = 0.5 * std::sqrt(3.0) * d;  // orthorhombic: columns of beads in triangles, 8
  EXPECT_EQ(coordination({{0, 0, 0}, {d / 2, h, 0}}, {d, 2 * h, d}), 8.0);
}

// I7: a lattice moved by any vector has the same forces.
TEST(Dem, PeriodicBoxHasNoPlaceOfItsOwn) {
  const double d = diameter_s;
  const auto energy = [&](Vec3 shift) {
    std::vector<BeadStart> beads;
    for (int k = 0; k < 27; ++k) {
      beads.push_back(
          bead(k, Vec3{(k % 3) * 0.99 * d, (k / 3 % 3) * 0.98 * d, (k / 9) * 0.97 * d} + shift));
    }
    auto o = options(hooke(0.5), 1e-8);
    o.domain = {.low = {0, 0, 0},
                .size = {3 * 0.99 * d, 3 * 0.98 * d, 3 * 0.97 * d},
                .periodic = {true, true, true}};
    return Dem(o, beads, {}).snapshot().elastic_energy;
  };
  const double e = energy({});
  EXPECT_NEAR(energy({0.3 * d, -0.7 * d, 11.2 * d}) / e, 1.0, 1e-10);
  EXPECT_NEAR(energy({1e-9, 2e-9, -1e-9}) / e, 1.0, 1e-10);
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
