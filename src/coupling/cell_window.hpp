// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Cell fields where several ranks have a share in a cell: a rank's beads reach into cells of others.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/ranks.hpp"

namespace packbed::coupling {

/// A run of cells of the whole mesh that holds this rank's own cells and those that its beads reach. Values
/// of a window: `width` per cell, in the order of cells.
class CellWindow {
 public:
  /// Rank r owns the cells [cuts[r], cuts[r + 1]). `reach`: how many cells beyond its own a rank's beads may
  /// reach, up and down. Where the mesh is periodic in z every window holds all cells.
  CellWindow(std::vector<std::int64_t> cuts,
             std::int64_t reach,
             bool is_periodic,
             const Ranks& ranks);

  [[nodiscard]] std::int64_t first() const { return windows_[here()].first; }
  [[nodiscard]] std::int64_t last() const { return windows_[here()].last; }  ///< behind the last
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(last() - first()); }
  /// Own cells, as places in the window.
  [[nodiscard]] std::size_t own_first() const {
    return static_cast<std::size_t>(cuts_[here()] - first());
  }
  [[nodiscard]] std::size_t own_last() const {
    return static_cast<std::size_t>(cuts_[here() + 1] - first());
  }

  /// Adds what other ranks have in this rank's own cells to them, in the order of ranks. All ranks call it.
  void add_to_owners(std::span<double> values, std::size_t width) const;
  /// Fills cells that others own with their values. All ranks call it.
  void fill_from_owners(std::span<double> values, std::size_t width) const;

 private:
  struct Run {
    std::int64_t first = 0;
    std::int64_t last = 0;
    [[nodiscard]] std::int64_t size() const { return last > first ? last - first : 0; }
  };
  [[nodiscard]] std::size_t here() const { return static_cast<std::size_t>(ranks_.rank()); }
  /// Cells of rank `owner` in the window of rank `user`.
  [[nodiscard]] Run shared(std::size_t owner, std::size_t user) const;

  std::vector<std::int64_t> cuts_;
  std::vector<Run> windows_{};  ///< of each rank
  Ranks ranks_;
};

}  // namespace packbed::coupling
