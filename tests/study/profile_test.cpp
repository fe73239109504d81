// SPDX-License-Identifier: BSD-3-Clause
#include "study/profile.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "study/curve_fit.hpp"
#include "tests/support/noise.hpp"

namespace packbed::study {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// y = a + b x with noise: the sum of squares is a parabola, and both kinds of interval are the same.
TEST(Profile, OfAStraightLineIsTheLinearInterval) {
  test::Noise deviate(1);
  std::vector<double> y;
  for (int i = 0; i < 40; ++i) y.push_back(3.0 - 0.1 * i + 0.2 * deviate());
  FitProblem problem{
      .parameters = {{"a", 1.0, -infinity, infinity}, {"b", 1.0, -infinity, infinity}},
      .rows = y.size(),
      .residuals = [y](std::span<const double> p, std::span<double> r) {
        for (std::size_t i = 0; i < r.size(); ++i)
          r[i] = p[0] + p[1] * static_cast<double>(i) - y[i];
      }};
  auto fit = least_squares(problem);
  const auto linear = fit.estimates;
  const auto sum = [](std::span<const double> p) { return p[0] + 20.0 * p[1]; };
  auto figure = derived(fit, "sum", sum);
  const auto linear_figure = figure;

  profile_parameters(problem, fit);
  profile_figure(problem, fit, sum, figure);

  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(fit.estimates[k].low, linear[k].low, 2e-3 * linear[k].error);
    EXPECT_NEAR(fit.estimates[k].high, linear[k].high, 2e-3 * linear[k].error);
    EXPECT_EQ(fit.estimates[k].error, linear[k].error);
  }
  EXPECT_NEAR(figure.low, linear_figure.low, 2e-3 * figure.error);
  EXPECT_NEAR(figure.high, linear_figure.high, 2e-3 * figure.error);
}

// The mean of numbers, fitted as its logarithm: S grows by n (p - mean)^2, so the interval is mean -+ t s / sqrt(n),
// and not symmetric about the logarithm as the linear one is.
TEST(Profile, DoesNotDependOnTheVariableOfTheFit) {
  const std::vector<double> y{0.4, 2.1, 0.9, 1.6, 0.2, 1.4};
  FitProblem problem{.parameters = {{"mean", 1.0, 1e-6, 1e3, true}},
                     .rows = y.size(),
                     .residuals = [y](std::span<const double> p, std::span<double> r) {
                       for (std::size_t i = 0; i < r.size(); ++i) r[i] = p[0] - y[i];
                     }};
  auto fit = least_squares(problem);
  double s2 = 0.0;
  for (const double v : y) s2 += (v - 1.1) * (v - 1.1) / 5.0;
  const double half = 2.570582 * std::sqrt(s2 / 6.0);  // Student's t, 5 degrees

  profile_parameters(problem, fit);

  EXPECT_NEAR(fit.estimates[0].low, 1.1 - half, 2e-3 * half);
  EXPECT_NEAR(fit.estimates[0].high, 1.1 + half, 2e-3 * half);
}

// Only the product of two parameters is known: that with the nearer bounds is open on both sides, the
// product is not.
TEST(Profile, IsOpenWhereTheDataSetNoLimit) {
  const std::vector<double> y{5.9, 6.2, 6.0, 5.8, 6.1};
  FitProblem problem{.parameters = {{"a", 2.0, 1.0, 10.0, true}, {"b", 3.0, 0.01, 100.0, true}},
                     .rows = y.size(),
                     .residuals = [y](std::span<const double> p, std::span<double> r) {
                       for (std::size_t i = 0; i < r.size(); ++i) r[i] = p[0] * p[1] - y[i];
                     }};
  auto fit = least_squares(problem);
  const auto product = [](std::span<const double> p) { return p[0] * p[1]; };
  auto figure = derived(fit, "product", product);

  profile_parameters(problem, fit);
  profile_figure(problem, fit, product, figure);

  EXPECT_EQ(fit.estimates[0].low, -infinity);
  EXPECT_EQ(fit.estimates[0].high, infinity);
  const double half = 3.182446 * std::sqrt(0.1 / 3.0 / 5.0);  // t of 3 degrees; sum of squares 0.1
  EXPECT_NEAR(figure.low, 6.0 - half, 5e-3 * half);
  EXPECT_NEAR(figure.high, 6.0 + half, 5e-3 * half);
}

// SEP at 4 um of table 6.3: tau_1 = 13.79 s is longer than the data (10 s). A drift of the force to a far B0 is then
// as good an answer: B0 has no lower limit, tau_1 no upper one, and the linear interval of tau_1 says otherwise. The
// trial is the first of the 200 of docs/verification.md.
TEST(Profile, IsOpenWhereATimeIsLongerThanTheData) {
  const std::vector<double> truth{82.22e-6, 4.95e-6, 13.79, 0.99e-6, 0.51};
  std::vector<double> time, force;
  test::Noise deviate(1);
  for (int i = 0; i < 300; ++i) {
    const double t = 10.0 * i / 299;
    time.push_back(t);
    force.push_back(truth[0] + truth[1] * std::exp(-t / truth[2]) +
                    truth[3] * std::exp(-t / truth[4]));
  }
  const double noise = 0.01 * force[0];
  for (auto& f : force) f += noise * deviate();
  auto fit = fit_prony_terms(time, force, 2);

  profile_parameters(fit.problem, fit.fit);

  const auto& e = fit.fit.estimates;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    EXPECT_LE(e[k].low, truth[k]) << k;
    EXPECT_GE(e[k].high, truth[k]) << k;
  }
  EXPECT_EQ(e[0].low, -infinity);
  EXPECT_LT(e[0].high, 1.1 * truth[0]);  // the force at the end of the data is a limit
  EXPECT_EQ(e[2].high, infinity);
}

}  // namespace
}  // namespace packbed::study
