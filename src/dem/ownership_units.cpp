// SPDX-License-Identifier: BSD-3-Clause
#include "dem/ownership_units.hpp"

#include <algorithm>
#include <cmath>

namespace packbed::dem {
namespace {

// Moves over a periodic side, none among them, after which a stretch of `reach` on each side of `a`
// is still in the domain.
std::vector<double> images(const Domain& domain, std::size_t axis, double a, double reach) {
  std::vector<double> moves = {0.0};
  if (!domain.periodic[axis]) return moves;
  const double low = domain.low[axis];
  const double size = domain.size[axis];
  for (double turn = size; turn - size < reach; turn += size) {
    if (a - turn + reach >= low) moves.push_back(-turn);
    if (a + turn - reach <= low + size) moves.push_back(turn);
  }
  return moves;
}

}  // namespace

// Beads that have escaped far away all count as being in the outermost slab.
std::int64_t RowUnits::slab(double a, std::size_t axis) const {
  constexpr double outermost = 1e6;
  return static_cast<std::int64_t>(
      std::clamp(std::floor((a - domain_.low[axis]) / cell_), -outermost, outermost));
}

std::int64_t RowUnits::row(std::int64_t z, std::int64_t y) const {
  const auto in = [&](std::int64_t s, std::size_t k) {
    return std::clamp<std::int64_t>(s - first_[k], 0, count_[k] - 1);
  };
  return in(z, 1) * count_[0] + in(y, 0);
}

std::int64_t RowUnits::unit(const Vec3& x) const { return row(slab(x.z, 2), slab(x.y, 1)); }

std::vector<UnitRange> RowUnits::within(const Vec3& x, double reach) const {
  std::vector<UnitRange> ranges;
  const auto rows = images(domain_, 1, x.y, reach);
  for (const double dz : images(domain_, 2, x.z, reach)) {
    for (auto z = slab(x.z + dz - reach, 2); z <= slab(x.z + dz + reach, 2); ++z) {
      for (const double dy : rows) {
        ranges.push_back({row(z, slab(x.y + dy - reach, 1)), row(z, slab(x.y + dy + reach, 1))});
      }
    }
  }
  return ranges;
}

std::vector<UnitRange> RowUnits::slabs_within(const Vec3& x, double reach) const {
  std::vector<UnitRange> ranges;
  const auto last = first_[0] + count_[0] - 1;
  for (const double dz : images(domain_, 2, x.z, reach)) {
    ranges.push_back(
        {row(slab(x.z + dz - reach, 2), first_[0]), row(slab(x.z + dz + reach, 2), last)});
  }
  return ranges;
}

// Where a few beads are far away, as many slabs as are worth counting around the mean.
void RowUnits::fit(const std::vector<Vec3>& own, const Ranks& ranks) {
  constexpr double none = -9e15;
  std::array<double, 4> ends = {none, none, none, none};  // -low and high of y, of z
  for (const auto& x : own) {
    const auto y = static_cast<double>(slab(x.y, 1));
    const auto z = static_cast<double>(slab(x.z, 2));
    ends = {std::max(ends[0], -y), std::max(ends[1], y), std::max(ends[2], -z),
            std::max(ends[3], z)};
  }
  for (auto& end : ends) end = ranks.max(end);
  for (std::size_t k = 0; k < 2; ++k) {
    const bool empty = ends[2 * k] == none;
    first_[k] = empty ? 0 : static_cast<std::int64_t>(-ends[2 * k]);
    count_[k] = empty ? 1 : static_cast<std::int64_t>(ends[2 * k + 1]) - first_[k] + 1;
    constexpr std::int64_t most_slabs = 2048;
    if (count_[k] <= most_slabs) continue;
    std::array<std::int64_t, 2> sums = {0, static_cast<std::int64_t>(own.size())};
    for (const auto& x : own) sums[0] += k == 0 ? slab(x.y, 1) : slab(x.z, 2);
    ranks.sum(sums);
    first_[k] = std::clamp(sums[0] / sums[1] - most_slabs / 2, first_[k],
                           first_[k] + count_[k] - most_slabs);
    count_[k] = most_slabs;
  }
}

std::vector<UnitRange> CellUnits::slabs_within(const Vec3& x, double reach) const {
  std::vector<UnitRange> ranges;
  const auto n = mesh_->cells_per_layer();
  for (const double dz : images(domain_, 2, x.z, reach)) {
    ranges.push_back(
        {mesh_->layer_at(x.z + dz - reach) * n, (mesh_->layer_at(x.z + dz + reach) + 1) * n - 1});
  }
  return ranges;
}

std::vector<UnitRange> CellUnits::within(const Vec3& x, double reach) const {
  std::vector<std::int32_t> cells;
  for (const double dx : images(domain_, 0, x.x, reach)) {
    for (const double dy : images(domain_, 1, x.y, reach)) {
      const auto near = mesh_->locator().cells_within({x.x + dx, x.y + dy}, reach);
      cells.insert(cells.end(), near.begin(), near.end());
    }
  }
  std::ranges::sort(cells);
  std::vector<UnitRange> in_layer;
  for (const auto c : cells) {
    if (!in_layer.empty() && c <= in_layer.back().last + 1) {
      in_layer.back().last = c;
    } else {
      in_layer.push_back({c, c});
    }
  }
  std::vector<UnitRange> ranges;
  const auto n = mesh_->cells_per_layer();
  for (const auto& layers : slabs_within(x, reach)) {
    for (auto first = layers.first; first <= layers.last; first += n) {
      for (const auto& r : in_layer) ranges.push_back({first + r.first, first + r.last});
    }
  }
  return ranges;
}

}  // namespace packbed::dem
