// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/cell_partition.hpp"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace packbed::mesh {
namespace {

// A bed in the lower half: 0 to 9 beads per cell, none above.
std::vector<std::int64_t> beads_of_a_bed(std::size_t cells) {
  std::vector<std::int64_t> beads(cells, 0);
  for (std::size_t c = 0; c < cells / 2; ++c) {
    beads[c] = static_cast<std::int64_t>(10.0 * uniform(3, Stream::bead_position, c));
  }
  return beads;
}

std::int64_t load(const CellPartition& p, int rank, const std::vector<std::int64_t>& weights) {
  return std::accumulate(weights.begin() + p.first(rank), weights.begin() + p.last(rank),
                         std::int64_t{0});
}

TEST(CellPartition, GivesEveryCellOneOwnerInOrder) {
  const CellPartition p(1000, 7);

  EXPECT_EQ(p.first(0), 0);
  EXPECT_EQ(p.last(6), 1000);
  for (int r = 0; r < 7; ++r) {
    EXPECT_EQ(p.owner(p.first(r)), r);
    EXPECT_EQ(p.owner(p.last(r) - 1), r);
  }
}

// Each cut misses its share by half the heaviest cell at most.
TEST(CellPartition, BalancesToTheHeaviestCell) {
  const auto weights = cell_weights(beads_of_a_bed(5000), {.per_bead = 10, .per_cell = 3});
  const auto heaviest = *std::ranges::max_element(weights);
  const auto total = std::accumulate(weights.begin(), weights.end(), std::int64_t{0});
  for (const int ranks : {1, 2, 3, 4, 16, 61}) {
    CellPartition p(5000, ranks);

    p.cut(weights);

    std::int64_t sum = 0;
    for (int r = 0; r < ranks; ++r) {
      EXPECT_LE(load(p, r, weights) * ranks, total + heaviest * ranks) << r << " of " << ranks;
      sum += load(p, r, weights);
    }
    EXPECT_EQ(sum, total);
    EXPECT_LE(p.imbalance(weights),
              1.0 + static_cast<double>(heaviest * ranks) / static_cast<double>(total));
  }
}

TEST(CellPartition, WeighsBeadsAndCells) {
  EXPECT_EQ(cell_weights(std::vector<std::int64_t>{0, 2}, {.per_bead = 10, .per_cell = 3}),
            (std::vector<std::int64_t>{3, 23}));
}

TEST(CellPartition, IsCutAnewOnlyBeyondTheTolerance) {
  CellPartition p(4, 2);
  EXPECT_FALSE(p.balance(std::vector<std::int64_t>{6, 5, 5, 4}, 1.1));  // 11 of 10
  EXPECT_EQ(p.first(1), 2);
  EXPECT_TRUE(p.balance(std::vector<std::int64_t>{9, 6, 5, 0}, 1.1));  // 15 of 10
  EXPECT_EQ(p.first(1), 1);
}

TEST(CellPartition, LeavesNoRankWithoutACell) {
  CellPartition p(5, 4);
  for (const auto& weights : {std::vector<std::int64_t>{9, 0, 0, 0, 0}, {0, 0, 0, 0, 9}}) {
    p.cut(weights);
    for (int r = 0; r < 4; ++r) EXPECT_GT(p.last(r), p.first(r)) << r;
  }
}

TEST(CellPartition, TakesMoreRanksThanCells) {
  CellPartition p(2, 5);
  p.cut(std::vector<std::int64_t>{1, 1});
  std::int64_t owned = 0;
  for (int r = 0; r < 5; ++r) owned += p.last(r) - p.first(r);
  EXPECT_EQ(owned, 2);
  EXPECT_EQ(p.last(p.owner(0)), p.first(p.owner(0)) + 1);
}

TEST(CellPartition, StaysAsItIsWithoutLoad) {
  CellPartition p(10, 2);
  p.cut(std::vector<std::int64_t>(10, 0));
  EXPECT_EQ(p.first(1), 5);
  EXPECT_EQ(p.imbalance(std::vector<std::int64_t>(10, 0)), 1.0);
}

}  // namespace
}  // namespace packbed::mesh
