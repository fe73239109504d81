// SPDX-License-Identifier: BSD-3-Clause
#include "continuum/wall_support/bed_modulus.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::continuum {
namespace {

// The segment [i, i + 1] of ascending values that holds `at`; the last one beyond the end.
std::size_t segment(const std::vector<double>& values, double at) {
  const auto above = std::ranges::upper_bound(values, at) - values.begin();
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - 1, 0, std::ssize(values) - 2));
}

}  // namespace

TabulatedModulus TabulatedModulus::from(const std::vector<double>& compressions,
                                        const std::vector<double>& moduli) {
  TabulatedModulus table;
  table.lambda_ = {0.0};
  table.sigma_ = {0.0};
  for (std::size_t i = 0; i < compressions.size(); ++i) {
    const double sigma = compressions[i] * moduli[i];
    if (!(compressions[i] > table.lambda_.back() && compressions[i] < 1.0)) {
      throw ValueError(fmt::format(
          "row {}: the compression {} must lie above that of the row before, and within (0, 1)",
          i + 1, compressions[i]));
    }
    if (!(sigma > table.sigma_.back())) {
      throw ValueError(
          fmt::format("row {}: the stress compression x modulus = {:.6g} Pa must rise from row to "
                      "row; before it is {:.6g} Pa",
                      i + 1, sigma, table.sigma_.back()));
    }
    table.lambda_.push_back(compressions[i]);
    table.sigma_.push_back(sigma);
  }
  if (table.lambda_.size() < 2) throw ValueError("the table has no rows");
  return table;
}

double TabulatedModulus::slope(double lambda) const {
  const auto i = segment(lambda_, lambda);
  return (sigma_[i + 1] - sigma_[i]) / (lambda_[i + 1] - lambda_[i]);
}

double TabulatedModulus::stress(double lambda) const {
  const auto i = segment(lambda_, lambda);
  return sigma_[i] + slope(lambda) * (lambda - lambda_[i]);
}

double TabulatedModulus::compression(double sigma) const {
  const auto i = segment(sigma_, sigma);
  return lambda_[i] +
         (sigma - sigma_[i]) * (lambda_[i + 1] - lambda_[i]) / (sigma_[i + 1] - sigma_[i]);
}

}  // namespace packbed::continuum
