// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Sums that come out the same in any order and on any number of ranks.

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "core/ranks.hpp"

namespace packbed {

/// Sum of all ranks' terms. Each term is rounded to 2^-60 of the largest one and added as an integer,
/// so nothing depends on the order. NaN if a term is not finite.
double order_independent_sum(std::span<const double> terms, const Ranks& ranks);

/// Many such sums at once, of terms whose largest size is known beforehand: bins of a profile.
class ExactSums {
 public:
  /// No term may be larger than `largest`, which is the same on all ranks; each is rounded to 2^-60 of
  /// it.
  ExactSums(std::size_t count, double largest);

  void add(std::size_t k, double term) {
    sums_[k] += static_cast<Wide>(std::llrint(term * to_integer_));
  }

  /// Of all ranks; all call it.
  [[nodiscard]] std::vector<double> totals(const Ranks& ranks) const;

 private:
  __extension__ using Wide = __int128;
  std::vector<Wide> sums_;
  int exponent_;       ///< of the unit, a power of two
  double to_integer_;  ///< 1 / unit
};

}  // namespace packbed
