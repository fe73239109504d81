// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/plateau.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace packbed::column {
namespace {

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

std::optional<double> pressure_noise(const Samples& samples, double from) {
  const auto first =
      static_cast<std::size_t>(std::ranges::lower_bound(samples.time, from) - samples.time.begin());
  const auto times = std::span(samples.time).subspan(first);
  const auto values = std::span(samples.value).subspan(first);
  if (times.size() < fewest_noise_samples) return {};
  const double middle = mean(times);
  const double level = mean(values);
  if (level == 0.0) return {};
  double tt = 0.0;
  double tv = 0.0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    tt += (times[k] - middle) * (times[k] - middle);
    tv += (times[k] - middle) * (values[k] - level);
  }
  const double slope = tv / tt;
  double squares = 0.0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double rest = values[k] - level - slope * (times[k] - middle);
    squares += rest * rest;
  }
  return std::sqrt(squares / static_cast<double>(times.size() - 2)) / std::abs(level);
}

}  // namespace packbed::column
