// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/settled_porosity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace packbed::column {
namespace {

constexpr std::array frictions = {0.0, 0.01, 0.02, 0.04, 0.07, 0.1, 0.2, 0.5, 1.0};
constexpr std::array rolling_frictions = {0.0, 0.1, 0.35};
// One row per rolling friction.
constexpr double measured[3][9] = {{0.36, 0.37, 0.375, 0.38, 0.39, 0.395, 0.40, 0.405, 0.41},
                                   {0.36, 0.37, 0.375, 0.38, 0.39, 0.40, 0.41, 0.42, 0.43},
                                   {0.36, 0.37, 0.375, 0.38, 0.39, 0.40, 0.41, 0.42, 0.43}};

/// Place of x in a table: a row and the share of the next one.
template <std::size_t n>
std::pair<std::size_t, double> place(const std::array<double, n>& table, double x) {
  std::size_t k = 0;
  while (k + 2 < n && x >= table[k + 1]) ++k;
  return {k, std::clamp((x - table[k]) / (table[k + 1] - table[k]), 0.0, 1.0)};
}

double along(const double (&row)[9], std::size_t k, double share) {
  return (1.0 - share) * row[k] + share * row[k + 1];
}

}  // namespace

double settled_porosity(double friction, double rolling_friction) {
  const auto [k, share] = place(frictions, friction);
  const auto [r, part] = place(rolling_frictions, rolling_friction);
  return (1.0 - part) * along(measured[r], k, share) + part * along(measured[r + 1], k, share);
}

double settling_friction(double porosity, double rolling_friction) {
  double low = frictions.front(), high = frictions.back();
  for (int n = 0; n < 50; ++n) {
    const double middle = 0.5 * (low + high);
    (settled_porosity(middle, rolling_friction) < porosity ? low : high) = middle;
  }
  return high;
}

}  // namespace packbed::column
