// SPDX-License-Identifier: BSD-3-Clause
#include "core/random.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace packbed {
namespace {

std::vector<double> numbers(std::uint64_t seed, Stream stream, std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = uniform(seed, stream, i);
  return values;
}

TEST(Uniform, DependsOnSeedStreamAndIndexAlone) {
  EXPECT_EQ(uniform(1, Stream::bead_size, 7), uniform(1, Stream::bead_size, 7));
  EXPECT_NE(uniform(1, Stream::bead_size, 7), uniform(2, Stream::bead_size, 7));
  EXPECT_NE(uniform(1, Stream::bead_size, 7), uniform(1, Stream::bead_position, 7));
  EXPECT_NE(uniform(1, Stream::bead_size, 7), uniform(1, Stream::bead_size, 8));
  EXPECT_NE(uniform(1, Stream::bead_size, 7), uniform(1, Stream::bead_size, 7 + (1ULL << 32U)));
}

// Philox4x32-10 of counter 0 and key 0 starts 6627e8d5 e169c58d (known answers of Random123).
TEST(Uniform, IsPhiloxOfTheCounter) {
  const auto bits = 0x6627e8d5e169c58dULL >> 12U;
  EXPECT_EQ(uniform(0, Stream::bead_size, 0), (static_cast<double>(bits) + 0.5) * 0x1.0p-52);
}

TEST(Uniform, LiesInsideTheUnitInterval) {
  for (const double u : numbers(42, Stream::bead_size, 100000)) {
    EXPECT_TRUE(u > 0.0 && u < 1.0) << u;
  }
}

TEST(Uniform, HasMeanVarianceAndCorrelationOfUniformNumbers) {
  constexpr std::size_t n = 100000;
  const auto u = numbers(42, Stream::bead_size, n);

  double mean = 0.0;
  double square = 0.0;
  double neighbor = 0.0;
  for (std::size_t i = 1; i < n; ++i) {
    mean += u[i] / n;
    square += (u[i] - 0.5) * (u[i] - 0.5) / n;
    neighbor += (u[i] - 0.5) * (u[i - 1] - 0.5) / n;
  }

  // 4 standard errors: sqrt(1/12/n), sqrt(1/180/n), 1/12/sqrt(n); one number of n is left out
  EXPECT_NEAR(mean, 0.5, 4.0 * std::sqrt(1.0 / 12.0 / n) + 1.0 / n);
  EXPECT_NEAR(square, 1.0 / 12.0, 4.0 * std::sqrt(1.0 / 180.0 / n) + 1.0 / n);
  EXPECT_NEAR(neighbor, 0.0, 4.0 / 12.0 / std::sqrt(n));
}

}  // namespace
}  // namespace packbed
