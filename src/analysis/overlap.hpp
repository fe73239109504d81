// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// How much of a sphere lies in a slab, a round tube, a box. Places are relative to the center of the
/// sphere. Derivations: docs/theory/analysis.md, section 1.

#include <algorithm>
#include <numbers>

#include "analysis/bead.hpp"
#include "core/vec3.hpp"

namespace packbed::analysis {

constexpr double sphere_volume(double radius) {
  return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

/// Volume of a sphere below the plane at height h over its center [m3]:
///   pi/3 (R + h)^2 (2 R - h) for -R <= h <= R
constexpr double volume_below(double radius, double h) {
  const double inside = std::clamp(h, -radius, radius);
  const double depth = radius + inside;
  return std::numbers::pi / 3.0 * depth * depth * (2.0 * radius - inside);
}

/// Volume of a sphere between two parallel planes [m3].
constexpr double volume_in_slab(double radius, const Range& slab) {
  return volume_below(radius, slab.high) - volume_below(radius, slab.low);
}

/// Area that the plane at distance h from the center cuts out of a sphere [m2]: pi (R^2 - h^2).
constexpr double cut_area(double radius, double h) {
  return std::numbers::pi * std::max(0.0, (radius - h) * (radius + h));
}

/// Area of a disc on the side x' <= x of a line at distance x from its center [m2].
double disc_area_below(double radius, double x);

/// Area common to two discs whose centers are `distance` apart [m2].
double disc_in_disc(double radius, double other_radius, double distance);

/// Volume of a sphere inside an endless round tube whose axis passes its center at `distance` [m3].
/// Error below 1e-12 of the sphere's volume for any radii and distance.
double volume_in_cylinder(double radius, double distance, double cylinder_radius);

/// The same between two planes across the tube. Error below 1e-9 of the sphere's volume.
double volume_in_cylinder(double radius,
                          double distance,
                          double cylinder_radius,
                          const Range& slab);

/// Volume of a sphere inside a box whose corners are at `low` and `high` from its center [m3]; corners
/// may be infinite in x and y. Error below 1e-9 of the sphere's volume.
double volume_in_box(double radius, const Vec3& low, const Vec3& high);

}  // namespace packbed::analysis
