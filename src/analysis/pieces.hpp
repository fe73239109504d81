// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Beads as profiles take them: images over periodic sides, and what of them lies between two heights.

#include <cmath>
#include <limits>
#include <span>

#include "analysis/bead.hpp"
#include "analysis/overlap.hpp"
#include "analysis/profile.hpp"
#include "mesh/column_shape.hpp"

namespace packbed::analysis {

/// The column along one axis.
struct Side {
  Range range;
  bool periodic = false;
  bool wall = false;
};

Side side(const mesh::ColumnShape& shape, Axis axis);

inline double along(const Vec3& x, Axis axis) {
  return axis == Axis::x ? x.x : axis == Axis::y ? x.y : x.z;
}

/// Area of the cross-section of the column below each edge of a horizontal axis [m2].
double area_below(const mesh::ColumnShape& shape, Axis axis, double edge);

/// Calls visit(shift) for every shift by whole periods that brings part of x - radius..x + radius into
/// the range; without a period for 0 if it is there.
template <class Visit>
void for_images(double x, double radius, const Side& side, const Range& range, const Visit& visit) {
  if (!side.periodic) {
    if (x + radius > range.low && x - radius < range.high) visit(0.0);
    return;
  }
  const double period = side.range.high - side.range.low;
  const auto first = std::lrint(std::ceil((range.low - x - radius) / period));
  const auto last = std::lrint(std::floor((range.high - x + radius) / period));
  for (auto k = first; k <= last; ++k) visit(static_cast<double>(k) * period);
}

/// One image of a bead and what of it lies between two heights.
struct Piece {
  double radius = 0.0;
  Range z;  ///< the heights, over its center
  [[nodiscard]] bool whole() const { return z.low <= -radius && z.high >= radius; }
  [[nodiscard]] double volume() const {
    return whole() ? sphere_volume(radius) : volume_in_slab(radius, z);
  }
  /// Below the vertical plane at distance h from the center.
  [[nodiscard]] double below(double h) const {
    if (whole()) return volume_below(radius, h);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return volume_in_box(radius, {-infinity, -infinity, z.low}, {h, infinity, z.high});
  }
  [[nodiscard]] double in_cylinder(double distance, double cylinder_radius) const {
    if (whole()) return volume_in_cylinder(radius, distance, cylinder_radius);
    return volume_in_cylinder(radius, distance, cylinder_radius, z);
  }
};

/// Calls visit(bead, piece) for every image of a bead that reaches between the heights.
template <class Visit>
void for_pieces(std::span<const Bead> beads,
                const Side& z,
                const Range& range,
                const Visit& visit) {
  for (const auto& bead : beads) {
    for_images(bead.x.z, bead.radius, z, range, [&](double shift) {
      const double height = bead.x.z + shift;
      visit(bead, Piece{bead.radius, {range.low - height, range.high - height}});
    });
  }
}

}  // namespace packbed::analysis
