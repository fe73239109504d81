// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// A cloud of beads to settle: random, dense, hardly overlapping. Beads start on a jittered lattice
/// with small radii, which grow in stages; after each stage overlaps are pushed apart (Gauss-Seidel
/// on positions, no forces). docs/theory/settling.md, section 1.

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec3.hpp"
#include "mesh/column_shape.hpp"

namespace packbed::dem {

struct CloudOptions {
  /// Gives the sides, which are walls or periodic. Its height does not bound the cloud.
  mesh::ColumnShape shape;
  double low = 0.0;               ///< z below which no bead reaches [m]
  double solid_fraction = 0.5;    ///< to reach; up to 0.5 is quick
  double overlap_limit = 0.01;    ///< largest overlap / smaller diameter
  std::uint64_t seed = 1;         ///< the same seed gives the same cloud
  std::uint64_t first_index = 0;  ///< of the random numbers: bead k takes those of first_index + k
};

struct Cloud {
  std::vector<Vec3> x;           ///< centers, one per diameter, from low to high z [m]
  double high = 0.0;             ///< z above which no bead reaches [m]
  double solid_fraction = 0.0;   ///< reached: lower than asked for where walls are too near for it
  double largest_overlap = 0.0;  ///< of two beads / smaller diameter; beads do not overlap walls
};

/// Places for beads of these diameters [m]. Where they cannot be had at the solid fraction, because
/// walls stand a few diameters apart or the layer is thin, the cloud is made higher. Throws ValueError
/// if a bead does not fit between the sides or a side is open, DivergenceError if beads stay pressed.
/// Depends on nothing but its arguments; about 5 us and 150 B of working memory per bead.
Cloud make_cloud(const CloudOptions& options, std::span<const double> diameters);

}  // namespace packbed::dem
