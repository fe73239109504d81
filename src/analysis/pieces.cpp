// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/pieces.hpp"

namespace packbed::analysis {

Side side(const mesh::ColumnShape& shape, Axis axis) {
  const auto k = static_cast<std::size_t>(axis);
  if (const auto* box = std::get_if<mesh::Box>(&shape)) {
    return {{0.0, box->size[k]},
            box->boundaries[k] == mesh::Boundary::periodic,
            box->boundaries[k] == mesh::Boundary::wall};
  }
  if (axis == Axis::z) return {{0.0, mesh::height(shape)}, false, true};
  if (const auto* slice = std::get_if<mesh::Slice>(&shape)) {
    const double half = 0.5 * (axis == Axis::x ? slice->inner_diameter : slice->depth);
    return {{-half, half}, axis == Axis::y, axis == Axis::x};
  }
  const double radius = 0.5 * std::get<mesh::Cylinder>(shape).inner_diameter;
  return {{-radius, radius}, false, true};
}

double area_below(const mesh::ColumnShape& shape, Axis axis, double edge) {
  if (const auto* cylinder = std::get_if<mesh::Cylinder>(&shape)) {
    return disc_area_below(0.5 * cylinder->inner_diameter, edge);
  }
  const Range range = side(shape, axis).range;
  return mesh::cross_section(shape) * (edge - range.low) / (range.high - range.low);
}

}  // namespace packbed::analysis
