// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// How far a mesh is from the ideal of a finite-volume scheme. Layers are level and of one height, so
/// all but the aspect ratio is a matter of the cross-section.

#include "mesh/column_mesh.hpp"

namespace packbed::mesh {

struct MeshQuality {
  double largest_non_orthogonality;  ///< angle between delta and area of an inner face [rad]
  double mean_non_orthogonality;     ///< over the inner faces between cells side by side [rad]
  double
      largest_skewness;   ///< distance of the face center from where delta cuts the face / |delta|
  double largest_aspect;  ///< longest / shortest edge of a cell
  double largest_over_smallest;  ///< areas of cells in the cross-section
};

MeshQuality quality(const ColumnMesh& mesh);

}  // namespace packbed::mesh
