// SPDX-License-Identifier: BSD-3-Clause
#include "dem/cloud_room.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace packbed::dem {
namespace {

Domain sides_of(const mesh::Slice& slice) {
  return {.low = {-0.5 * slice.inner_diameter, -0.5 * slice.depth, 0.0},
          .size = {slice.inner_diameter, slice.depth, 0.0},
          .periodic = {false, true, false}};
}

Domain sides_of(const mesh::Cylinder& cylinder) {
  const double d = cylinder.inner_diameter;
  return {.low = {-0.5 * d, -0.5 * d, 0.0}, .size = {d, d, 0.0}, .periodic = {}};
}

Domain sides_of(const mesh::Box& box) {
  Domain sides{.low = {}, .size = {box.size[0], box.size[1], 0.0}, .periodic = {}};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (box.boundaries[axis] == mesh::Boundary::open) {
      throw ValueError(
          "a cloud of beads needs walls or periodic sides in x and y; this box is open there");
    }
    sides.periodic[axis] = box.boundaries[axis] == mesh::Boundary::periodic;
  }
  return sides;
}

void clamp(double& x, double low, double size, double radius) {
  x = std::min(std::max(x, low + radius), low + size - radius);
}

}  // namespace

double Room::width() const { return std::min(sides.size[0], sides.size[1]); }

Room room_of(const mesh::ColumnShape& shape, double low) {
  return {.sides = std::visit([](const auto& s) { return sides_of(s); }, shape),
          .round = std::holds_alternative<mesh::Cylinder>(shape),
          .area = mesh::cross_section(shape),
          .low = low,
          .high = low};
}

Vec3 inside(const Room& room, Vec3 x, double radius) {
  const auto& s = room.sides;
  clamp(x.z, room.low, room.high - room.low, radius);
  if (room.round) {
    const double reach = 0.5 * s.size[0] - radius;
    const double r = std::hypot(x.x, x.y);
    if (r > reach) {
      x.x *= reach / r;
      x.y *= reach / r;
    }
    return x;
  }
  if (!s.periodic[0]) clamp(x.x, s.low[0], s.size[0], radius);
  if (!s.periodic[1]) clamp(x.y, s.low[1], s.size[1], radius);
  return x;
}

Vec3 wrapped(const Room& room, Vec3 x) {
  const auto& s = room.sides;
  if (s.periodic[0]) x.x -= std::floor((x.x - s.low[0]) / s.size[0]) * s.size[0];
  if (s.periodic[1]) x.y -= std::floor((x.y - s.low[1]) / s.size[1]) * s.size[1];
  return x;
}

}  // namespace packbed::dem
