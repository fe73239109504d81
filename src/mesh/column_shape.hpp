// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The space that beads and liquid fill. z points up, against gravity; z = 0 is the lower end
/// (outlet frit), z = height the upper one (inlet, plunger).
/// Slice and cylinder have their axis at x = y = 0; a box has a corner at the origin.

#include <array>
#include <variant>

namespace packbed::mesh {

/// Vertical slice through a round column (thesis fig. 5.6): walls at x = +- inner_diameter / 2,
/// periodic in y over `depth`.
struct Slice {
  double inner_diameter;  ///< of the column that it is cut from: its width in x [m]
  double depth;           ///< in y [m]
  double height;          ///< in z [m]
  bool operator==(const Slice&) const = default;
};

/// Round column.
struct Cylinder {
  double inner_diameter;  ///< [m]
  double height;          ///< [m]
  bool operator==(const Cylinder&) const = default;
};

enum class Boundary { periodic, wall, open };

/// Box; each pair of opposite sides is periodic, a wall, or open.
struct Box {
  std::array<double, 3> size;          ///< x, y, z [m]
  std::array<Boundary, 3> boundaries;  ///< x, y, z
  bool operator==(const Box&) const = default;
};

using ColumnShape = std::variant<Slice, Cylinder, Box>;

/// Area across z [m2].
double cross_section(const ColumnShape& shape);

/// Area that turns a flow rate into a superficial velocity [m2]: the full round cross-section for
/// a slice too, since a flow rate is always that of the real column.
double flow_cross_section(const ColumnShape& shape);

/// In z [m].
double height(const ColumnShape& shape);

/// Whether a point [m] is inside or on the border; open sides do not bound.
bool contains(const ColumnShape& shape, const std::array<double, 3>& point);

}  // namespace packbed::mesh
