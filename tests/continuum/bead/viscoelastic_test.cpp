// SPDX-License-Identifier: BSD-3-Clause
#include "continuum/bead/viscoelastic.hpp"

#include <cmath>
#include <tuple>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>

#include "continuum/bead/hertz.hpp"

namespace packbed::continuum {
namespace {

constexpr BeadShape sepharose{.radius = 30e-6, .poisson = 0.2};
constexpr BeadShape toyopearl{.radius = 41.5e-6, .poisson = 0.2};

Loading ramp(double speed, double time) { return {.depth = speed * time, .ramp_time = time}; }

double at_end(const BeadShape& shape, const ShearRelaxation& g, const Loading& loading) {
  return ViscoelasticBead{shape, g}.force(loading, loading.ramp_time);
}

// B1: eq. 3.26 with table 6.4 (eta in MPa s), worked out apart from the code with mpmath; equal to quadrature
// of C.20 to 12 digits.
TEST(StandardLinearSolid, HasTheForcesOfTable64) {
  const auto force = [](const BeadShape& s, double g0, double g1, double eta, double v, double t) {
    return at_end(s, sls_maxwell(g0, g1, eta), ramp(v, t));
  };
  EXPECT_NEAR(force(sepharose, 1.62e6, 3.51e6, 0.9e6, 0.9e-6, 5.0) / 116.0210038e-6, 1.0, 1e-9);
  EXPECT_NEAR(force(sepharose, 2.21e6, 25.6e6, 0.9e6, 5e-6, 2.5) / 783.4075296e-6, 1.0, 1e-9);
  EXPECT_NEAR(force(toyopearl, 1.76e6, 2.56e6, 0.68e6, 0.9e-6, 5.0) / 141.9329664e-6, 1.0, 1e-9);
  EXPECT_NEAR(force(toyopearl, 2.42e6, 19.21e6, 0.68e6, 5e-6, 2.5) / 947.8840172e-6, 1.0, 1e-9);
}

// The integral of C.20 itself, with s = r^2 so that the integrand is smooth.
double by_quadrature(const BeadShape& shape, const ShearRelaxation& g, double v, double t) {
  const auto integrand = [&](double r) { return 2.0 * g.at(t - r * r) * 3.0 * r * r; };
  return shape.factor() * std::pow(v, 1.5) *
         boost::math::quadrature::gauss_kronrod<double, 61>::integrate(integrand, 0.0, std::sqrt(t),
                                                                       15, 1e-13);
}

TEST(ViscoelasticBead, LoadingIsTheSuperpositionIntegral) {
  const ShearRelaxation g{.relaxed = 1.6e6, .terms = {{2e6, 0.05}, {1e6, 0.7}, {0.5e6, 12.0}}};

  for (const double t : {0.01, 0.3, 5.0, 40.0}) {
    const double force = at_end(sepharose, g, ramp(0.9e-6, t));
    EXPECT_NEAR(force / by_quadrature(sepharose, g, 0.9e-6, t), 1.0, 1e-10) << t;
  }
}

TEST(RampRemainder, MeetsItsSeriesAndItsLimit) {
  EXPECT_EQ(ramp_remainder(0.0), 1.0);
  EXPECT_NEAR(ramp_remainder(1e-9), 1.0 - 0.4e-9, 1e-15);  // 1 - 2x/5
  EXPECT_NEAR(ramp_remainder(0.5) / ramp_remainder(0.5 + 1e-15), 1.0,
              1e-14);                                                // where the forms meet
  EXPECT_NEAR(ramp_remainder(1e4) * 1e4 / 1.5, 1.0 - 0.5e-4, 1e-8);  // erfi overflows above 700
  EXPECT_NEAR(ramp_remainder(1e12) * 1e12 / 1.5, 1.0, 1e-11);
}

// B2. Fast: the error of Hertz with G0 + G1 is 2x/5, slow: Hertz with G0 and the creeping term.
TEST(StandardLinearSolid, HasTheLimitsOfItsTwoForms) {
  const double tau = 0.9 / 3.51;
  const auto elastic = [&](double g, double t) { return elastic_force(sepharose, g, 0.9e-6 * t); };
  const auto maxwell = [&](double t) {
    return at_end(sepharose, sls_maxwell(1.62e6, 3.51e6, 0.9e6), ramp(0.9e-6, t));
  };
  const auto kelvin = [&](double t) {
    return at_end(sepharose, sls_kelvin(1.62e6, 3.51e6, 0.9e6), ramp(0.9e-6, t));
  };
  const double fast = 1e-9 * tau;
  const double slow = 1e10 * tau;

  EXPECT_NEAR(maxwell(fast) / elastic(5.13e6, fast), 1.0, 1e-8);
  EXPECT_NEAR(maxwell(slow) / elastic(1.62e6, slow), 1.0, 1e-8);
  EXPECT_NEAR(maxwell(1e4 * tau) / elastic(1.62e6 + 3.51e6 * 1.5e-4 * (1 - 0.5e-4), 1e4 * tau), 1.0,
              1e-8);
  EXPECT_NEAR(kelvin(fast) / elastic(1.62e6, fast), 1.0, 1e-8);
  EXPECT_NEAR(kelvin(slow) / elastic(1.62e6 * 3.51e6 / 5.13e6, slow), 1.0, 1e-8);
}

TEST(StandardLinearSolid, KelvinIsMaxwellWithOtherConstants) {
  const double g0 = 1.62e6;
  const double g1 = 3.51e6;
  const auto kelvin = sls_kelvin(g0, g1, 0.9e6);
  const double arm = g0 * g0 / (g0 + g1);
  const auto maxwell = sls_maxwell(g0 * g1 / (g0 + g1), arm, arm * 0.9e6 / (g0 + g1));

  for (const double t : {0.0, 0.1, 1.0}) EXPECT_NEAR(kelvin.at(t) / maxwell.at(t), 1.0, 1e-14);
}

TEST(Prony, ModuliAreHalvesOfItsCoefficients) {  // eqs 3.32, 3.33
  const auto g = prony(3.2e6, {{0.4e6, 1.0}, {0.2e6, 0.1}});
  EXPECT_DOUBLE_EQ(g.relaxed, 1.6e6);
  EXPECT_DOUBLE_EQ(g.instantaneous(), 1.9e6);
}

TEST(ViscoelasticBead, HeldRelaxesFromTheEndOfTheRampToItsRelaxedModulus) {
  const ViscoelasticBead bead{sepharose, sls_maxwell(1.62e6, 3.51e6, 0.9e6)};
  const auto loading = ramp(1e-6, 4.0);
  const double end = bead.force(loading, 4.0);
  const double rest = elastic_force(sepharose, 1.62e6, 4e-6);

  EXPECT_NEAR(bead.force(loading, 4.0 + 1e-12) / end, 1.0, 1e-10);
  EXPECT_NEAR((bead.force(loading, 4.5) - rest) / (end - rest), std::exp(-0.5 * 3.51 / 0.9), 1e-12);
  EXPECT_NEAR(bead.force(loading, 1e3) / rest, 1.0, 1e-12);
}

TEST(ViscoelasticBead, AStepIsTheLimitOfAFastRamp) {
  const ViscoelasticBead bead{sepharose, sls_maxwell(1.62e6, 3.51e6, 0.9e6)};
  const double step = bead.force({.depth = 4e-6}, 1.0);

  EXPECT_NEAR(step / elastic_force(sepharose, bead.relaxation.at(1.0), 4e-6), 1.0, 1e-14);
  EXPECT_NEAR(bead.force({.depth = 4e-6, .ramp_time = 1e-9}, 1.0) / step, 1.0, 1e-8);
}

TEST(ViscoelasticBead, UnloadsAlongTheLoadingIfElastic) {
  const ViscoelasticBead bead{sepharose, {.relaxed = 2e6, .terms = {}}};
  const Loading loading{.depth = 4e-6, .ramp_time = 4.0, .hold_time = 1.0};

  for (const double t : {5.5, 7.0, 8.9}) {
    EXPECT_NEAR(bead.force(loading, t) / bead.force(loading, 9.0 - t), 1.0, 1e-12) << t;
  }
  EXPECT_EQ(bead.force(loading, 9.5), 0.0);
}

TEST(ViscoelasticBead, LosesThePlateBeforeItIsBack) {
  const ViscoelasticBead bead{sepharose, sls_maxwell(1.62e6, 3.51e6, 0.9e6)};
  const Loading loading{.depth = 4e-6, .ramp_time = 4.0, .hold_time = 0.0};

  EXPECT_NEAR(bead.force(loading, 4.0 + 1e-9) / bead.force(loading, 4.0), 1.0, 1e-7);  // no jump
  EXPECT_LT(bead.force(loading, 6.0), bead.force(loading, 2.0));
  EXPECT_EQ(bead.force(loading, 7.99), 0.0);
  EXPECT_GT(loading.approach(7.99), 0.0);
}

// Ting's condition checked by brute force: pressing a bead with the history of its contact radius only
// (Delta^(3/2) put on up to t1, nothing after) gives the same force as superposition up to t1.
TEST(ViscoelasticBead, UnloadingIsTheIntegralUpToTheTimeOfTheSameContact) {
  const auto g = sls_maxwell(1.62e6, 3.51e6, 0.9e6);
  const ViscoelasticBead bead{sepharose, g};
  const Loading loading{.depth = 4e-6, .ramp_time = 4.0, .hold_time = 0.5};
  const double t = 5.2;
  using Rule = boost::math::quadrature::gauss_kronrod<double, 61>;
  const auto still = [&](double t1) {  // integral of G dDelta from t1 to t, over the three parts
    const auto modulus = [&](double s) { return g.at(t - s); };
    return Rule::integrate(modulus, t1, 4.0) - Rule::integrate(modulus, 4.5, t);
  };
  double low = 0.0;
  double high = 4.0;
  for (int i = 0; i < 60; ++i) (still(0.5 * (low + high)) > 0.0 ? low : high) = 0.5 * (low + high);
  const auto integrand = [&](double r) { return 2.0 * g.at(t - r * r) * 3.0 * r * r; };
  const double expected = sepharose.factor() * std::pow(1e-6, 1.5) *
                          Rule::integrate(integrand, 0.0, std::sqrt(low), 15, 1e-13);

  EXPECT_NEAR(bead.force(loading, t) / expected, 1.0, 1e-10);
}

}  // namespace
}  // namespace packbed::continuum
