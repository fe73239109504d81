// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/nearest_bead.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace packbed::analysis {
namespace {

std::array<double, 3> to_array(const Vec3& a) { return {a.x, a.y, a.z}; }

/// Offsets of cells along an axis that are worth a look.
struct Reach {
  int low = 0;
  int high = 0;
};
using Reaches = std::array<Reach, 3>;

/// Calls visit(offset) for those offsets within reach that lie on the border of a cube of 2 s + 1 cells.
template <class Visit>
void for_shell(int s, const Reaches& reach, const Visit& visit) {
  const auto low = [&](std::size_t a) { return std::max(-s, reach[a].low); };
  const auto high = [&](std::size_t a) { return std::min(s, reach[a].high); };
  for (int k = low(2); k <= high(2); ++k) {
    for (int j = low(1); j <= high(1); ++j) {
      if (std::abs(k) == s || std::abs(j) == s) {
        for (int i = low(0); i <= high(0); ++i) visit(std::array<int, 3>{i, j, k});
        continue;
      }
      if (-s >= reach[0].low) visit(std::array<int, 3>{-s, j, k});
      if (s <= reach[0].high) visit(std::array<int, 3>{s, j, k});
    }
  }
}

}  // namespace

NearestBead::NearestBead(std::span<const Bead> beads, const Vec3& period)
    : period_(to_array(period)) {
  assert(!beads.empty());
  lay_cells_out(beads);
  sort_in(beads);
}

// Cells of the size of the largest bead; larger where beads are few, so that there are at most 8 per bead.
void NearestBead::lay_cells_out(std::span<const Bead> beads) {
  std::array<double, 3> high{};
  low_.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (const auto& bead : beads) {
    const auto x = to_array(bead.x);
    for (std::size_t a = 0; a < 3; ++a) {
      low_[a] = std::min(low_[a], x[a]);
      high[a] = std::max(high[a], x[a]);
    }
    largest_radius_ = std::max(largest_radius_, bead.radius);
  }
  double width = 2.0 * largest_radius_;
  double volume = 1.0;
  for (std::size_t a = 0; a < 3; ++a) {
    if (period_[a] > 0.0) high[a] = low_[a] + period_[a];
    volume *= std::max(high[a] - low_[a], width);
  }
  width = std::max(width, std::cbrt(volume / (8.0 * static_cast<double>(beads.size()))));
  for (std::size_t a = 0; a < 3; ++a) {
    const double length = high[a] - low_[a];
    count_[a] = std::max(1, static_cast<int>(length / width));
    width_[a] = period_[a] > 0.0 ? period_[a] / count_[a] : std::max(length / count_[a], width);
  }
}

void NearestBead::sort_in(std::span<const Bead> beads) {
  const auto place = [&](const Bead& bead) {
    auto cell = cell_of(bead.x);
    Vec3 shift;
    wrap(cell, shift);
    for (std::size_t a = 0; a < 3; ++a) cell[a] = std::clamp(cell[a], 0, count_[a] - 1);
    return std::pair(index_of(cell), Ball{bead.x - shift, bead.radius});
  };
  first_.assign(index_of({0, 0, count_[2]}) + 1, 0);
  for (const auto& bead : beads) ++first_[place(bead).first + 1];
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  balls_.resize(beads.size());
  auto next = first_;
  for (const auto& bead : beads) {
    const auto [cell, ball] = place(bead);
    balls_[next[cell]++] = ball;
  }
}

NearestBead::Cell NearestBead::cell_of(const Vec3& point) const {
  const auto x = to_array(point);
  Cell cell{};
  for (std::size_t a = 0; a < 3; ++a) {
    cell[a] = static_cast<int>(std::floor((x[a] - low_[a]) / width_[a]));
  }
  return cell;
}

/// Into the grid over periodic sides; `shift` is what the cell's content must be moved by to be where it was.
void NearestBead::wrap(Cell& cell, Vec3& shift) const {
  std::array<double, 3> moved{};
  for (std::size_t a = 0; a < 3; ++a) {
    if (!(period_[a] > 0.0)) continue;
    const int turns = cell[a] >= 0 ? cell[a] / count_[a] : -((count_[a] - 1 - cell[a]) / count_[a]);
    cell[a] -= turns * count_[a];
    moved[a] = turns * period_[a];
  }
  shift = {moved[0], moved[1], moved[2]};
}

std::size_t NearestBead::index_of(const Cell& cell) const {
  const auto row = static_cast<std::size_t>(cell[2]) * static_cast<std::size_t>(count_[1]) +
                   static_cast<std::size_t>(cell[1]);
  return row * static_cast<std::size_t>(count_[0]) + static_cast<std::size_t>(cell[0]);
}

void NearestBead::look_at(Cell cell, const Vec3& point, double& nearest) const {
  Vec3 shift;
  wrap(cell, shift);
  const auto c = index_of(cell);
  for (auto k = first_[c]; k < first_[c + 1]; ++k) {
    nearest = std::min(nearest, norm(point - shift - balls_[k].x) - balls_[k].radius);
  }
}

// What is not in the shells up to s is at least s cells away. Over a periodic side the nearest image is at most half
// a period away.
double NearestBead::distance(const Vec3& point) const {
  const auto here = cell_of(point);
  Reaches reach;
  int first = 0;
  int last = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const int half = count_[a] / 2 + 1;
    reach[a] = period_[a] > 0.0 ? Reach{-half, half} : Reach{-here[a], count_[a] - 1 - here[a]};
    first = std::max({first, reach[a].low, -reach[a].high});
    last = std::max({last, -reach[a].low, reach[a].high});
  }
  const double width = std::min({width_[0], width_[1], width_[2]});
  double nearest = std::numeric_limits<double>::infinity();
  for (int s = first; s <= last; ++s) {
    for_shell(s, reach, [&](const std::array<int, 3>& offset) {
      look_at({here[0] + offset[0], here[1] + offset[1], here[2] + offset[2]}, point, nearest);
    });
    if (nearest <= 0.0 || nearest <= s * width - largest_radius_) break;
  }
  return nearest;
}

}  // namespace packbed::analysis
