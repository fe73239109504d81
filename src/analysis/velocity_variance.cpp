// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/velocity_variance.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "analysis/pieces.hpp"
#include "core/error.hpp"

namespace packbed::analysis {
namespace {

bool is_in(double x, const Range& range) { return x >= range.low && x < range.high; }

double weight_of(const LiquidCell& cell, CellWeight weight) {
  return weight == CellWeight::one ? 1.0 : cell.eps * cell.volume;
}

struct Mean {
  double sum = 0.0;
  double weight = 0.0;
  void add(double value, double w) {
    sum += w * value;
    weight += w;
  }
  [[nodiscard]] double value() const { return weight > 0.0 ? sum / weight : 0.0; }
};

/// From x to the nearer one of two walls.
double to_sides(double x, const Range& sides) { return std::min(x - sides.low, sides.high - x); }

}  // namespace

VelocityVariance velocity_variance(std::span<const LiquidCell> cells,
                                   const Range& z,
                                   CellWeight weight) {
  VelocityVariance v;
  Mean mean;
  for (const auto& cell : cells) {
    if (!is_in(cell.x.z, z)) continue;
    ++v.cells;
    mean.add(cell.u_z, weight_of(cell, weight));
  }
  v.mean = mean.value();
  Mean square;
  for (const auto& cell : cells) {
    if (!is_in(cell.x.z, z)) continue;
    square.add(std::pow(cell.u_z - v.mean, 2), weight_of(cell, weight));
  }
  v.variance = square.value();
  if (v.mean != 0.0) v.variation = std::sqrt(v.variance) / std::abs(v.mean);
  return v;
}

double wall_distance(const mesh::ColumnShape& shape, const Vec3& x) {
  if (const auto* cylinder = std::get_if<mesh::Cylinder>(&shape)) {
    return 0.5 * cylinder->inner_diameter - std::hypot(x.x, x.y);
  }
  for (const auto axis : {Axis::x, Axis::y}) {
    const auto walls = side(shape, axis);
    if (walls.wall) return to_sides(along(x, axis), walls.range);
  }
  throw ValueError("a box without side walls has no distance from the wall");
}

std::vector<VelocityBin> velocity_profile(std::span<const LiquidCell> cells,
                                          const mesh::ColumnShape& shape,
                                          std::span<const double> edges,
                                          const VelocityProfileOptions& options) {
  assert(edges.size() >= 2);
  std::vector<VelocityBin> bins(edges.size() - 1);
  std::vector<Mean> means(bins.size());
  Mean inner;
  for (const auto& cell : cells) {
    if (!is_in(cell.x.z, options.z)) continue;
    const double distance = wall_distance(shape, cell.x);
    const double w = weight_of(cell, options.weight);
    if (distance >= options.inner) inner.add(cell.u_z, w);
    const auto above = std::ranges::upper_bound(edges, distance) - edges.begin();
    if (above == 0 || above == std::ssize(edges)) continue;
    const auto k = static_cast<std::size_t>(above) - 1;
    ++bins[k].cells;
    means[k].add(cell.u_z, w);
  }
  for (std::size_t k = 0; k < bins.size(); ++k) {
    bins[k].distance = {edges[k], edges[k + 1]};
    bins[k].mean = means[k].value();
    if (inner.value() != 0.0) bins[k].relative = bins[k].mean / inner.value();
  }
  return bins;
}

}  // namespace packbed::analysis
