// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// How large the voids between beads are, from spheres around random points. One process has all beads.

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/bead.hpp"
#include "mesh/column_shape.hpp"

namespace packbed::analysis {

struct VoidOptions {
  Range z;                       ///< points lie between these heights, low < high [m]
  std::int64_t points = 100000;  ///< in the column, beads included; at least 1
  std::uint64_t seed = 1;
};

/// Of the points that lie in a void: the radius of the largest sphere around the point that no bead and
/// no side wall reaches. The distances of a share q of the points are not larger than the q-quantile.
struct VoidSizes {
  std::int64_t points = 0;  ///< in voids
  double share = 0.0;       ///< of all points: porosity, overlaps counted once
  double error = 0.0;       ///< standard error of it
  double d10 = 0.0;         ///< quantiles [m]: 10 %; 0 without points in voids
  double d50 = 0.0;
  double d90 = 0.0;
  double largest = 0.0;           ///< [m]
  std::vector<double> distances;  ///< of all points in voids, ascending [m]
};

/// Points are the same for the same seed, column and heights (core/random.hpp), so that two states are
/// compared at the same places. `z` should end a bead diameter below the top of the bed: the open space
/// over it is a void too. Bottom and plunger are no side walls. Periodic sides are wrapped. ValueError for
/// no points, empty heights or no beads.
/// The distribution is that of Torquato's nearest-surface distances of the void phase (Torquato, Lu and
/// Rubinstein, Phys. Rev. A 41 (1990) 2059).
VoidSizes void_sizes(std::span<const Bead> beads,
                     const mesh::ColumnShape& shape,
                     const VoidOptions& options);

}  // namespace packbed::analysis
