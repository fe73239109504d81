// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/column_shape.hpp"

#include <cmath>
#include <numbers>

namespace packbed::mesh {
namespace {

double disc(double diameter) { return 0.25 * std::numbers::pi * diameter * diameter; }

bool inside(const Slice& slice, const std::array<double, 3>& p) {
  return std::abs(p[0]) <= 0.5 * slice.inner_diameter && std::abs(p[1]) <= 0.5 * slice.depth &&
         p[2] >= 0.0 && p[2] <= slice.height;
}

bool inside(const Cylinder& cylinder, const std::array<double, 3>& p) {
  return std::hypot(p[0], p[1]) <= 0.5 * cylinder.inner_diameter && p[2] >= 0.0 &&
         p[2] <= cylinder.height;
}

bool inside(const Box& box, const std::array<double, 3>& p) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (box.boundaries[axis] == Boundary::open) continue;
    if (p[axis] < 0.0 || p[axis] > box.size[axis]) return false;
  }
  return true;
}

double area(const Slice& slice) { return slice.inner_diameter * slice.depth; }
double area(const Cylinder& cylinder) { return disc(cylinder.inner_diameter); }
double area(const Box& box) { return box.size[0] * box.size[1]; }

}  // namespace

double cross_section(const ColumnShape& shape) {
  return std::visit([](const auto& s) { return area(s); }, shape);
}

double flow_cross_section(const ColumnShape& shape) {
  if (const auto* slice = std::get_if<Slice>(&shape)) return disc(slice->inner_diameter);
  return cross_section(shape);
}

double height(const ColumnShape& shape) {
  if (const auto* box = std::get_if<Box>(&shape)) return box->size[2];
  if (const auto* slice = std::get_if<Slice>(&shape)) return slice->height;
  return std::get<Cylinder>(shape).height;
}

bool contains(const ColumnShape& shape, const std::array<double, 3>& point) {
  return std::visit([&](const auto& s) { return inside(s, point); }, shape);
}

}  // namespace packbed::mesh
