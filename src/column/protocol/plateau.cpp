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

double dot(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

std::optional<double> pressure_noise(const Samples& samples, double from) {
  const auto first =
      static_cast<std::size_t>(std::ranges::lower_bound(samples.time, from) - samples.time.begin());
  const auto times = std::span(samples.time).subspan(first);
  const auto values = std::span(samples.value).subspan(first);
  if (times.size() < fewest_noise_samples) return {};
  const double level = mean(values);
  if (level == 0.0) return {};
  // Orthogonal on the samples: 1, the time from its mean, and its square less what both have of it.
  const auto n = times.size();
  std::vector<double> line(n);
  std::vector<double> bow(n);
  const double middle = mean(times);
  for (std::size_t k = 0; k < n; ++k) line[k] = times[k] - middle;
  for (std::size_t k = 0; k < n; ++k) bow[k] = line[k] * line[k];
  const double flat = mean(bow);
  const double tilt = dot(bow, line) / dot(line, line);
  for (std::size_t k = 0; k < n; ++k) bow[k] -= flat + tilt * line[k];
  std::vector<double> rest(values.begin(), values.end());
  for (auto& v : rest) v -= level;
  for (const auto* shape : {&line, &bow}) {
    const double share = dot(rest, *shape) / dot(*shape, *shape);
    for (std::size_t k = 0; k < n; ++k) rest[k] -= share * (*shape)[k];
  }
  return std::sqrt(dot(rest, rest) / static_cast<double>(n - 3)) / std::abs(level);
}

}  // namespace packbed::column
