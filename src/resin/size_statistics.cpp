// SPDX-License-Identifier: BSD-3-Clause
#include "resin/size_statistics.hpp"

#include <cmath>

#include <boost/math/tools/roots.hpp>

#include "core/random.hpp"

namespace packbed::resin {
namespace {

// Diameter below which the share p of the bead volume lies: the root of the volume distribution,
// bracketed to 50 bits. Also right where the distribution has steps (measured diameters).
template <class Distribution>
double volume_quantile(const Distribution& d, double p) {
  const double total = d.partial_moment(3, d.largest());
  double low = d.smallest();
  double high = d.largest();
  if (d.partial_moment(3, low) >= p * total) return low;
  const auto excess = [&](double x) { return d.partial_moment(3, x) / total - p; };
  if (!std::isfinite(high)) {
    for (high = d.quantile(0.5); excess(high) < 0.0; high *= 2.0) low = high;
  }
  const auto near_enough = boost::math::tools::eps_tolerance<double>(50);
  return boost::math::tools::bisect(excess, low, high, near_enough).second;
}

template <class Distribution>
SizeStatistics figures(const Distribution& d) {
  const auto moment = [&](int k) { return d.partial_moment(k, d.largest()); };
  const double mean = moment(1);
  return {.smallest = d.smallest(),
          .largest = d.largest(),
          .mean = mean,
          .standard_deviation = std::sqrt(std::max(0.0, moment(2) - mean * mean)),
          .median = d.quantile(0.5),
          .d10 = volume_quantile(d, 0.1),
          .d50 = volume_quantile(d, 0.5),
          .d90 = volume_quantile(d, 0.9),
          .sauter = moment(3) / moment(2),
          .volume_mean = std::cbrt(moment(3))};
}

}  // namespace

SizeStatistics statistics(const SizeDistribution& distribution) {
  return std::visit([](const auto& d) { return figures(d); }, distribution);
}

double smallest(const SizeDistribution& distribution) {
  return std::visit([](const auto& d) { return d.smallest(); }, distribution);
}

double largest(const SizeDistribution& distribution) {
  return std::visit([](const auto& d) { return d.largest(); }, distribution);
}

double sample(const SizeDistribution& distribution, std::uint64_t seed, std::uint64_t index) {
  const double u = uniform(seed, Stream::bead_size, index);
  return std::visit([&](const auto& d) { return d.quantile(u); }, distribution);
}

}  // namespace packbed::resin
