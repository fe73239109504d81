// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/section_locator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace packbed::mesh {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Point clamped(const Point& p, const Point& low, const Point& high) {
  return {std::clamp(p.x, low.x, high.x), std::clamp(p.y, low.y, high.y)};
}

}  // namespace

SectionLocator::SectionLocator(const CrossSection& section)
    : low_{infinity, infinity}, high_{-infinity, -infinity} {
  for (const auto& p : section.points) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
  }
  bound_cells(section);
  fill_buckets();
}

// Both cells of an edge get the same numbers with opposite signs, so that a point is never found
// outside of both.
void SectionLocator::bound_cells(const CrossSection& section) {
  cells_.resize(section.cells.size());
  const auto add = [&](std::int32_t cell, const Line& line) {
    auto& c = cells_[static_cast<std::size_t>(cell)];
    c.lines[c.count++] = line;
  };
  for (const auto& e : section.inner) {
    if (e.shift.x != 0.0 || e.shift.y != 0.0) continue;
    const auto& a = section.points[static_cast<std::size_t>(e.a)];
    const auto& b = section.points[static_cast<std::size_t>(e.b)];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const Point normal = {(a.y - b.y) / length, (b.x - a.x) / length};
    add(e.owner, {.normal = normal, .through = a});
    add(e.neighbor, {.normal = {-normal.x, -normal.y}, .through = a});
  }
}

double SectionLocator::Line::operator()(const Point& p) const {
  return normal.x * (p.x - through.x) + normal.y * (p.y - through.y);
}

double SectionLocator::Cell::depth(const Point& p) const {
  double least = infinity;
  for (std::size_t k = 0; k < count; ++k) least = std::min(least, lines[k](p));
  return least;
}

std::size_t SectionLocator::bucket(double a, std::size_t axis) const {
  const double low = axis == 0 ? low_.x : low_.y;
  const double place = (a - low) / width_[axis];
  if (!(place > 0.0)) return 0;
  return std::min(static_cast<std::size_t>(std::min(place, 1e9)), count_[axis] - 1);
}

// Whether no line of the cell has all of the bucket outside.
bool SectionLocator::may_meet(std::size_t cell, std::size_t bx, std::size_t by) const {
  constexpr double margin = 1e-6;  // in buckets: far above rounding
  const auto x = static_cast<double>(bx);
  const auto y = static_cast<double>(by);
  const Point low = {low_.x + (x - margin) * width_[0], low_.y + (y - margin) * width_[1]};
  const Point high = {low_.x + (x + 1 + margin) * width_[0], low_.y + (y + 1 + margin) * width_[1]};
  const auto& c = cells_[cell];
  for (std::size_t k = 0; k < c.count; ++k) {
    const auto& n = c.lines[k].normal;
    if (c.lines[k]({n.x > 0.0 ? high.x : low.x, n.y > 0.0 ? high.y : low.y}) < 0.0) return false;
  }
  return true;
}

// Corners of what the lines of a cell leave of the bounding box.
std::vector<Point> SectionLocator::reach_of(std::size_t cell) const {
  std::vector<Point> shape = {low_, {high_.x, low_.y}, high_, {low_.x, high_.y}};
  for (std::size_t n = 0; n < cells_[cell].count; ++n) {
    const auto& line = cells_[cell].lines[n];
    std::vector<Point> left;
    for (std::size_t k = 0; k < shape.size(); ++k) {
      const auto& p = shape[k];
      const auto& q = shape[(k + 1) % shape.size()];
      const double at_p = line(p);
      const double at_q = line(q);
      if (at_p >= 0.0) left.push_back(p);
      if ((at_p >= 0.0) != (at_q >= 0.0)) {
        const double t = at_p / (at_p - at_q);
        left.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
      }
    }
    shape = std::move(left);
  }
  return shape;
}

// Buckets around all corners, and one more on each side for rounding.
SectionLocator::Range SectionLocator::range_of(std::size_t cell) const {
  Range range = {count_[0], 0, count_[1], 0};
  for (const auto& p : reach_of(cell)) {
    const auto x = bucket(p.x, 0);
    const auto y = bucket(p.y, 1);
    range = {std::min(range[0], x - std::min<std::size_t>(x, 1)),
             std::max(range[1], std::min(x + 1, count_[0] - 1)),
             std::min(range[2], y - std::min<std::size_t>(y, 1)),
             std::max(range[3], std::min(y + 1, count_[1] - 1))};
  }
  return range;
}

void SectionLocator::fill_buckets() {
  const std::array<double, 2> size = {high_.x - low_.x, high_.y - low_.y};
  const double aim = std::sqrt(size[0] * size[1] / static_cast<double>(cells_.size()));
  for (std::size_t axis = 0; axis < 2; ++axis) {
    count_[axis] = static_cast<std::size_t>(std::max(1.0, std::round(size[axis] / aim)));
    width_[axis] = size[axis] / static_cast<double>(count_[axis]);
  }
  std::vector<std::vector<std::int32_t>> found(count_[0] * count_[1]);
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const auto range = range_of(c);
    for (std::size_t by = range[2]; by <= range[3]; ++by) {
      for (std::size_t bx = range[0]; bx <= range[1]; ++bx) {
        if (may_meet(c, bx, by)) {
          found[by * count_[0] + bx].push_back(static_cast<std::int32_t>(c));
        }
      }
    }
  }
  first_.assign(1, 0);
  for (const auto& cells : found) {
    candidates_.insert(candidates_.end(), cells.begin(), cells.end());
    first_.push_back(static_cast<std::int32_t>(candidates_.size()));
  }
}

std::int32_t SectionLocator::cell_at(const Point& point) const {
  const Point p = clamped(point, low_, high_);
  const auto b = bucket(p.y, 1) * count_[0] + bucket(p.x, 0);
  std::int32_t best = 0;
  double best_depth = -infinity;
  for (auto k = first_[b]; k < first_[b + 1]; ++k) {
    const auto cell = candidates_[static_cast<std::size_t>(k)];
    const double depth = cells_[static_cast<std::size_t>(cell)].depth(p);
    if (depth >= 0.0) return cell;  // the candidates rise: the lowest on an edge or corner
    if (depth > best_depth) {
      best_depth = depth;
      best = cell;
    }
  }
  return best;
}

std::vector<std::int32_t> SectionLocator::cells_within(const Point& point, double reach) const {
  const Point p = clamped(point, low_, high_);
  std::vector<std::int32_t> cells;
  for (auto by = bucket(p.y - reach, 1); by <= bucket(p.y + reach, 1); ++by) {
    for (auto bx = bucket(p.x - reach, 0); bx <= bucket(p.x + reach, 0); ++bx) {
      const auto b = by * count_[0] + bx;
      cells.insert(cells.end(), candidates_.begin() + first_[b],
                   candidates_.begin() + first_[b + 1]);
    }
  }
  std::ranges::sort(cells);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

}  // namespace packbed::mesh
