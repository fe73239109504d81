// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// How much beads move against each other: 0 in a bed at rest and in one that moves as a whole. One process
/// has all beads; they are added in their order.

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/bead.hpp"

namespace packbed::analysis {

struct MovingBead {
  Vec3 x;  ///< center [m]
  Vec3 v;  ///< [m/s]
};

/// Beads with their centers in z.low <= z < z.high.
struct SlabMotion {
  Range z;  ///< [m]
  std::int64_t beads = 0;
  Vec3 mean;                 ///< mean velocity [m/s]
  double temperature = 0.0;  ///< T = <|v - mean|^2> / 3 [m2/s2]; 0 without beads
};

struct GranularTemperature {
  std::vector<SlabMotion> slabs;
  double mean = 0.0;         ///< of all beads in slabs, each against its slab [m2/s2]
  std::int64_t outside = 0;  ///< beads in no slab
};

/// Between consecutive `edges` (heights, ascending, at least two).
GranularTemperature granular_temperature(std::span<const MovingBead> beads,
                                         std::span<const double> edges);

}  // namespace packbed::analysis
