// SPDX-License-Identifier: BSD-3-Clause
#include "resin/size_distribution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/special_functions/binomial.hpp>
#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::resin {
namespace {

constexpr double least_share = 1e-6;  // less of a curve is a slip of the user, not a distribution
constexpr int highest_moment = 4;

double density(double z) { return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi); }

// Share of the standard normal distribution in [a, b], without cancellation in the upper tail.
double normal_share(double a, double b) {
  if (a > 0.0) return normal_share(-b, -a);
  const auto below = [](double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); };
  return below(b) - below(a);
}

// z with the share u of [a, b] below it.
double normal_quantile(double a, double b, double u) {
  if (a > 0.0) return -normal_quantile(-b, -a, 1.0 - u);
  const double below_a = 0.5 * std::erfc(-a / std::numbers::sqrt2);
  const double p = below_a + u * normal_share(a, b);
  if (p <= 0.0) return a;
  if (p >= 1.0) return b;
  return std::clamp(boost::math::quantile(boost::math::normal(), p), a, b);
}

void check_range(double minimum, double maximum) {
  if (!(minimum < maximum)) {
    throw ValueError(fmt::format("minimum = {:.6g} um is not below maximum = {:.6g} um",
                                 1e6 * minimum, 1e6 * maximum));
  }
}

void check_share(double share) {
  if (!(share >= least_share)) {
    throw ValueError(fmt::format(
        "a share of only {:.1e} of the distribution lies between minimum and maximum", share));
  }
}

}  // namespace

double Monodisperse::partial_moment(int k, double x) const {
  return x >= diameter ? std::pow(diameter, k) : 0.0;
}

double Monodisperse::quantile(double /*u*/) const { return diameter; }

TruncatedNormal TruncatedNormal::from(double mean,
                                      double standard_deviation,
                                      double minimum,
                                      double maximum) {
  if (!(standard_deviation > 0.0)) throw ValueError("standard_deviation must be positive");
  if (!(minimum > 0.0)) throw ValueError("minimum must be positive");
  check_range(minimum, maximum);
  TruncatedNormal d;
  d.mean_ = mean;
  d.sd_ = standard_deviation;
  d.minimum_ = minimum;
  d.maximum_ = maximum;
  d.share_ = normal_share((minimum - mean) / d.sd_, (maximum - mean) / d.sd_);
  check_share(d.share_);
  return d;
}

double TruncatedNormal::partial_moment(int k, double x) const {
  if (x <= minimum_) return 0.0;
  const double a = (minimum_ - mean_) / sd_;
  const double b = (std::min(x, maximum_) - mean_) / sd_;
  // m[j] = integral of z^j phi(z) from a to b, by parts:
  // m[j] = (j - 1) m[j-2] - (b^(j-1) phi(b) - a^(j-1) phi(a))
  std::array<double, highest_moment + 1> m{};
  m[0] = normal_share(a, b);
  m[1] = density(a) - density(b);
  for (int j = 2; j <= k; ++j) {
    const auto i = static_cast<std::size_t>(j);
    m[i] = (j - 1) * m[i - 2] - (std::pow(b, j - 1) * density(b) - std::pow(a, j - 1) * density(a));
  }
  double sum = 0.0;
  for (int j = 0; j <= k; ++j) {
    const double choose = boost::math::binomial_coefficient<double>(static_cast<unsigned>(k),
                                                                    static_cast<unsigned>(j));
    sum += choose * std::pow(mean_, k - j) * std::pow(sd_, j) * m[static_cast<std::size_t>(j)];
  }
  return sum / share_;
}

double TruncatedNormal::quantile(double u) const {
  const double a = (minimum_ - mean_) / sd_;
  const double b = (maximum_ - mean_) / sd_;
  return std::clamp(mean_ + sd_ * normal_quantile(a, b, u), minimum_, maximum_);
}

