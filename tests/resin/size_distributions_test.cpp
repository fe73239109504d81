// SPDX-License-Identifier: BSD-3-Clause
// What must hold for every size distribution, whichever it is.
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include "resin/size_statistics.hpp"

namespace packbed::resin {
namespace {

constexpr double um = 1e-6;

template <class Distribution>
Distribution example();  // a new distribution does not link without one

template <>
Monodisperse example() {
  return {90 * um};
}
template <>
TruncatedNormal example() {
  return TruncatedNormal::from(86.9 * um, 16.6 * um, 49.7 * um, 142.7 * um);
}
template <>
Lognormal example() {
  return Lognormal::from(85 * um, 1.2, 45 * um, 165 * um);
}
template <>
Histogram example() {
  const std::vector<Bin> bins = {
      {50 * um, 70 * um, 1.0}, {70 * um, 80 * um, 3.0}, {90 * um, 120 * um, 2.0}};
  return Histogram::from(bins, Weighting::number);
}
template <>
Measured example() {
  const std::vector<double> diameters = {51 * um, 64 * um, 64 * um, 90 * um, 133 * um};
  return Measured::from(diameters);
}

template <class Variant>
struct AsTypes;
template <class... Distributions>
struct AsTypes<std::variant<Distributions...>>
    : std::type_identity<testing::Types<Distributions...>> {};

template <class Distribution>
class SizeDistributions : public testing::Test {
 protected:
  Distribution distribution = example<Distribution>();
};
TYPED_TEST_SUITE(SizeDistributions, AsTypes<SizeDistribution>::type);

TYPED_TEST(SizeDistributions, HoldsAllBeadsBetweenSmallestAndLargest) {
  const auto& d = this->distribution;
  EXPECT_NEAR(d.partial_moment(0, d.largest()), 1.0, 1e-12);
  EXPECT_EQ(d.partial_moment(0, 0.999 * d.smallest()), 0.0);
  EXPECT_GE(d.quantile(0.0), d.smallest());
  EXPECT_LE(d.quantile(1.0), d.largest());
}

TYPED_TEST(SizeDistributions, QuantileInvertsTheShareOfBeads) {
  const auto& d = this->distribution;
  double before = 0.0;
  for (int percent = 1; percent < 100; ++percent) {
    const double u = 0.01 * percent;
    const double x = d.quantile(u);
    EXPECT_GE(x, before);
    EXPECT_GE(d.partial_moment(0, x), u - 1e-12);              // at most the share u is smaller ...
    EXPECT_LE(d.partial_moment(0, x * (1 - 1e-9)), u + 1e-7);  // ... 1e-9 of d below it: 1e-7 of u
    before = x;
  }
}

// The mean of any power over the quantiles is the moment: int_0^1 q(u)^k du.
TYPED_TEST(SizeDistributions, MomentsAreMeansOverTheQuantiles) {
  const auto& d = this->distribution;
  for (int k = 1; k <= 4; ++k) {
    double mean = 0.0;
    constexpr int cells = 20000;
    for (int i = 0; i < cells; ++i) mean += std::pow(d.quantile((i + 0.5) / cells), k) / cells;

    // 1e-5: a cell that holds a gap between bins or beads is off by up to half its share, 2.5e-5
    // times the relative gap to the k-th power
    EXPECT_NEAR(mean / d.partial_moment(k, d.largest()), 1.0, 1e-5) << "k = " << k;
  }
}

TYPED_TEST(SizeDistributions, FiguresAreInOrder) {
  const auto f = statistics(this->distribution);
  EXPECT_LE(f.smallest, f.d10);
  EXPECT_LE(f.d10, f.d50);
  EXPECT_LE(f.d50, f.d90);
  EXPECT_LE(f.d90, f.largest * (1 + 1e-12));
  EXPECT_LE(f.mean, f.volume_mean * (1 + 1e-12));
  EXPECT_LE(f.volume_mean, f.sauter * (1 + 1e-12));
}

std::vector<double> samples(const SizeDistribution& d, std::uint64_t seed, std::uint64_t count) {
  std::vector<double> x;
  for (std::uint64_t i = 0; i < count; ++i) x.push_back(sample(d, seed, i));
  return x;
}

double mean_power(const std::vector<double>& x, int k) {
  double sum = 0.0;
  for (const double value : x) sum += std::pow(value, k);
  return sum / static_cast<double>(x.size());
}

TYPED_TEST(SizeDistributions, SamplesAreReproducible) {
  const SizeDistribution d = this->distribution;
  EXPECT_EQ(samples(d, 1, 100), samples(d, 1, 100));
}

TYPED_TEST(SizeDistributions, SamplesFollowTheDistribution) {
  const SizeDistribution d = this->distribution;
  const auto f = statistics(d);
  constexpr int n = 20000;
  const auto x = samples(d, 1, n);

  // 4 standard errors; that of the cube is bounded by the range of cubes
  const double cubes = std::pow(f.largest, 3) - std::pow(f.smallest, 3);
  EXPECT_NEAR(mean_power(x, 1), f.mean, 4.0 * f.standard_deviation / std::sqrt(n) + 1e-12 * f.mean);
  EXPECT_NEAR(mean_power(x, 3), std::pow(f.volume_mean, 3),
              4.0 * cubes / std::sqrt(n) + 1e-12 * std::pow(f.mean, 3));
  EXPECT_GE(*std::ranges::min_element(x), f.smallest);
  EXPECT_LE(*std::ranges::max_element(x), f.largest);
}

TYPED_TEST(SizeDistributions, AnotherSeedGivesOtherBeads) {
  const SizeDistribution d = this->distribution;
  if (smallest(d) == largest(d)) return;
  int same = 0;
  for (std::uint64_t i = 0; i < 100; ++i) same += sample(d, 1, i) == sample(d, 2, i) ? 1 : 0;
  EXPECT_LT(same, 60);  // measured diameters repeat by chance: 28 % of five values
}

}  // namespace
}  // namespace packbed::resin
