// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/cross_section.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace packbed::mesh {
namespace {

/// One side of one cell.
struct Half {
  std::int32_t low, high;  // its points, by number
  std::int32_t a, b;       // in the order of the cell
  std::int32_t cell;
};

std::vector<Half> halves(const CrossSection& section) {
  std::vector<Half> all;
  all.reserve(4 * section.cells.size());
  for (std::int32_t c = 0; c < section.cell_count(); ++c) {
    const auto& corners = section.cells[static_cast<std::size_t>(c)];
    for (std::size_t k = 0; k < 4; ++k) {
      const auto a = corners[k];
      const auto b = corners[(k + 1) % 4];
      all.push_back({.low = std::min(a, b), .high = std::max(a, b), .a = a, .b = b, .cell = c});
    }
  }
  std::ranges::sort(all, [](const Half& p, const Half& q) {
    return std::tie(p.low, p.high, p.cell) < std::tie(q.low, q.high, q.cell);
  });
  return all;
}

void find_edges(CrossSection& section,
                const std::function<Patch(std::int32_t, std::int32_t)>& patch_of) {
  const auto all = halves(section);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto& h = all[k];
    if (k + 1 < all.size() && all[k + 1].low == h.low && all[k + 1].high == h.high) {
      section.inner.push_back(
          {.a = h.a, .b = h.b, .owner = h.cell, .neighbor = all[k + 1].cell, .shift = {}});
      ++k;
    } else {
      section.border.push_back({.a = h.a, .b = h.b, .cell = h.cell, .patch = patch_of(h.a, h.b)});
    }
  }
}

/// Points that are one over a periodic side, by the lowest of them.
class Sameness {
 public:
  explicit Sameness(std::size_t count) : first_(count) {
    std::iota(first_.begin(), first_.end(), 0);
  }
  std::int32_t first(std::int32_t p) const {
    while (first_[static_cast<std::size_t>(p)] != p) p = first_[static_cast<std::size_t>(p)];
    return p;
  }
  void join(std::int32_t p, std::int32_t q) {
    p = first(p);
    q = first(q);
    first_[static_cast<std::size_t>(std::max(p, q))] = std::min(p, q);
  }

 private:
  std::vector<std::int32_t> first_;
};

// Both sides have their edges in the order of cells, so the k-th of one meets the k-th of the other.
void join_sides(CrossSection& section, Patch low_side, Patch high_side, Sameness& same) {
  std::vector<BorderEdge> low;
  std::vector<BorderEdge> high;
  for (const auto& e : section.border) {
    if (e.patch == low_side) low.push_back(e);
    if (e.patch == high_side) high.push_back(e);
  }
  for (std::size_t k = 0; k < low.size(); ++k) {
    // The cells lie on opposite sides, so the edges run against each other.
    same.join(low[k].a, high[k].b);
    same.join(low[k].b, high[k].a);
    if (low[k].cell == high[k].cell) continue;
    const auto& here = low[k].cell < high[k].cell ? low[k] : high[k];
    const auto& there = low[k].cell < high[k].cell ? high[k] : low[k];
    const auto& p = section.points[static_cast<std::size_t>(here.a)];
    const auto& q = section.points[static_cast<std::size_t>(there.b)];
    section.inner.push_back({.a = here.a,
                             .b = here.b,
                             .owner = here.cell,
                             .neighbor = there.cell,
                             .shift = {p.x - q.x, p.y - q.y}});
  }
  std::erase_if(section.border, [&](const BorderEdge& e) {
    const bool joined = e.patch == low_side || e.patch == high_side;
    return joined && low.front().cell != high.front().cell;
  });
}

void measure_cells(CrossSection& section) {
  for (const auto& corners : section.cells) {
    const auto [area, center] = measure(section.points, corners);
    section.area.push_back(area);
    section.center.push_back(center);
  }
}

