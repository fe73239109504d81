// SPDX-License-Identifier: BSD-3-Clause
#include "core/exact_sum.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace packbed {
namespace {

constexpr int bits = 60;
constexpr int limb = 40;
constexpr int smallest_exponent = -900;  // so that 1 / unit is finite

}  // namespace

ExactSums::ExactSums(std::size_t count, double largest)
    : sums_(count, 0),
      exponent_((largest > 0.0 ? std::max(std::ilogb(largest) + 1, smallest_exponent) : 0) - bits),
      to_integer_(std::ldexp(1.0, -exponent_)) {}

std::vector<double> ExactSums::totals(const Ranks& ranks) const {
  const Wide low_mask = (Wide{1} << limb) - 1;
  std::vector<std::int64_t> limbs;
  limbs.reserve(2 * sums_.size());
  for (const Wide sum : sums_) {
    limbs.push_back(static_cast<std::int64_t>(sum & low_mask));
    limbs.push_back(static_cast<std::int64_t>(sum >> limb));
  }
  ranks.sum(limbs);
  std::vector<double> totals(sums_.size());
  for (std::size_t k = 0; k < totals.size(); ++k) {
    const Wide total = (static_cast<Wide>(limbs[2 * k + 1]) << limb) + limbs[2 * k];
    totals[k] = std::ldexp(static_cast<double>(total), exponent_);
  }
  return totals;
}

double order_independent_sum(std::span<const double> terms, const Ranks& ranks) {
  double largest = 0.0;
  for (const double term : terms) {
    const double size = std::abs(term);
    largest =
        std::isfinite(size) ? std::max(largest, size) : std::numeric_limits<double>::quiet_NaN();
    if (std::isnan(largest)) break;
  }
  largest = ranks.max(largest);
  if (std::isnan(largest)) return largest;
  if (largest == 0.0) return 0.0;

  ExactSums sum(1, largest);
  for (const double term : terms) sum.add(0, term);
  return sum.totals(ranks)[0];
}

}  // namespace packbed
