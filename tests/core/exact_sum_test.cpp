// SPDX-License-Identifier: BSD-3-Clause
#include "core/exact_sum.hpp"

#include <array>
#include <limits>

#include <gtest/gtest.h>

namespace packbed {
namespace {

const auto alone = Ranks::alone();

TEST(ExactSum, DoesNotDependOnTheOrder) {
  const std::array<double, 4> terms = {1.0, 1e-17, 1e-17, -1.0 / 3.0};
  const std::array<double, 4> others = {1e-17, -1.0 / 3.0, 1.0, 1e-17};
  EXPECT_EQ(order_independent_sum(terms, alone), order_independent_sum(others, alone));
  EXPECT_NEAR(order_independent_sum(terms, alone), 2.0 / 3.0,
              2.3e-16);  // two roundings
}

TEST(ExactSum, TakesTermsOfAnySize) {
  EXPECT_EQ(order_independent_sum(std::array{3e300, -3e300, 1e300}, alone), 1e300);
  EXPECT_EQ(order_independent_sum(std::array{1e-310}, alone), 0.0);  // finest unit 2^-960
  EXPECT_EQ(order_independent_sum(std::array{3e-250, 1e-250}, alone), 4e-250);
  EXPECT_TRUE(std::isnan(
      order_independent_sum(std::array{1.0, std::numeric_limits<double>::quiet_NaN()}, alone)));
}

TEST(ExactSums, KeepTheirTermsApart) {
  ExactSums sums(3, 2.0);
  for (int k = 0; k < 1000; ++k) {
    sums.add(0, 0.1);
    sums.add(2, k % 2 == 0 ? 2.0 : -2.0);
  }
  const auto totals = sums.totals(alone);
  EXPECT_NEAR(totals[0], 100.0, 1e-13);
  EXPECT_EQ(totals[1], 0.0);
  EXPECT_EQ(totals[2], 0.0);
}

}  // namespace
}  // namespace packbed
