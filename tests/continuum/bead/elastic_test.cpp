// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <gtest/gtest.h>

#include "continuum/bead/hertz.hpp"
#include "continuum/bead/hooke.hpp"

namespace packbed::continuum {
namespace {

constexpr BeadShape bead{.radius = 30e-6, .poisson = 0.2};

TEST(HertzBead, IsTheSameInTheTwoFormsOfTheThesis) {  // per contact (3.1) and in Delta (C.20)
  const HertzBead hertz{bead, 3.89e6};

  for (const double approach : {1e-8, 1e-6, 1e-5}) {
    const double other = elastic_force(bead, shear_modulus(3.89e6, 0.2), approach);
    EXPECT_NEAR(hertz.force(approach) / other, 1.0, 1e-14);
  }
}

TEST(HertzBead, ApproachIsTheInverseOfForce) {
  const HertzBead hertz{bead, 3.89e6};
  EXPECT_NEAR(hertz.approach(hertz.force(4.5e-6)) / 4.5e-6, 1.0, 1e-14);
}

// B6: the energy is the integral of the force. Simpson's rule in x^2, in which x^(3/2) is a polynomial, is
// exact: with Delta = s^2, F dDelta = c s^3 2 s ds, so 4th order on 1000 strips is below 1e-11.
TEST(HertzBead, EnergyIsTheIntegralOfTheForce) {
  const HertzBead hertz{bead, 3.89e6};
  constexpr int n = 1000;
  const double end = std::sqrt(4.5e-6);
  double sum = 0.0;
  for (int i = 0; i <= n; ++i) {
    const double s = end * i / n;
    const double weight = i == 0 || i == n ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    sum += weight * hertz.force(s * s) * 2.0 * s;
  }
  EXPECT_NEAR(hertz.energy(4.5e-6) / (sum * end / n / 3.0), 1.0, 1e-8);
}

// Bead S of the contact tests, pressed on a plate that is rigid: k = 37.209127 N/m is that of a pair with
// half the radius, mass and modulus, so 2^(1/2 + 2/5 ...): here the exact ratio of eq. 4.21,
// k(plate) / k(pair) = (sqrt(2) 2)^(4/5) 2^(1/5) = 2^(7/5).
TEST(HookeBead, HasTheStiffnessOfThePairScaledToAPlate) {
  const HookeBead hooke{.shape = {.radius = 43.45e-6, .poisson = 0.2},
                        .youngs_modulus = 30e6,
                        .density = 1140.0,
                        .characteristic_velocity = 0.1};
  EXPECT_NEAR(hooke.stiffness() / (37.209127 * std::pow(2.0, 1.4)), 1.0, 1e-7);
  EXPECT_NEAR(hooke.youngs_modulus_of(hooke.stiffness()) / 30e6, 1.0, 1e-13);
  EXPECT_DOUBLE_EQ(hooke.force(2e-6), hooke.stiffness() * 1e-6);
}

}  // namespace
}  // namespace packbed::continuum
