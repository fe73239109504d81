// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

namespace packbed::resin {

/// One interval of a size distribution, [lower, upper).
struct SizeBin {
  double lower = 0.0;               ///< [m]
  double upper = 0.0;               ///< [m]
  double number_share = 0.0;        ///< of all beads
  double volume_share = 0.0;        ///< of the volume of all beads
  double number_below_upper = 0.0;  ///< Q, thesis eq. 3.50
  double volume_below_upper = 0.0;

  /// q = share / width [1/m]. Thesis eq. 3.49.
  [[nodiscard]] double number_density() const { return number_share / (upper - lower); }
  [[nodiscard]] double volume_density() const { return volume_share / (upper - lower); }
};

/// Measured diameters [m] in intervals of `width` that begin at multiples of it (thesis section 5.4.1: 5 um).
/// Throws ValueError unless width is positive, or for more than 10 000 intervals.
std::vector<SizeBin> size_bins(std::span<const double> diameters, double width);

}  // namespace packbed::resin
