// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Means of the liquid along the column and across it, over its cells. All ranks call; all get the same,
/// independent of the order of cells.

#include <vector>

#include "analysis/bead.hpp"
#include "fluid/fluid.hpp"
#include "mesh/column_shape.hpp"

namespace packbed::column {

/// Mean of the cells between two coordinates, by volume.
struct LiquidBin {
  double low = 0.0;                   ///< [m]
  double high = 0.0;                  ///< [m]
  double porosity = 0.0;              ///< void fraction that the liquid sees
  double superficial_velocity = 0.0;  ///< downwards, -eps u_z [m/s]
  double pressure = 0.0;              ///< without its hydrostatic part [Pa]
  bool operator==(const LiquidBin&) const = default;
};

/// The layers of the mesh, from the outlet up.
std::vector<LiquidBin> layer_profile(const fluid::Fluid& fluid);

/// Across the column between two heights, `z.low` < `z.high`. A slice and a box: the columns of cells along
/// x. A round column: rings around the axis, equal in width and no wider than a cell of mean size; cells are
/// shared out by parts of them.
std::vector<LiquidBin> cross_profile(const fluid::Fluid& fluid,
                                     const mesh::ColumnShape& shape,
                                     const analysis::Range& z);

}  // namespace packbed::column
