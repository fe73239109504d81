// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/column_mesh.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "mesh/five_block.hpp"

namespace packbed::mesh {
namespace {

CrossSection section_of(const Slice& slice, const CellCounts& n) {
  const double x = 0.5 * slice.inner_diameter;
  const double y = 0.5 * slice.depth;
  return rectangle_section({-x, -y}, {x, y}, n.x, n.y, {.x = false, .y = true});
}

CrossSection section_of(const Cylinder& cylinder, const CellCounts& n) {
  return five_block_section(0.5 * cylinder.inner_diameter, n.core, n.ring);
}

CrossSection section_of(const Box& box, const CellCounts& n) {
  return rectangle_section(
      {}, {box.size[0], box.size[1]}, n.x, n.y,
      {.x = box.boundaries[0] == Boundary::periodic, .y = box.boundaries[1] == Boundary::periodic});
}

}  // namespace

ColumnMesh::ColumnMesh(const ColumnShape& shape, const CellCounts& counts)
    : section_(std::visit([&](const auto& s) { return section_of(s, counts); }, shape)),
      locator_(section_),
      layers_(counts.layers),
      periodic_z_(false),
      top_(height(shape)),
      slack_(0.01 * std::sqrt(cross_section(shape) / static_cast<double>(counts.per_layer()))) {
  if (const auto* cylinder = std::get_if<Cylinder>(&shape)) {
    radius_ = wall_point_radius(0.5 * cylinder->inner_diameter, counts.core);
  }
  if (const auto* box = std::get_if<Box>(&shape)) {
    periodic_z_ = box->boundaries[2] == Boundary::periodic && layers_ > 1;
  }
}

void ColumnMesh::set_top(double z) {
  assert(z > 0.0 && !periodic_z_);
  top_ = z;
}

double ColumnMesh::volume(std::int64_t cell) const {
  const auto k = static_cast<std::int32_t>(cell / cells_per_layer());
  const auto c = static_cast<std::size_t>(cell % cells_per_layer());
  return section_.area[c] * (level(k + 1) - level(k));
}

Vec3 ColumnMesh::center(std::int64_t cell) const {
  const auto k = static_cast<std::int32_t>(cell / cells_per_layer());
  const auto& p = section_.center[static_cast<std::size_t>(cell % cells_per_layer())];
  return {p.x, p.y, 0.5 * (level(k) + level(k + 1))};
}

std::int32_t ColumnMesh::layer_at(double z) const {
  if (!(z > 0.0)) return 0;
  if (z >= top_) return layers_ - 1;
  auto k = std::min(static_cast<std::int32_t>(z / top_ * layers_), layers_ - 1);
  while (k > 0 && z <= level(k)) --k;
  while (k + 1 < layers_ && z > level(k + 1)) ++k;
  return k;
}

std::int64_t ColumnMesh::nearest_cell(const Vec3& x) const {
  return layer_at(x.z) * cells_per_layer() + locator_.cell_at({x.x, x.y});
}

std::optional<std::int64_t> ColumnMesh::cell_at(const Vec3& x) const {
  const auto within = [&](double a, double low, double high) {
    return a >= low - slack_ && a <= high + slack_;  // false for NaN
  };
  const auto& low = locator_.low();
  const auto& high = locator_.high();
  if (!within(x.z, 0.0, top_)) return std::nullopt;
  const double limit = radius_.value_or(0.0) + slack_;
  const bool inside = radius_ ? x.x * x.x + x.y * x.y <= limit * limit
                              : within(x.x, low.x, high.x) && within(x.y, low.y, high.y);
  if (!inside) return std::nullopt;
  return nearest_cell(x);
}

std::vector<std::int64_t> ColumnMesh::vertex_neighbors(std::int64_t cell) const {
  const auto k = static_cast<std::int32_t>(cell / cells_per_layer());
  const auto c = static_cast<std::size_t>(cell % cells_per_layer());
  std::vector<std::int32_t> near = {k};
  if (k > 0 || periodic_z_) near.push_back((k + layers_ - 1) % layers_);
  if (k + 1 < layers_ || periodic_z_) near.push_back((k + 1) % layers_);
  std::ranges::sort(near);
  near.erase(std::unique(near.begin(), near.end()), near.end());
  std::vector<std::int64_t> cells;
  for (const auto layer : near) {
    for (auto n = section_.first_neighbor[c]; n < section_.first_neighbor[c + 1]; ++n) {
      cells.push_back(layer * cells_per_layer() +
                      section_.vertex_neighbor[static_cast<std::size_t>(n)]);
    }
  }
  return cells;
}

}  // namespace packbed::mesh