void find_vertex_neighbors(CrossSection& section, const Sameness& same) {
  std::vector<std::vector<std::int32_t>> around(section.points.size());
  for (std::int32_t c = 0; c < section.cell_count(); ++c) {
    for (const auto p : section.cells[static_cast<std::size_t>(c)]) {
      around[static_cast<std::size_t>(same.first(p))].push_back(c);
    }
  }
  section.first_neighbor.assign(1, 0);
  for (const auto& corners : section.cells) {
    std::vector<std::int32_t> found;
    for (const auto p : corners) {
      const auto& cells = around[static_cast<std::size_t>(same.first(p))];
      found.insert(found.end(), cells.begin(), cells.end());
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    section.vertex_neighbor.insert(section.vertex_neighbor.end(), found.begin(), found.end());
    section.first_neighbor.push_back(static_cast<std::int32_t>(section.vertex_neighbor.size()));
  }
}

void sort_border(CrossSection& section) {
  std::ranges::stable_sort(section.border, [](const BorderEdge& p, const BorderEdge& q) {
    return std::tie(p.patch, p.cell) < std::tie(q.patch, q.cell);
  });
}

}  // namespace

AreaAndCenter measure(const std::vector<Point>& points,
                      const std::array<std::int32_t, 4>& corners) {
  // Relative to the first corner, which keeps the digits of small cells far from the origin.
  const auto& origin = points[static_cast<std::size_t>(corners[0])];
  double twice_area = 0.0;
  Point sum;
  for (std::size_t k = 1; k < 3; ++k) {
    const auto& p = points[static_cast<std::size_t>(corners[k])];
    const auto& q = points[static_cast<std::size_t>(corners[k + 1])];
    const Point u = {p.x - origin.x, p.y - origin.y};
    const Point v = {q.x - origin.x, q.y - origin.y};
    const double w = u.x * v.y - v.x * u.y;
    twice_area += w;
    sum.x += w * (u.x + v.x);
    sum.y += w * (u.y + v.y);
  }
  return {.area = 0.5 * twice_area,
          .center = {origin.x + sum.x / (3.0 * twice_area), origin.y + sum.y / (3.0 * twice_area)}};
}

void connect(CrossSection& section,
             const std::function<Patch(std::int32_t, std::int32_t)>& patch_of,
             PeriodicSides periodic) {
  find_edges(section, patch_of);
  sort_border(section);
  Sameness same(section.points.size());
  if (periodic.x) join_sides(section, Patch::x_low, Patch::x_high, same);
  if (periodic.y) join_sides(section, Patch::y_low, Patch::y_high, same);
  // Stable: where two cells meet twice, the edge over the periodic side is the second.
  std::ranges::stable_sort(section.inner, [](const InnerEdge& p, const InnerEdge& q) {
    return std::tie(p.owner, p.neighbor) < std::tie(q.owner, q.neighbor);
  });
  measure_cells(section);
  find_vertex_neighbors(section, same);
}

CrossSection rectangle_section(
    const Point& low, const Point& high, std::int32_t nx, std::int32_t ny, PeriodicSides periodic) {
  CrossSection section;
  for (std::int32_t j = 0; j <= ny; ++j) {
    for (std::int32_t i = 0; i <= nx; ++i) {
      // Exact at both ends.
      const double u = static_cast<double>(i) / nx;
      const double v = static_cast<double>(j) / ny;
      section.points.push_back({(1.0 - u) * low.x + u * high.x, (1.0 - v) * low.y + v * high.y});
    }
  }
  for (std::int32_t j = 0; j < ny; ++j) {
    for (std::int32_t i = 0; i < nx; ++i) {
      const std::int32_t p = j * (nx + 1) + i;
      section.cells.push_back({p, p + 1, p + nx + 2, p + nx + 1});
    }
  }
  const auto patch_of = [nx](std::int32_t a, std::int32_t b) {
    const std::int32_t row = nx + 1;
    if (a % row == b % row) return a % row == 0 ? Patch::x_low : Patch::x_high;
    return a / row == 0 ? Patch::y_low : Patch::y_high;
  };
  connect(section, patch_of, periodic);
  return section;
}

}  // namespace packbed::mesh
