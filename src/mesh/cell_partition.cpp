// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/cell_partition.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace packbed::mesh {

std::vector<std::int64_t> cell_weights(std::span<const std::int64_t> beads, const CellWork& work) {
  std::vector<std::int64_t> weights(beads.size());
  std::ranges::transform(beads, weights.begin(),
                         [&](std::int64_t count) { return work.per_bead * count + work.per_cell; });
  return weights;
}

CellPartition::CellPartition(std::int64_t cells, int ranks) {
  for (std::int64_t r = 0; r <= ranks; ++r) cut_.push_back(cells * r / ranks);
}

int CellPartition::owner(std::int64_t cell) const {
  assert(cell >= 0 && cell < cut_.back());
  return static_cast<int>(std::ranges::upper_bound(cut_, cell) - cut_.begin()) - 1;
}

double CellPartition::imbalance(std::span<const std::int64_t> weights) const {
  std::int64_t fullest = 0;
  std::int64_t total = 0;
  for (std::size_t r = 0; r + 1 < cut_.size(); ++r) {
    const auto load =
        std::accumulate(weights.begin() + cut_[r], weights.begin() + cut_[r + 1], std::int64_t{0});
    fullest = std::max(fullest, load);
    total += load;
  }
  return total > 0 ? static_cast<double>(fullest) * ranks() / static_cast<double>(total) : 1.0;
}

void CellPartition::cut(std::span<const std::int64_t> weights) {
  const auto cells = static_cast<std::int64_t>(weights.size());
  const std::int64_t ranks = this->ranks();
  const auto total = std::accumulate(weights.begin(), weights.end(), std::int64_t{0});
  if (total == 0) return;  // nothing to go by
  const std::int64_t least = cells >= ranks ? 1 : 0;
  std::int64_t before = 0;  // weight of the cells before `cell`
  std::int64_t cell = 0;
  for (std::int64_t r = 1; r < ranks; ++r) {
    // Compared in units of 1 / ranks, so that shares are whole.
    const auto missing = [&] { return total * r - before * ranks; };
    const auto take = [&] { before += weights[static_cast<std::size_t>(cell++)]; };
    const auto start = cut_[static_cast<std::size_t>(r) - 1];
    while (cell < start + least) take();
    while (cell < cells - least * (ranks - r) &&
           weights[static_cast<std::size_t>(cell)] * ranks <= 2 * missing()) {
      take();
    }
    cut_[static_cast<std::size_t>(r)] = cell;
  }
}

bool CellPartition::balance(std::span<const std::int64_t> weights, double tolerance) {
  if (imbalance(weights) <= tolerance) return false;
  cut(weights);
  return true;
}

}  // namespace packbed::mesh
