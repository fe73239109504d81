// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/void_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "analysis/nearest_bead.hpp"
#include "analysis/pieces.hpp"
#include "core/error.hpp"
#include "core/random.hpp"

namespace packbed::analysis {
namespace {

void check(std::span<const Bead> beads, const VoidOptions& options) {
  if (options.points < 1 || !(options.z.high > options.z.low)) {
    throw ValueError(
        fmt::format("void sizes need points and a range of heights, not {} between "
                    "{:.4g} and {:.4g} m",
                    options.points, options.z.low, options.z.high));
  }
  if (beads.empty()) throw ValueError("void sizes need beads; there are none");
}

/// The k-th point, even over the volume of the column.
Vec3 random_point(const mesh::ColumnShape& shape, const VoidOptions& options, std::uint64_t k) {
  const auto u = [&](std::uint64_t n) {
    return uniform(options.seed, Stream::void_point, 3 * k + n);
  };
  const auto between = [](const Range& r, double share) {
    return r.low + (r.high - r.low) * share;
  };
  const double z = between(options.z, u(2));
  if (const auto* cylinder = std::get_if<mesh::Cylinder>(&shape)) {
    const double r = 0.5 * cylinder->inner_diameter * std::sqrt(u(0));
    const double angle = 2.0 * std::numbers::pi * u(1);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }
  return {between(side(shape, Axis::x).range, u(0)), between(side(shape, Axis::y).range, u(1)), z};
}

double to_walls(const mesh::ColumnShape& shape, const Vec3& x) {
  if (const auto* cylinder = std::get_if<mesh::Cylinder>(&shape)) {
    return 0.5 * cylinder->inner_diameter - std::hypot(x.x, x.y);
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto axis : {Axis::x, Axis::y}) {
    const auto walls = side(shape, axis);
    if (!walls.wall) continue;
    const double at = along(x, axis);
    nearest = std::min({nearest, at - walls.range.low, walls.range.high - at});
  }
  return nearest;
}

Vec3 periods(const mesh::ColumnShape& shape) {
  if (std::holds_alternative<mesh::Cylinder>(shape)) return {};
  const auto period = [&](Axis axis) {
    const auto s = side(shape, axis);
    return s.periodic ? s.range.high - s.range.low : 0.0;
  };
  return {period(Axis::x), period(Axis::y), period(Axis::z)};
}

/// Smallest distance that a share of them does not exceed.
double quantile(const std::vector<double>& ascending, double share) {
  if (ascending.empty()) return 0.0;
  const double rank = std::ceil(share * static_cast<double>(ascending.size()));
  return ascending[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

}  // namespace

VoidSizes void_sizes(std::span<const Bead> beads,
                     const mesh::ColumnShape& shape,
                     const VoidOptions& options) {
  check(beads, options);
  const NearestBead nearest(beads, periods(shape));
  VoidSizes v;
  for (std::int64_t k = 0; k < options.points; ++k) {
    const Vec3 point = random_point(shape, options, static_cast<std::uint64_t>(k));
    const double gap = nearest.distance(point);
    if (gap > 0.0) v.distances.push_back(std::min(gap, to_walls(shape, point)));
  }
  std::ranges::sort(v.distances);
  v.points = std::ssize(v.distances);
  const auto n = static_cast<double>(options.points);
  v.share = static_cast<double>(v.points) / n;
  v.error = std::sqrt(v.share * (1.0 - v.share) / n);
  v.d10 = quantile(v.distances, 0.1);
  v.d50 = quantile(v.distances, 0.5);
  v.d90 = quantile(v.distances, 0.9);
  if (!v.distances.empty()) v.largest = v.distances.back();
  return v;
}

}  // namespace packbed::analysis
