// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/five_block.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace packbed::mesh {
namespace {

using std::numbers::pi;

// Where the middle block starts from, in radii: its corners and the middles of its sides. Smoothing
// moves both; the start is near enough that 40 sweeps give the figures of docs/theory/mesh.md.
constexpr double corner_distance = 0.68;
constexpr double side_distance = 0.50;
constexpr int sweeps = 40;

Point between(const Point& p, const Point& q, double t) {
  return {(1.0 - t) * p.x + t * q.x, (1.0 - t) * p.y + t * q.y};
}

/// The plane seen as a square of (core + 2 ring)^2 cells without its four corners, which the wall
/// points at 45 degrees replace.
class FiveBlocks {
 public:
  FiveBlocks(double radius, std::int32_t core, std::int32_t ring)
      : radius_(radius), core_(core), ring_(ring) {
    place_core();
    place_rings();
    number_cells();
  }

  CrossSection section;

  [[nodiscard]] bool is_at_the_wall(std::size_t point) const { return point >= first_wall_; }

 private:
  [[nodiscard]] std::int32_t core_point(std::int32_t i, std::int32_t j) const {
    return j * (core_ + 1) + i;
  }
  // Place s of the way around the core, counterclockwise from its lower left corner.
  [[nodiscard]] std::int32_t around(std::int32_t s) const {
    const std::int32_t n = core_;
    s = (s % (4 * n) + 4 * n) % (4 * n);
    if (s < n) return core_point(s, 0);
    if (s < 2 * n) return core_point(n, s - n);
    if (s < 3 * n) return core_point(3 * n - s, n);
    return core_point(0, 4 * n - s);
  }
  // Point of ring line l (0 on the core, ring on the wall) at place s.
  [[nodiscard]] std::int32_t ring_point(std::int32_t s, std::int32_t l) const {
    if (l == 0) return around(s);
    const std::int32_t turn = 4 * core_;
    return (core_ + 1) * (core_ + 1) + (l - 1) * turn + (s % turn + turn) % turn;
  }

  // Point of the lower side of the core: an arc through both corners and the middle of the side.
  [[nodiscard]] Point lower_side(std::int32_t i) const {
    const double k = radius_ * corner_distance / std::numbers::sqrt2;
    const double bulge = radius_ * side_distance - k;
    const double arc = (k * k + bulge * bulge) / (2.0 * bulge);
    const double angle = std::asin(k / arc) * (2.0 * i / core_ - 1.0);
    return {arc * std::sin(angle), -radius_ * side_distance + arc * (1.0 - std::cos(angle))};
  }

  // Coons patch between the four sides.
  void place_core() {
    const std::int32_t n = core_;
    const auto south = [&](std::int32_t i) { return lower_side(i); };
    const auto north = [&](std::int32_t i) { return Point{lower_side(i).x, -lower_side(i).y}; };
    const auto west = [&](std::int32_t j) { return Point{lower_side(j).y, lower_side(j).x}; };
    const auto east = [&](std::int32_t j) { return Point{-lower_side(j).y, lower_side(j).x}; };
    for (std::int32_t j = 0; j <= n; ++j) {
      for (std::int32_t i = 0; i <= n; ++i) {
        const double u = static_cast<double>(i) / n;
        const double v = static_cast<double>(j) / n;
        const Point rows = between(south(i), north(i), v);
        const Point columns = between(west(j), east(j), u);
        const Point corners =
            between(between(south(0), south(n), u), between(north(0), north(n), u), v);
        section.points.push_back({rows.x + columns.x - corners.x, rows.y + columns.y - corners.y});
      }
    }
  }

  void place_rings() {
    const double outer = wall_point_radius(radius_, core_);
    for (std::int32_t l = 1; l <= ring_; ++l) {
      if (l == ring_) first_wall_ = section.points.size();
      for (std::int32_t s = 0; s < 4 * core_; ++s) {
        const double angle = pi * (0.5 * s / core_ - 0.75);
        const Point wall = {outer * std::cos(angle), outer * std::sin(angle)};
        const Point start = section.points[static_cast<std::size_t>(around(s))];
        section.points.push_back(between(start, wall, static_cast<double>(l) / ring_));
      }
    }
  }

  // Cell of the ring between lines l and l + 1, from place s to s + 1.
  void add_ring_cell(std::int32_t s, std::int32_t l) {
    section.cells.push_back(
        {ring_point(s, l + 1), ring_point(s + 1, l + 1), ring_point(s + 1, l), ring_point(s, l)});
  }

  void number_cells() {
    const std::int32_t n = core_;
    for (std::int32_t l = ring_ - 1; l >= 0; --l) {
      for (std::int32_t i = 0; i < n; ++i) add_ring_cell(i, l);
    }
    for (std::int32_t j = 0; j < n; ++j) {
      for (std::int32_t l = ring_ - 1; l >= 0; --l) add_ring_cell(4 * n - 1 - j, l);
      for (std::int32_t i = 0; i < n; ++i) {
        section.cells.push_back({core_point(i, j), core_point(i + 1, j), core_point(i + 1, j + 1),
                                 core_point(i, j + 1)});
      }
      for (std::int32_t l = 0; l < ring_; ++l) add_ring_cell(n + j, l);
    }
    for (std::int32_t l = 0; l < ring_; ++l) {
      for (std::int32_t i = 0; i < n; ++i) add_ring_cell(3 * n - 1 - i, l);
    }
  }

  double radius_;
  std::int32_t core_;
  std::int32_t ring_;
  std::size_t first_wall_ = 0;
};

// Moves every point off the wall to the mean of the centers of the cells around it, weighted by their
// areas: evens out angles like a plain mean of neighbors, but keeps cells from shrinking where three
// blocks meet.
void smooth(FiveBlocks& blocks) {
  auto& section = blocks.section;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    std::vector<double> weight(section.points.size(), 0.0);
    std::vector<Point> sum(section.points.size());
    for (const auto& corners : section.cells) {
      const auto [area, center] = measure(section.points, corners);
      for (const auto corner : corners) {
        const auto p = static_cast<std::size_t>(corner);
        weight[p] += area;
        sum[p].x += area * center.x;
        sum[p].y += area * center.y;
      }
    }
    for (std::size_t p = 0; p < section.points.size(); ++p) {
      if (blocks.is_at_the_wall(p)) continue;
      section.points[p] = {sum[p].x / weight[p], sum[p].y / weight[p]};
    }
  }
}

}  // namespace

double wall_point_radius(double radius, std::int32_t core) {
  const double step = 0.5 * pi / core;  // angle of a facet
  return radius * std::sqrt(step / std::sin(step));
}

CrossSection five_block_section(double radius, std::int32_t core, std::int32_t ring) {
  FiveBlocks blocks(radius, core, ring);
  smooth(blocks);
  auto section = std::move(blocks.section);
  connect(section, [](std::int32_t, std::int32_t) { return Patch::wall; }, {});
  return section;
}

}  // namespace packbed::mesh
