// SPDX-License-Identifier: BSD-3-Clause
// Whole runs at the edges of what is allowed: soft beads, an incompressible plate, no speed, gaps and
// overlaps of 1e-12 m, rolling resistance without friction; every contact and rolling law.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/beads.hpp"

namespace packbed::dem {
namespace {

using namespace test;  // NOLINT

constexpr Material soft{.youngs_modulus = 4e6, .poisson_ratio = 0.2};
constexpr Material incompressible{.youngs_modulus = 1e10, .poisson_ratio = 0.5};

const std::vector<ContactLaw> laws = {hooke(0.5, false), HertzMindlin{.restitution = 0.5},
                                      ViscousHooke{.characteristic_velocity = 0.1,
                                                   .restitution_max = 0.9,
                                                   .critical_stokes = 0.3,
                                                   .viscosity = 1e-3}};
const std::vector<RollingLaw> rollings = {NoRolling{}, ConstantTorque{0.3}, ElasticPlastic{0.3}};

/// Two beads one above the other on a plate, `gap` between all, at rest.
std::vector<BeadStart> tower(double gap, double g) {
  const double d = diameter_s;
  return {with_weight(bead(0, {0, 0, 0.5 * d + gap}, {}, d, density_s, soft), g),
          with_weight(bead(1, {0, 0, 1.5 * d + 2 * gap}, {}, d, density_s, soft), g)};
}

TEST(EdgeCases, BeadsAcrossAGapOfAPicometerDoNotFeelEachOther) {
  for (const auto& law : laws) {
    for (const auto& rolling : rollings) {
      Dem dem(options(law, 1e-7, 0.3, rolling), tower(1e-12, 0.0),
              {floor_at(0, 0.3, incompressible)});
      dem.run(100);
      const auto s = dem.snapshot();
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(s.force[i], Vec3{});
        EXPECT_EQ(s.v[i], Vec3{});
      }
      EXPECT_EQ(s.coordination_number, 0.0);
    }
  }
}

// v_n = 0 exactly in the first step, and overlaps from 1e-12 m on.
TEST(EdgeCases, SoftBeadsComeToRestWithAndWithoutFriction) {
  for (const auto& law : laws) {
    for (const auto& rolling : rollings) {
      for (const double mu : {0.0, 0.3}) {
        auto o = options(law, 1e-7, mu, rolling);
        o.background_damping = 2e4;
        Dem dem(o, tower(-1e-12, 9.81), {floor_at(0, mu, incompressible)});
        dem.run(20000);
        const auto s = dem.snapshot();
        const double weight = dem.particles().properties[0].weight;
        EXPECT_NEAR(-s.wall_force[0].z / (2.0 * weight), 1.0, 1e-3);
        for (std::size_t i = 0; i < 2; ++i) {
          EXPECT_LT(norm(s.v[i]), 1e-7);
          EXPECT_LT(norm(s.w[i]) * diameter_s, 1e-7);
        }
      }
    }
  }
}

// Without friction a pair that rolls resists its relative spin, and the sum of spins is kept.
TEST(EdgeCases, RollingResistanceOfAPairWithoutFriction) {
  for (const RollingLaw& rolling :
       {RollingLaw{ConstantTorque{0.3}}, RollingLaw{ElasticPlastic{0.3}}}) {
    auto beads = head_on(0.0);
    for (auto& b : beads) b.x = 0.999 * b.x, b.properties.fixed = false;
    beads[0].w = {0, 10, 0};
    Dem dem(options(hooke(0.5), 1e-8, 0.0, rolling), beads, {});
    dem.run(100);
    const auto s = dem.snapshot();
    EXPECT_GT(s.w[1].y, 0.0);
    EXPECT_NEAR(s.w[0].y + s.w[1].y, 10.0, 1e-10);
    EXPECT_NEAR(s.v[0].z, 0.0, 1e-15);
  }
}

}  // namespace
}  // namespace packbed::dem
