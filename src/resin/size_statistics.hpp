// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Figures of a size distribution, and diameters drawn from it.

#include <cstdint>
#include <vector>

#include "resin/size_distribution.hpp"

namespace packbed::resin {

/// Exact figures of a distribution, all in m.
struct SizeStatistics {
  double smallest;
  double largest;
  double mean;                ///< of the number
  double standard_deviation;  ///< of the number
  double median;              ///< of the number
  double d10, d50, d90;  ///< of the volume: 10, 50, 90 % of the bead volume is in smaller beads
  double sauter;         ///< d32 = <d^3> / <d^2>, thesis eq. 3.58
  double volume_mean;    ///< d30 = <d^3>^(1/3): the bead of mean volume
};

SizeStatistics statistics(const SizeDistribution& distribution);

double smallest(const SizeDistribution& distribution);
double largest(const SizeDistribution& distribution);

/// Diameter of bead `index` [m]: the same for any order and number of ranks.
double sample(const SizeDistribution& distribution, std::uint64_t seed, std::uint64_t index);

}  // namespace packbed::resin
