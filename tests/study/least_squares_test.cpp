// SPDX-License-Identifier: BSD-3-Clause
#include "study/least_squares.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/message_of.hpp"

namespace packbed::study {
namespace {

using testing::ElementsAre;
constexpr double inf = std::numeric_limits<double>::infinity();

// y = a + b x on x = 0..n-1; parameters in the order a, b.
FitProblem line(const std::vector<double>& y, double low = -inf, double high = inf) {
  FitProblem problem;
  problem.parameters = {{"a", 0.5, low, high}, {"b", 0.5, -inf, inf}};
  problem.rows = y.size();
  problem.residuals = [y](std::span<const double> p, std::span<double> r) {
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = p[0] + p[1] * static_cast<double>(i) - y[i];
  };
  return problem;
}

// The closed form of linear regression on 5 points: x mean 2, Sxx 10. y = 1, 3, 2, 5, 4: b = 0.8, a = 1.4,
// S = 3.6, s^2 = 1.2, se(b) = sqrt(0.12), se(a) = sqrt(1.2 (1/5 + 4/10)), corr = -2 / sqrt(6).
TEST(LeastSquares, OfALineIsLinearRegression) {
  const auto fit = least_squares(line({1, 3, 2, 5, 4}));

  EXPECT_TRUE(fit.converged);
  // 1e-7: where the search stops, with a gradient by differences
  EXPECT_NEAR(fit.estimates[0].value, 1.4, 1e-7);
  EXPECT_NEAR(fit.estimates[1].value, 0.8, 1e-7);
  EXPECT_NEAR(fit.estimates[0].error, std::sqrt(0.72), 1e-8);
  EXPECT_NEAR(fit.estimates[1].error, std::sqrt(0.12), 1e-8);
  EXPECT_NEAR(fit.correlation[1], -2.0 / std::sqrt(6.0), 1e-8);
  // Student's t at 97.5 % with 3 degrees of freedom is 3.182446.
  EXPECT_NEAR(fit.estimates[1].high - 0.8, 3.182446 * std::sqrt(0.12), 1e-6);
}

TEST(LeastSquares, StaysWithinItsBoundsAndSaysSo) {
  const auto fit = least_squares(line({1, 3, 2, 5, 4}, 0.0, 1.0));

  EXPECT_NEAR(fit.estimates[0].value, 1.0, 1e-3);
  EXPECT_TRUE(fit.estimates[0].at_bound);
  EXPECT_FALSE(fit.estimates[1].at_bound);
  EXPECT_NEAR(fit.estimates[1].value, 28.0 / 30.0, 2e-3);  // sum x (y - 1) / sum x^2
}

TEST(LeastSquares, TellsWhichParametersTheDataCannotTellApart) {
  FitProblem problem;
  problem.parameters = {
      {"mu", 0.4, 1e-3, 10.0, true}, {"c", 1.0, -inf, inf}, {"k", 0.9, 1e-3, 10.0, true}};
  problem.rows = 6;
  problem.residuals = [](std::span<const double> p, std::span<double> r) {
    for (std::size_t i = 0; i < r.size(); ++i) {
      const auto x = static_cast<double>(i);
      r[i] = p[1] + p[0] * p[2] * x * x - (2.0 + 0.6 * x * x);
    }
  };

  const auto fit = least_squares(problem);

  ASSERT_EQ(fit.confounded.size(), 1U);
  EXPECT_THAT(fit.confounded[0].names, ElementsAre("mu", "k"));
  EXPECT_EQ(fit.estimates[0].error, inf);
  EXPECT_NEAR(fit.estimates[1].value, 2.0, 1e-6);
  EXPECT_NEAR(fit.estimates[0].value * fit.estimates[2].value, 0.6, 1e-6);
}

TEST(LeastSquares, PropagatesErrors) {  // to 2 b: twice the error of b
  const auto fit = least_squares(line({1, 3, 2, 5, 4}));
  const auto twice = derived(fit, "2b", [](std::span<const double> p) { return 2.0 * p[1]; });
  EXPECT_NEAR(twice.value, 1.6, 1e-8);
  EXPECT_NEAR(twice.error, 2.0 * std::sqrt(0.12), 1e-8);
  // at x = 2, the mean, the line is known best: s / sqrt(5)
  const auto middle =
      derived(fit, "m", [](std::span<const double> p) { return p[0] + 2.0 * p[1]; });
  EXPECT_NEAR(middle.error, std::sqrt(1.2 / 5.0), 1e-8);
}

TEST(LeastSquares, TakesTheBestOfItsStarts) {
  // Two valleys: the deeper one at 2, the other near -2.
  FitProblem problem;
  problem.parameters = {{"x", 0.0, -10.0, 10.0}};
  problem.rows = 2;
  problem.residuals = [](std::span<const double> p, std::span<double> r) {
    r[0] = p[0] * p[0] - 4.0;
    r[1] = 0.1 * (p[0] - 2.0);
  };
  const auto best = least_squares(problem, {{-3.0}, {3.0}, {1.0}});
  EXPECT_NEAR(best.fit.estimates[0].value, 2.0, 1e-6);
  EXPECT_EQ(best.starts, 3);
  EXPECT_EQ(best.agreeing, 2);
}

TEST(LeastSquares, NeedsMoreRowsThanParameters) {
  EXPECT_EQ(test::message_of([] {
              least_squares(line({1, 2}));
            }),
            "2 rows of data for 2 parameters; at least 3 rows are needed, or a model with fewer "
            "parameters");
}

TEST(Amplitudes, SolveTheLinearPart) {
  const std::vector<double> x{0, 1, 2, 3, 4};
  const auto a = amplitudes({std::vector<double>(5, 1.0), x}, std::vector<double>{1, 3, 2, 5, 4});
  EXPECT_NEAR(a.values[0], 1.4, 1e-12);
  EXPECT_NEAR(a.values[1], 0.8, 1e-12);
  EXPECT_NEAR(a.sum_of_squares, 3.6, 1e-12);
}

}  // namespace
}  // namespace packbed::study
