// SPDX-License-Identifier: BSD-3-Clause
#include "setup/averaging.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "resin/size_statistics.hpp"

namespace packbed::setup {

GrainSizes grain_sizes(const Case& c) {
  if (c.resin.sizes) {
    const auto s = resin::statistics(*c.resin.sizes);
    const double inertia = std::sqrt(std::pow(s.volume_mean, 3) / s.mean);
    return {c.resin.coarse_grain * s.mean, s.sauter, c.resin.coarse_grain * inertia};
  }
  std::array<double, 4> moments{};
  for (const double d : c.beads.table.diameter) {
    double power = 1.0;
    for (auto& m : moments) {
      m += power;
      power *= d;
    }
  }
  return {moments[1] / moments[0], moments[3] / moments[2] / c.resin.coarse_grain,
          std::sqrt(moments[3] / moments[1])};
}

double averaging_reach(const Case& c) {
  if (c.coupling.averaging_width) return *c.coupling.averaging_width;
  return std::max(reach_in_diameters * grain_sizes(c).mean, c.column.mesh->cell);
}

double most_averaging_reach(const Case& c) {
  const auto counts = mesh::cell_counts(c.column.shape, *c.column.mesh);
  double most = std::numeric_limits<double>::infinity();
  if (const auto* slice = std::get_if<mesh::Slice>(&c.column.shape)) {
    if (counts.y > 1) most = 0.5 * slice->depth;
  }
  if (const auto* box = std::get_if<mesh::Box>(&c.column.shape)) {
    const std::array<std::int32_t, 3> cells = {counts.x, counts.y, counts.layers};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool is_empty = axis == 1 && cells[axis] == 1;  // coupling::Weights knows no such y
      if (box->boundaries[axis] == mesh::Boundary::periodic && !is_empty) {
        most = std::min(most, 0.5 * box->size[axis]);
      }
    }
  }
  return most;
}

}  // namespace packbed::setup
