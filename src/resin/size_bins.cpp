// SPDX-License-Identifier: BSD-3-Clause
#include "resin/size_bins.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::resin {
namespace {

constexpr double most_bins = 10000.0;

// Place on the grid of bins; a diameter on an edge, but for round-off, belongs above it.
double place(double diameter, double width) { return std::floor(diameter / width + 1e-9); }

}  // namespace

std::vector<SizeBin> size_bins(std::span<const double> diameters, double width) {
  if (!(width > 0.0)) throw ValueError("the width of a bin must be positive");
  const auto [least, most] = std::ranges::minmax(diameters);
  const double first = place(least, width);
  const double count = place(most, width) - first + 1.0;
  if (count > most_bins) {
    throw ValueError(fmt::format("{:.0f} bins would be needed; take wider ones", count));
  }
  std::vector<SizeBin> bins(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < bins.size(); ++i) {
    bins[i].lower = (first + static_cast<double>(i)) * width;
    bins[i].upper = (first + static_cast<double>(i) + 1.0) * width;
  }
  double cubes = 0.0;
  for (const double d : diameters) cubes += d * d * d;
  for (const double d : diameters) {
    auto& bin = bins[static_cast<std::size_t>(place(d, width) - first)];
    bin.number_share += 1.0 / static_cast<double>(diameters.size());
    bin.volume_share += d * d * d / cubes;
  }
  double number = 0.0;
  double volume = 0.0;
  for (auto& bin : bins) {
    bin.number_below_upper = number += bin.number_share;
    bin.volume_below_upper = volume += bin.volume_share;
  }
  return bins;
}

}  // namespace packbed::resin
