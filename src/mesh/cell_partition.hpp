// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Which rank owns which cells: the cells in their order are cut into one run per rank. Weights are counts
/// (beads in a cell and a constant), never times, so every run of a case is cut alike.

#include <cstdint>
#include <span>
#include <vector>

namespace packbed::mesh {

/// Work of a cell, in any unit.
struct CellWork {
  std::int64_t per_bead = 1;
  std::int64_t per_cell = 0;
};

/// Weight of each cell from the number of beads in it.
std::vector<std::int64_t> cell_weights(std::span<const std::int64_t> beads, const CellWork& work);

class CellPartition {
 public:
  /// Cuts equal runs. `ranks` >= 1 need not be the ranks of the program.
  CellPartition(std::int64_t cells, int ranks);

  /// Rank that owns a cell.
  [[nodiscard]] int owner(std::int64_t cell) const;
  [[nodiscard]] std::int64_t first(int rank) const { return cut_[static_cast<std::size_t>(rank)]; }
  /// Behind the last cell of a rank.
  [[nodiscard]] std::int64_t last(int rank) const {
    return cut_[static_cast<std::size_t>(rank) + 1];
  }
  [[nodiscard]] int ranks() const { return static_cast<int>(cut_.size()) - 1; }

  /// Load of the fullest rank over the mean; 1 if there is no load.
  [[nodiscard]] double imbalance(std::span<const std::int64_t> weights) const;

  /// Cuts anew, each cut where the weight before it is nearest to its share of all: no rank then exceeds
  /// the mean by more than the heaviest cell. Every rank keeps at least one cell if there are enough.
  void cut(std::span<const std::int64_t> weights);

  /// Cuts anew if the imbalance exceeds `tolerance`; whether it did.
  bool balance(std::span<const std::int64_t> weights, double tolerance);

  bool operator==(const CellPartition&) const = default;

 private:
  std::vector<std::int64_t> cut_;  ///< first cell of each rank, and the end
};

}  // namespace packbed::mesh
