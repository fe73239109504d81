// SPDX-License-Identifier: BSD-3-Clause
#include "core/exact_sum.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace packbed {

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

  __extension__ using Wide = __int128;
  constexpr int bits = 60;
  constexpr int limb = 40;
  const int exponent = std::ilogb(largest) + 1;  // largest < 2^exponent
  Wide sum = 0;
  for (const double term : terms) {
    sum += static_cast<Wide>(std::llrint(std::ldexp(term, bits - exponent)));
  }
  const Wide low_mask = (Wide{1} << limb) - 1;
  std::array<std::int64_t, 2> limbs = {static_cast<std::int64_t>(sum & low_mask),
                                       static_cast<std::int64_t>(sum >> limb)};
  ranks.sum(limbs);
  const Wide total = (static_cast<Wide>(limbs[1]) << limb) + limbs[0];
  return std::ldexp(static_cast<double>(total), exponent - bits);
}

}  // namespace packbed
