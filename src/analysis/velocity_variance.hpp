// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// How uneven the axial velocity of the liquid is (thesis eq. 3.65, figs 10.9 and 10.10). The thesis calls
/// its variance a dispersion; it is one of velocities [m2/s2] and not a dispersion coefficient. One process
/// has all cells; they are added in their order.

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/bead.hpp"
#include "mesh/column_shape.hpp"

namespace packbed::analysis {

/// A cell of the mesh.
struct LiquidCell {
  Vec3 x;               ///< center [m]
  double volume = 0.0;  ///< [m3]
  double eps = 0.0;     ///< void fraction
  double u_z = 0.0;  ///< interstitial velocity along z (thesis), or whichever is asked about [m/s]
};

/// How much a cell counts in a mean: 1 as the thesis does, or its volume of liquid, eps V, which does not
/// depend on how the mesh is graded.
enum class CellWeight { one, liquid };

struct VelocityVariance {
  std::int64_t cells = 0;
  double mean = 0.0;       ///< <u_z> [m/s]
  double variance = 0.0;   ///< sigma_z^2 = <(u_z - <u_z>)^2> [m2/s2], thesis eq. 3.65
  double variation = 0.0;  ///< sigma_z / |<u_z>|; 0 where nothing flows
};

/// Of the cells with their centers in z.low <= z < z.high.
VelocityVariance velocity_variance(std::span<const LiquidCell> cells,
                                   const Range& z,
                                   CellWeight weight = CellWeight::one);

/// From a point to the next wall, as in `wall_profile` [m]: of a cylinder the side, of a slice the walls
/// across x, of a box those across x, else those across y; ValueError if it has none.
double wall_distance(const mesh::ColumnShape& shape, const Vec3& x);

/// Cells whose centers are between two distances from the wall.
struct VelocityBin {
  Range distance;  ///< [m]
  std::int64_t cells = 0;
  double mean = 0.0;      ///< <u_z> of the bin [m/s]; 0 without cells
  double relative = 0.0;  ///< over <u_z> of all cells that are `inner` or farther from the wall
};

struct VelocityProfileOptions {
  Range z;                                 ///< centers of cells, low <= z < high [m]
  double inner = 0.0;                      ///< from here on a cell counts in <u_z> [m]; 0: all do
  CellWeight weight = CellWeight::liquid;  ///< of all means
};

/// Between consecutive `edges` (distances from the wall, ascending, at least two): u_z(r) / <u_z> of thesis
/// fig. 10.9.
std::vector<VelocityBin> velocity_profile(std::span<const LiquidCell> cells,
                                          const mesh::ColumnShape& shape,
                                          std::span<const double> edges,
                                          const VelocityProfileOptions& options);

}  // namespace packbed::analysis
