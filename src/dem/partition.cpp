// SPDX-License-Identifier: BSD-3-Clause
#include "dem/partition.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace packbed::dem {

// Beads that have escaped far away all count as being in the outermost slab.
std::int64_t Partition::slab(double a, std::size_t axis) const {
  constexpr double outermost = 1e6;
  return static_cast<std::int64_t>(
      std::clamp(std::floor((a - domain_.low[axis]) / cell_), -outermost, outermost));
}

std::int64_t Partition::row(std::int64_t z, std::int64_t y) const {
  const auto in = [&](std::int64_t s, std::size_t k) {
    return std::clamp<std::int64_t>(s - first_[k], 0, count_[k] - 1);
  };
  return in(z, 1) * count_[0] + in(y, 0);
}

int Partition::owner_of_row(std::int64_t z, std::int64_t y) const {
  const auto found = std::ranges::upper_bound(end_, row(z, y));
  return std::min(static_cast<int>(found - end_.begin()), ranks_.size() - 1);
}

int Partition::owner(const Vec3& x) const { return owner_of_row(slab(x.z, 2), slab(x.y, 1)); }

std::vector<std::int64_t> Partition::slabs_within(double a, double reach, std::size_t axis) const {
  std::vector<std::int64_t> slabs;
  const auto add = [&](double from, double to) {
    for (auto s = slab(from, axis); s <= slab(to, axis); ++s) slabs.push_back(s);
  };
  add(a - reach, a + reach);
  if (domain_.periodic[axis]) {
    const double size = domain_.size[axis];
    for (double turn = size; turn - size < reach; turn += size) {
      add(a - reach + turn, a + reach + turn);
      add(a - reach - turn, a + reach - turn);
    }
  }
  return slabs;
}

std::vector<int> Partition::owners_within(const Vec3& x, double reach) const {
  std::vector<int> owners;
  const auto rows = slabs_within(x.y, reach, 1);
  for (const auto z : slabs_within(x.z, reach, 2)) {
    for (const auto y : rows) owners.push_back(owner_of_row(z, y));
  }
  std::ranges::sort(owners);
  owners.erase(std::unique(owners.begin(), owners.end()), owners.end());
  return owners;
}

// The range of rows with beads, over all ranks; where a few beads are far away, as many slabs as are
// worth counting around the mean. Rows beyond belong to the nearest one in the range.
void Partition::measure(const std::vector<Vec3>& own) {
  constexpr double none = -9e15;
  std::array<double, 4> ends = {none, none, none, none};  // -low and high of y, of z
  for (const auto& x : own) {
    const auto y = static_cast<double>(slab(x.y, 1));
    const auto z = static_cast<double>(slab(x.z, 2));
    ends = {std::max(ends[0], -y), std::max(ends[1], y), std::max(ends[2], -z),
            std::max(ends[3], z)};
  }
  for (auto& end : ends) end = ranks_.max(end);
  for (std::size_t k = 0; k < 2; ++k) {
    const bool empty = ends[2 * k] == none;
    first_[k] = empty ? 0 : static_cast<std::int64_t>(-ends[2 * k]);
    count_[k] = empty ? 1 : static_cast<std::int64_t>(ends[2 * k + 1]) - first_[k] + 1;
    constexpr std::int64_t most_slabs = 2048;
    if (count_[k] <= most_slabs) continue;
    std::array<std::int64_t, 2> sums = {0, static_cast<std::int64_t>(own.size())};
    for (const auto& x : own) sums[0] += k == 0 ? slab(x.y, 1) : slab(x.z, 2);
    ranks_.sum(sums);
    first_[k] = std::clamp(sums[0] / sums[1] - most_slabs / 2, first_[k],
                           first_[k] + count_[k] - most_slabs);
    count_[k] = most_slabs;
  }
}

double Partition::balance(const std::vector<Vec3>& own, double tolerance, bool always) {
  const auto ranks = static_cast<std::size_t>(ranks_.size());
  if (ranks == 1) {
    end_.assign(1, 0);
    return 1.0;
  }
  double worst = 1.0;
  if (!always) {
    std::vector<std::int64_t> loads(ranks, 0);
    for (const auto& x : own) ++loads[static_cast<std::size_t>(owner(x))];
    ranks_.sum(loads);
    const auto total = std::accumulate(loads.begin(), loads.end(), std::int64_t{0});
    const auto fullest = *std::ranges::max_element(loads);
    worst = total > 0 ? static_cast<double>(fullest) * static_cast<double>(ranks) /
                            static_cast<double>(total)
                      : 1.0;
    if (worst <= tolerance) return worst;
  }
  measure(own);
  std::vector<std::int64_t> beads(static_cast<std::size_t>(count_[0] * count_[1]), 0);
  for (const auto& x : own) {
    ++beads[static_cast<std::size_t>(row(slab(x.z, 2), slab(x.y, 1)))];
  }
  ranks_.sum(beads);
  const auto total = std::accumulate(beads.begin(), beads.end(), std::int64_t{0});
  end_.assign(ranks, count_[0] * count_[1]);
  std::int64_t before = 0;
  std::size_t rank = 0;
  for (std::size_t r = 0; r < beads.size() && rank + 1 < ranks; ++r) {
    before += beads[r];
    // A rank ends where the beads so far are its share of all.
    while (rank + 1 < ranks && before * static_cast<std::int64_t>(ranks) >=
                                   total * static_cast<std::int64_t>(rank + 1)) {
      end_[rank++] = static_cast<std::int64_t>(r) + 1;
    }
  }
  return worst;
}

}  // namespace packbed::dem
