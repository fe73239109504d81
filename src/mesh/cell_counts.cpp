// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/cell_counts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::mesh {
namespace {

// In doubles until the sum is known to be small enough.
struct Counts {
  double x = 0, y = 0, core = 0, ring = 0, layers = 1;
};

double number(const std::optional<std::int64_t>& given, double otherwise, double least = 1.0) {
  return given ? static_cast<double>(*given) : std::max(least, std::round(otherwise));
}

Counts counts(const Slice& slice, const MeshOptions& o) {
  return {.x = number(o.cells_x, slice.inner_diameter / o.cell), .y = number(o.cells_y, 1.0)};
}

// Across the diameter lie core + 2 ring = 2 core cells.
Counts counts(const Cylinder& cylinder, const MeshOptions& o) {
  const double core = number(o.core, 0.5 * cylinder.inner_diameter / o.cell, 2.0);
  return {.core = core, .ring = number(o.ring, 0.5 * core)};
}

Counts counts(const Box& box, const MeshOptions& o) {
  return {.x = number(o.cells_x, box.size[0] / o.cell),
          .y = number(o.cells_y, box.size[1] / o.cell)};
}

}  // namespace

CellCounts cell_counts(const ColumnShape& shape, const MeshOptions& options) {
  auto c = std::visit([&](const auto& s) { return counts(s, options); }, shape);
  c.layers = number(options.layers, height(shape) / options.cell);
  const double per_layer = c.x * c.y + c.core * c.core + 4.0 * c.core * c.ring;
  if (!(per_layer <= most_cells_per_layer) || !(per_layer * c.layers <= most_cells)) {
    throw ValueError(fmt::format(
        "makes {:.3g} cells in each of {:.3g} layers; at most {:.0f} million in a layer "
        "and {:.0f} million in all can be handled",
        per_layer, c.layers, most_cells_per_layer * 1e-6, most_cells * 1e-6));
  }
  const auto whole = [](double value) { return static_cast<std::int32_t>(value); };
  return {.x = whole(c.x),
          .y = whole(c.y),
          .core = whole(c.core),
          .ring = whole(c.ring),
          .layers = whole(c.layers)};
}

}  // namespace packbed::mesh
