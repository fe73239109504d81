// SPDX-License-Identifier: BSD-3-Clause
#include "study/wall_support_fit.hpp"

#include <array>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/noise.hpp"

namespace packbed::study {
namespace {

using continuum::CompressibleBed;
using continuum::ConstantModulus;
using continuum::PowerModulus;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double cm_h = 0.01 / 3600.0;

CompressibleBed toy() {
  return {ConstantModulus{0.164e6}, 61.958e-6, 0.274, 0.269, 360.844, 0.372};
}

// Synthetic measurements: four columns at ten velocities up to 637 cm/h, as in thesis section 5.4.3; with noise as a
// share of each value.
std::vector<ColumnDatum> measured(const CompressibleBed& bed,
                                  double noise,
                                  std::uint64_t seed,
                                  int velocities = 10) {
  test::Noise deviate(seed);
  std::vector<ColumnDatum> data;
  for (const double d : {9.6e-3, 12.5e-3, 16.25e-3, 20e-3}) {
    for (int i = 1; i <= velocities; ++i) {
      ColumnDatum datum{.diameter = d, .velocity = 637.0 * i / velocities * cm_h, .height = 30e-3};
      const auto r =
          continuum::wall_support(bed, {.diameter = d, .height = 30e-3}, datum.velocity, 2);
      datum.gradient = r.pressure_drop_per_height * (1.0 + noise * deviate());
      datum.compression = r.compression * (1.0 + noise * deviate());
      datum.gradient_error = 0.01 * r.pressure_drop_per_height;
      datum.compression_error = 0.01 * r.compression;
      data.push_back(datum);
    }
  }
  return data;
}

WallSupportFitOptions fitting(const std::vector<BedParameter>& parameters) {
  WallSupportFitOptions options{.free = {}, .column = {}};
  for (const auto p : parameters) options.free.push_back(usual_bounds(p));
  options.starts = 3;
  return options;
}

TEST(WallSupportFit, RecoversTheBedFromABadStart) {
  auto start = toy();
  start.modulus = ConstantModulus{0.8e6};
  start.diameter = 110e-6;
  start.wall_friction = 0.05;

  const auto fit = fit_wall_support(
      start, measured(toy(), 0.0, 1, 4),
      fitting({BedParameter::modulus, BedParameter::bead_diameter, BedParameter::wall_friction}));

  EXPECT_NEAR(fit.fit.estimates[0].value / 0.164e6, 1.0, 1e-5);
  EXPECT_NEAR(fit.fit.estimates[1].value / 61.958e-6, 1.0, 1e-5);
  EXPECT_NEAR(fit.fit.estimates[2].value / 0.274, 1.0, 1e-5);
  EXPECT_GT(fit.r2_gradient, 1.0 - 1e-9);
}

// mu_w and nu stand only in their product mu_w nu / (1 - nu): a fit of both must say so, and still know the product.
TEST(WallSupportFit, SaysThatWallFrictionAndPoissonRatioCannotBeToldApart) {
  const auto fit = fit_wall_support(toy(), measured(toy(), 0.01, 3, 4),
                                    fitting({BedParameter::modulus, BedParameter::bead_diameter,
                                             BedParameter::wall_friction, BedParameter::poisson}));

  ASSERT_EQ(fit.fit.confounded.size(), 1U);
  EXPECT_THAT(fit.fit.confounded[0].names, ElementsAre("wall_friction", "poisson"));
  EXPECT_FALSE(std::isfinite(fit.fit.estimates[2].error));
  EXPECT_NEAR(fit.wall_coefficient->value / (4.0 * 0.274 * 0.269 / 0.731), 1.0, 0.05);
  EXPECT_TRUE(std::isfinite(fit.wall_coefficient->error));
}

TEST(WallSupportFit, RecoversAStiffeningBed) {
  auto truth = toy();
  truth.modulus = PowerModulus{0.164e6, 0.05, 1.7};
  auto start = toy();
  start.modulus = PowerModulus{0.1e6, 0.05, 1.2};

  const auto fit = fit_wall_support(start, measured(truth, 0.0, 1, 4),
                                    fitting({BedParameter::modulus, BedParameter::bead_diameter,
                                             BedParameter::wall_friction, BedParameter::exponent}));

  EXPECT_NEAR(fit.fit.estimates[0].value / 0.164e6, 1.0, 1e-4);
  EXPECT_NEAR(fit.fit.estimates[3].value / 1.7, 1.0, 1e-4);
}

// 200 trials with 1 % noise; 182 as in curve_fit_test. Every trial starts at a bed that is off by factors of 2.
TEST(WallSupportFit, ItsIntervalsHoldTheTruth) {
  auto start = toy();
  start.modulus = ConstantModulus{0.3e6};
  start.diameter = 80e-6;
  start.wall_friction = 0.14;
  auto options =
      fitting({BedParameter::modulus, BedParameter::bead_diameter, BedParameter::wall_friction});
  options.starts = 1;
  const std::array truth{0.164e6, 61.958e-6, 0.274};
  std::array<int, 3> inside{};
  for (std::uint64_t trial = 1; trial <= 200; ++trial) {
    const auto fit = fit_wall_support(start, measured(toy(), 0.01, trial, 3), options);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& e = fit.fit.estimates[k];
      if (e.low <= truth[k] && truth[k] <= e.high) ++inside[k];
    }
  }
  for (std::size_t k = 0; k < 3; ++k) EXPECT_GE(inside[k], 182) << k;
  RecordProperty("inside", testing::PrintToString(inside));
}

TEST(WallSupportFit, RefusesWhatCannotBeFitted) {
  const auto data = measured(toy(), 0.0, 1);
  EXPECT_THAT(
      test::message_of([&] { fit_wall_support(toy(), data, fitting({BedParameter::exponent})); }),
      HasSubstr("only be fitted with a stiffening bed"));
  EXPECT_THAT(test::message_of([&] { fit_wall_support(toy(), data, fitting({})); }),
              HasSubstr("no parameter is free"));
  const std::vector<ColumnDatum> one(data.begin(), data.begin() + 1);
  EXPECT_THAT(test::message_of([&] {
                fit_wall_support(toy(), one,
                                 fitting({BedParameter::modulus, BedParameter::bead_diameter,
                                          BedParameter::wall_friction, BedParameter::eps0,
                                          BedParameter::poisson}));
              }),
              HasSubstr("2 rows of data for 5 parameters"));
}

TEST(WallSupportFit, SaysWhereTheBestFitHasNoSteadyState) {
  // The 9.6 mm column ran to 2763 cm/h (thesis section 7.2.2): a constant modulus at the calibrated size cannot.
  std::vector<ColumnDatum> data = measured(toy(), 0.0, 1);
  data.push_back({.diameter = 9.6e-3,
                  .velocity = 2763 * cm_h,
                  .height = 31e-3,
                  .gradient = 37e5,
                  .compression = 0.12,
                  .gradient_error = 1e7,
                  .compression_error = 1.0});
  EXPECT_THROW(fit_wall_support(toy(), data, fitting({BedParameter::modulus})), DivergenceError);
}

}  // namespace
}  // namespace packbed::study
