// SPDX-License-Identifier: BSD-3-Clause
// Each distribution against closed forms worked out apart from its code.
#include "resin/size_distribution.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "resin/size_statistics.hpp"
#include "tests/support/message_of.hpp"

namespace packbed::resin {
namespace {

using testing::HasSubstr;

constexpr double um = 1e-6;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double round_off = 1e-12;

double relative(double value, double expected) { return std::abs(value / expected - 1.0); }

// Thesis: CM Sepharose 6FF, table 6.1 and section 7.1.
TEST(TruncatedNormal, OfTheThesisHasItsSauterMean) {
  const auto s = statistics(TruncatedNormal::from(86.9 * um, 16.6 * um, 49.7 * um, 142.7 * um));

  EXPECT_NEAR(s.sauter / um, 93.0, 0.15);  // the thesis prints 93; 93.11 comes out
  // The same integrals by the midpoint rule with 400 000 cells, apart from this code.
  EXPECT_NEAR(s.sauter / um, 93.11115725, 1e-7);
  EXPECT_NEAR(s.mean / um, 87.42109870, 1e-7);
  EXPECT_NEAR(s.volume_mean / um, 90.25525402, 1e-7);
}

TEST(TruncatedNormal, WideRangeHasTheMomentsOfTheNormalDistribution) {
  constexpr double m = 100 * um;
  constexpr double sd = 10 * um;  // the range is 9.9 deviations to each side
  const auto d = TruncatedNormal::from(m, sd, 1 * um, 199 * um);

  EXPECT_LT(relative(d.partial_moment(1, 1.0), m), round_off);
  EXPECT_LT(relative(d.partial_moment(2, 1.0), m * m + sd * sd), round_off);
  EXPECT_LT(relative(d.partial_moment(3, 1.0), m * m * m + 3 * m * sd * sd), round_off);
  EXPECT_LT(relative(d.partial_moment(4, 1.0),
                     std::pow(m, 4) + 6 * m * m * sd * sd + 3 * std::pow(sd, 4)),
            round_off);
}

TEST(TruncatedNormal, HalfOfItHasTheMeanOfTheHalfNormalDistribution) {
  const auto upper = TruncatedNormal::from(50 * um, 5 * um, 50 * um, 150 * um);
  const auto lower = TruncatedNormal::from(50 * um, 5 * um, 1 * um, 50 * um);

  const double shift = 5 * um * std::sqrt(2.0 / std::numbers::pi);
  EXPECT_LT(relative(statistics(upper).mean, 50 * um + shift), round_off);
  // 1e-12 of the lower half lies below 1 um: 9.8 deviations
  EXPECT_LT(relative(statistics(lower).mean, 50 * um - shift), round_off);
}

TEST(TruncatedNormal, FarTailKeepsItsDigits) {
  // 4 deviations out: the mean of the tail is phi(4)/Q(4) = 4.225607 deviations (tables of Mills'
  // ratio: Q(4)/phi(4) = 0.236652).
  const auto s = statistics(TruncatedNormal::from(100 * um, 10 * um, 140 * um, 300 * um));
  EXPECT_NEAR((s.mean - 100 * um) / (10 * um), 1.0 / 0.236652, 1e-5);
}

TEST(TruncatedNormal, RefusesWhatIsNoDistribution) {
  const auto from = [](double m, double sd, double low, double high) {
    return test::message_of([=] { TruncatedNormal::from(m * um, sd * um, low * um, high * um); });
  };
  EXPECT_THAT(from(90, 0, 50, 140), HasSubstr("standard_deviation must be positive"));
  EXPECT_THAT(from(90, 10, 140, 50), HasSubstr("is not below maximum"));
  EXPECT_THAT(from(90, 10, -5, 140), HasSubstr("minimum must be positive"));
  EXPECT_THAT(from(90, 1, 200, 300), HasSubstr("lies between minimum and maximum"));
}

TEST(Lognormal, UncutHasItsClosedForms) {
  constexpr double median = 80 * um;
  constexpr double s = 0.25;
  const auto f = statistics(Lognormal::from(median, std::exp(s), 0.0, infinity));

  EXPECT_LT(relative(f.mean, median * std::exp(0.5 * s * s)), round_off);
  EXPECT_LT(relative(f.median, median), round_off);
  EXPECT_LT(relative(f.sauter, median * std::exp(2.5 * s * s)), round_off);
  EXPECT_LT(relative(f.volume_mean, median * std::exp(1.5 * s * s)), round_off);
  EXPECT_LT(relative(f.standard_deviation, f.mean * std::sqrt(std::exp(s * s) - 1.0)),
            1e-10);  // difference of two moments
  // The volume is log-normal too, with the median moved by 3 s^2; z(90 %) = 1.2815515655446004.
  const double volume_median = median * std::exp(3.0 * s * s);
  EXPECT_LT(relative(f.d50, volume_median), round_off);
  EXPECT_LT(relative(f.d10, volume_median * std::exp(-1.2815515655446004 * s)), round_off);
  EXPECT_LT(relative(f.d90, volume_median * std::exp(1.2815515655446004 * s)), round_off);
}

TEST(Histogram, OfOneBinIsUniform) {
  const double a = 50 * um;
  const double b = 100 * um;
  const std::vector<Bin> bins = {{a, b, 7.0}};
  const auto f = statistics(Histogram::from(bins, Weighting::number));

  EXPECT_LT(relative(f.mean, 0.5 * (a + b)), round_off);
  EXPECT_LT(relative(f.standard_deviation, (b - a) / std::sqrt(12.0)), 1e-10);
  EXPECT_LT(relative(f.sauter,
                     0.75 * (std::pow(b, 4) - std::pow(a, 4)) / (std::pow(b, 3) - std::pow(a, 3))),
            round_off);
  EXPECT_LT(relative(f.d50, std::pow(0.5 * (std::pow(a, 4) + std::pow(b, 4)), 0.25)), round_off);
}

TEST(Histogram, ByVolumeKeepsTheVolumeShares) {
  const std::vector<Bin> bins = {
      {40 * um, 60 * um, 30.0}, {60 * um, 90 * um, 50.0}, {100 * um, 120 * um, 20.0}};
  const auto d = Histogram::from(bins, Weighting::volume);

  const double all = d.partial_moment(3, 1.0);
  EXPECT_NEAR(d.partial_moment(3, 60 * um) / all, 0.3, round_off);
  EXPECT_NEAR(d.partial_moment(3, 95 * um) / all, 0.8, round_off);
  EXPECT_NEAR(d.partial_moment(0, 1.0), 1.0, round_off);
}

TEST(Histogram, ByNumberAndByVolumeAgreeOnTheSameBeads) {
  const std::vector<Bin> number = {{40 * um, 60 * um, 0.7}, {60 * um, 100 * um, 0.3}};
  const auto d = Histogram::from(number, Weighting::number);
  const double first = d.partial_moment(3, 60 * um);
  const double second = d.partial_moment(3, 1.0) - first;
  const std::vector<Bin> volume = {{40 * um, 60 * um, first}, {60 * um, 100 * um, second}};

  const auto same = Histogram::from(volume, Weighting::volume);

  EXPECT_LT(relative(statistics(same).sauter, statistics(d).sauter), round_off);
  EXPECT_LT(relative(statistics(same).mean, statistics(d).mean), round_off);
}

TEST(Histogram, RefusesBadBinsNamingThem) {
  const auto from = [](const std::vector<Bin>& bins) {
    return test::message_of([=] { Histogram::from(bins, Weighting::number); });
  };
  EXPECT_THAT(from({{5e-5, 6e-5, 1}, {5.5e-5, 7e-5, 1}}), HasSubstr("bin 2"));
  EXPECT_THAT(from({{6e-5, 5e-5, 1}}), HasSubstr("bin 1"));
  EXPECT_THAT(from({{0.0, 5e-5, 1}}), HasSubstr("above 0"));
  EXPECT_THAT(from({{5e-5, 6e-5, -1}}), HasSubstr("negative share"));
  EXPECT_THAT(from({{5e-5, 6e-5, 0}}), HasSubstr("no bin has a positive share"));
  EXPECT_THAT(from({}), HasSubstr("no bin"));
}

TEST(Measured, DiametersHaveTheirOwnSums) {
  const std::vector<double> diameters = {3 * um, 1 * um, 2 * um, 4 * um};
  const auto f = statistics(Measured::from(diameters));

  EXPECT_LT(relative(f.mean, 2.5 * um), round_off);
  EXPECT_LT(relative(f.sauter, (1.0 + 8 + 27 + 64) / (1.0 + 4 + 9 + 16) * um), round_off);
  EXPECT_EQ(f.median, 2 * um);  // half of the beads are not larger
  // shares of volume up to 1, 2, 3, 4 um: 1, 9, 36, 100 %
  EXPECT_LT(relative(f.d10, 3 * um), round_off);
  EXPECT_LT(relative(f.d90, 4 * um), round_off);
  EXPECT_EQ(f.smallest, 1 * um);
  EXPECT_EQ(f.largest, 4 * um);
}

TEST(Measured, RefusesNothingAndNegativeDiameters) {
  EXPECT_THAT(test::message_of([] { Measured::from({}); }), HasSubstr("there is no diameter"));
  const std::vector<double> negative = {1e-5, -1e-5};
  EXPECT_THAT(test::message_of([&] { Measured::from(negative); }), HasSubstr("not positive"));
}

}  // namespace
}  // namespace packbed::resin
