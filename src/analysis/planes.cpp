// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <numbers>

#include "analysis/overlap.hpp"
#include "analysis/pieces.hpp"
#include "analysis/profile.hpp"
#include "core/exact_sum.hpp"

namespace packbed::analysis {
namespace {

/// Area of the column in a plane across an axis [m2].
double plane_area(const mesh::ColumnShape& shape, Axis axis, double position, const Range& z) {
  if (axis == Axis::z) return mesh::cross_section(shape);
  const double height = z.high - z.low;
  if (const auto* cylinder = std::get_if<mesh::Cylinder>(&shape)) {
    const double radius = 0.5 * cylinder->inner_diameter;
    return 2.0 * std::sqrt(std::max(0.0, (radius - position) * (radius + position))) * height;
  }
  const Range range = side(shape, axis).range;
  return mesh::cross_section(shape) / (range.high - range.low) * height;
}

/// Area that a vertical plane at distance h from the center cuts out of a sphere, between two heights over
/// the center [m2].
double cut_area_between(double radius, double h, const Range& z) {
  const double squared = (radius - h) * (radius + h);
  if (squared <= 0.0) return 0.0;
  const double disc = std::sqrt(squared);
  return disc_area_below(disc, z.high) - disc_area_below(disc, z.low);
}

double largest_cut(std::span<const Bead> beads, const Ranks& ranks) {
  double radius = 0.0;
  for (const auto& bead : beads) radius = std::max(radius, bead.radius);
  return cut_area(ranks.max(radius), 0.0);
}

}  // namespace

std::vector<double> plane_porosities(std::span<const Bead> beads,
                                     const mesh::ColumnShape& shape,
                                     Axis axis,
                                     std::span<const double> positions,
                                     const Range& z,
                                     const Ranks& ranks) {
  const Side here = side(shape, axis);
  ExactSums solid(positions.size(), largest_cut(beads, ranks));
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const Range plane = {positions[k], positions[k]};
    for (const auto& bead : beads) {
      for_images(along(bead.x, axis), bead.radius, here, plane, [&](double shift) {
        const double h = positions[k] - along(bead.x, axis) - shift;
        if (axis == Axis::z) {
          solid.add(k, cut_area(bead.radius, h));
          return;
        }
        for_images(bead.x.z, bead.radius, side(shape, Axis::z), z, [&](double shift_z) {
          const double height = bead.x.z + shift_z;
          solid.add(k, cut_area_between(bead.radius, h, {z.low - height, z.high - height}));
        });
      });
    }
  }
  auto eps = solid.totals(ranks);
  for (std::size_t k = 0; k < eps.size(); ++k) {
    eps[k] = 1.0 - eps[k] / plane_area(shape, axis, positions[k], z);
  }
  return eps;
}

}  // namespace packbed::analysis
