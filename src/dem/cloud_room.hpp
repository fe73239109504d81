// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The room that a cloud of beads is packed into: sides of a column, a floor and a lid.

#include "core/vec3.hpp"
#include "dem/domain.hpp"
#include "mesh/column_shape.hpp"

namespace packbed::dem {

struct Room {
  Domain sides;        ///< x and y; z is bounded by low and high
  bool round = false;  ///< a tube around x = y = 0, of diameter sides.size[0]
  double area = 0.0;   ///< of the cross-section [m2]
  double low = 0.0;    ///< [m]
  double high = 0.0;   ///< [m]
  /// Smallest width between two sides [m].
  [[nodiscard]] double width() const;
};

/// Throws ValueError for open sides of a box.
Room room_of(const mesh::ColumnShape& shape, double low);

/// The center nearest to x of a bead of this radius that is inside the walls [m].
Vec3 inside(const Room& room, Vec3 x, double radius);

/// Takes a center back over periodic sides.
Vec3 wrapped(const Room& room, Vec3 x);

}  // namespace packbed::dem
