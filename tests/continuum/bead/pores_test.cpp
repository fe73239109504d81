// SPDX-License-Identifier: BSD-3-Clause
// What follows from the pores of a bead: poroelastic relaxation, density, permeability, attenuation.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "continuum/bead/attenuation.hpp"
#include "continuum/bead/hertz.hpp"
#include "continuum/bead/poroelastic_ramp.hpp"
#include "continuum/bead/swollen_bead.hpp"

namespace packbed::continuum {
namespace {

constexpr BeadShape shape{.radius = 30e-6, .poisson = 0.2};

TEST(PoroelasticRelaxation,
     IsThatOfHu) {  // B5: eq. 3.40 worked out apart from the code, six digits
  EXPECT_DOUBLE_EQ(poroelastic_relaxation(0.0), 1.0);
  EXPECT_NEAR(poroelastic_relaxation(0.1), 0.798780, 5e-7);
  EXPECT_NEAR(poroelastic_relaxation(1.0), 0.292994, 5e-7);
  EXPECT_NEAR(poroelastic_relaxation(10.0), 0.0278017, 5e-8);
}

TEST(PoroelasticBead, StartsIncompressibleAndEndsDrained) {  // B5
  const PoroelasticBead bead{shape, 1.6e6, 1e-10};
  const HertzBead incompressible{{.radius = 30e-6, .poisson = 0.5}, youngs_modulus(1.6e6, 0.5)};
  const HertzBead drained{shape, youngs_modulus(1.6e6, 0.2)};

  EXPECT_NEAR(bead.initial_force(4e-6) / incompressible.force(4e-6), 1.0, 1e-12);
  EXPECT_NEAR(bead.final_force(4e-6) / drained.force(4e-6), 1.0, 1e-12);
  EXPECT_NEAR(bead.initial_force(4e-6) / bead.final_force(4e-6), 1.6, 1e-12);  // eq. 3.37
  EXPECT_NEAR(bead.force(4e-6, 0.0) / bead.initial_force(4e-6), 1.0, 1e-12);
  EXPECT_NEAR(bead.force(4e-6, 1e6) / bead.final_force(4e-6), 1.0, 1e-9);
}

TEST(PoroelasticBead, RelaxesInATimeThatGrowsWithTheAreaOfContact) {
  const PoroelasticBead bead{shape, 1.6e6, 1e-10};
  const auto share = [&](double approach, double t) {
    const double f = bead.final_force(approach);
    return (bead.force(approach, t) - f) / (bead.initial_force(approach) - f);
  };
  EXPECT_NEAR(share(1e-6, 0.1), share(4e-6, 0.4), 1e-12);
}

TEST(PoroelasticRamp, LiesBetweenTheStepAndTheDrainedBead) {
  const PoroelasticBead bead{shape, 1.6e6, 1e-10};
  const auto end_of_ramp = [&](double time) {
    return poroelastic_force(bead, {.depth = 4e-6, .ramp_time = time}, time);
  };
  // Fast: F_0; first order in sqrt(D t/a^2), so 1e-5 at 1e-12. Slow: F_inf; g falls with exp(-sqrt), so 1/x remains.
  EXPECT_NEAR(end_of_ramp(1e-12) / bead.initial_force(4e-6), 1.0, 1e-5);
  EXPECT_NEAR(end_of_ramp(1e6) / bead.final_force(4e-6), 1.0, 1e-5);
  for (const double t : {0.0, 0.1, 3.0}) {  // no ramp: the step
    EXPECT_NEAR(poroelastic_force(bead, {.depth = 4e-6}, t) / bead.force(4e-6, t), 1.0, 1e-12);
  }
  // Held long after a short ramp: that of the step.
  EXPECT_NEAR(
      poroelastic_force(bead, {.depth = 4e-6, .ramp_time = 1e-6}, 2.0) / bead.force(4e-6, 2.0), 1.0,
      1e-5);
}

// D t/a^2 = D/(R v) does not change at constant speed, so neither does the share of F_0 that is left.
TEST(PoroelasticRamp, KeepsItsShareAtConstantSpeed) {
  const PoroelasticBead bead{shape, 1.6e6, 1e-10};
  const auto excess = [&](double t) {
    const Loading loading{.depth = 4e-6, .ramp_time = 4.0};
    const double f = bead.final_force(loading.approach(t));
    return (poroelastic_force(bead, loading, t) - f) /
           (bead.initial_force(loading.approach(t)) - f);
  };
  EXPECT_NEAR(excess(0.1), excess(4.0), 1e-10);
}

// Worked out by another quadrature (QUADPACK in x = y^2): D t/a^2 = 0.1, 1, 10.
TEST(PoroelasticRamp, HasTheExcessOfItsIntegral) {
  EXPECT_NEAR(poroelastic_excess(0.1, 1.0, 1.0), 0.891906154812657, 1e-9);
  EXPECT_NEAR(poroelastic_excess(1.0, 1.0, 1.0), 0.578781520515206, 1e-9);
  EXPECT_NEAR(poroelastic_excess(10.0, 1.0, 1.0), 0.157416758932230, 1e-9);
}

TEST(SwollenBead, HasTheDensitiesOfTable62) {  // SEP 1.139 g/cm3; TOY 1.281, printed 1.34
  EXPECT_NEAR(wet_density(0.84, 1000.0, 1870.0), 1139.2, 1e-9);
  EXPECT_NEAR(wet_density(0.63, 1000.0, 1760.0), 1281.2, 1e-9);
}

TEST(SwollenBead,
     DiffusivityOfPressure) {  // by hand: k = 0.84 (20 nm)^2 / 5; D = 1.6 G k / (0.6 mu)
  const double k = pore_permeability(0.84, 20e-9);
  EXPECT_NEAR(k / 6.72e-17, 1.0, 1e-12);
  EXPECT_NEAR(poroelastic_diffusivity(0.2, 1.62e6, k, 1e-3) / (1.6 * 1.62e6 * 6.72e-17 / 0.6e-3),
              1.0, 1e-12);
}

TEST(SwollenBead, PoissonRatioFromPictures) {
  constexpr double r = 30e-6;
  EXPECT_NEAR(flattened_volume(r, 2 * r) / (4.0 / 3.0 * std::numbers::pi * r * r * r), 1.0, 1e-14);
  // A bead that keeps its volume at 20 % strain has nu = 1/2.
  const double h = 1.6 * r;
  const double kept = std::sqrt(4.0 * r * r * r / (3.0 * h) + h * h / 12.0);
  EXPECT_NEAR(poisson_from_pictures(r, h, kept), 0.5, 1e-12);
  // One that loses 0.6 of its strain in volume has nu = 0.2: V = 0.88 V0.
  const double lost = std::sqrt(0.88 * 4.0 * r * r * r / (3.0 * h) + h * h / 12.0);
  EXPECT_NEAR(poisson_from_pictures(r, h, lost), 0.2, 1e-12);
}

TEST(Attenuation, MixesByMassAndFollowsTheExponentialLaw) {
  // w_liquid = 0.63 1000 / 1281.2; by hand.
  const double w = 630.0 / 1281.2;
  EXPECT_NEAR(bead_attenuation(0.63, 1000.0, 1760.0, 0.02, 0.03), w * 0.02 + (1 - w) * 0.03, 1e-15);
  EXPECT_NEAR(absorbed_share(0.02, 1000.0, 9.6e-3), 1.0 - std::exp(-0.192), 1e-15);
  EXPECT_EQ(absorbed_share(0.02, 1000.0, 0.0), 0.0);
}

}  // namespace
}  // namespace packbed::continuum