Lognormal Lognormal::from(double median,
                          double geometric_standard_deviation,
                          double minimum,
                          double maximum) {
  if (!(median > 0.0)) throw ValueError("median must be positive");
  if (!(geometric_standard_deviation > 1.0)) {
    throw ValueError("geometric_standard_deviation must be above 1");
  }
  if (!(minimum >= 0.0)) throw ValueError("minimum must not be negative");
  check_range(minimum, maximum);
  Lognormal d;
  d.log_median_ = std::log(median);
  d.sigma_ = std::log(geometric_standard_deviation);
  d.minimum_ = minimum;
  d.maximum_ = maximum;
  d.share_ = normal_share(d.standardized(minimum), d.standardized(maximum));
  check_share(d.share_);
  return d;
}

double Lognormal::standardized(double x) const { return (std::log(x) - log_median_) / sigma_; }

double Lognormal::partial_moment(int k, double x) const {
  if (x <= minimum_) return 0.0;
  // The k-th moment of a log-normal distribution is that of the same curve moved by k sigma^2.
  const double a = standardized(minimum_) - k * sigma_;
  const double b = standardized(std::min(x, maximum_)) - k * sigma_;
  return std::exp(k * log_median_ + 0.5 * k * k * sigma_ * sigma_) * normal_share(a, b) / share_;
}

double Lognormal::quantile(double u) const {
  const double z = normal_quantile(standardized(minimum_), standardized(maximum_), u);
  return std::clamp(std::exp(log_median_ + sigma_ * z), minimum_, maximum_);
}

Histogram Histogram::from(std::span<const Bin> bins, Weighting weighting) {
  Histogram d;
  double sum = 0.0;
  double end = 0.0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    auto bin = bins[i];
    if (!(bin.lower >= end && bin.lower > 0.0 && bin.upper > bin.lower)) {
      throw ValueError(fmt::format(
          "bin {} from {:.6g} to {:.6g} um: bins must ascend without overlap and start above 0",
          i + 1, 1e6 * bin.lower, 1e6 * bin.upper));
    }
    if (!(bin.share >= 0.0)) {
      throw ValueError(fmt::format("bin {} has a negative share {}", i + 1, bin.share));
    }
    end = bin.upper;
    if (weighting == Weighting::volume) {
      const double mean_cube =
          (std::pow(bin.upper, 4) - std::pow(bin.lower, 4)) / (4.0 * (bin.upper - bin.lower));
      bin.share /= mean_cube;
    }
    sum += bin.share;
    if (bin.share > 0.0) d.bins_.push_back(bin);
  }
  if (!(sum > 0.0)) throw ValueError("no bin has a positive share");
  for (auto& bin : d.bins_) bin.share /= sum;
  return d;
}

double Histogram::partial_moment(int k, double x) const {
  double sum = 0.0;
  for (const auto& bin : bins_) {
    if (x <= bin.lower) break;
    const double end = std::min(x, bin.upper);
    sum += bin.share / (bin.upper - bin.lower) *
           (std::pow(end, k + 1) - std::pow(bin.lower, k + 1)) / (k + 1);
  }
  return sum;
}

double Histogram::quantile(double u) const {
  for (const auto& bin : bins_) {
    if (u <= bin.share) return bin.lower + (bin.upper - bin.lower) * std::max(u, 0.0) / bin.share;
    u -= bin.share;
  }
  return bins_.back().upper;
}

Measured Measured::from(std::span<const double> diameters) {
  if (diameters.empty()) throw ValueError("there is no diameter");
  Measured d;
  d.diameters_.assign(diameters.begin(), diameters.end());
  std::ranges::sort(d.diameters_);
  if (!(d.diameters_.front() > 0.0)) {
    throw ValueError(
        fmt::format("a diameter of {:.6g} um is not positive", 1e6 * d.diameters_.front()));
  }
  return d;
}

double Measured::partial_moment(int k, double x) const {
  double sum = 0.0;
  for (const double diameter : diameters_) {
    if (diameter > x) break;
    sum += std::pow(diameter, k);
  }
  return sum / static_cast<double>(diameters_.size());
}

double Measured::quantile(double u) const {
  const double n = static_cast<double>(diameters_.size());
  const auto rank = std::clamp(std::ceil(u * n), 1.0, n);
  return diameters_[static_cast<std::size_t>(rank) - 1];
}

}  // namespace packbed::resin
