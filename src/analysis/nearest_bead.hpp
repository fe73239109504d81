// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The bead whose surface is nearest to a point, found over a grid of cells.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "analysis/bead.hpp"

namespace packbed::analysis {

class NearestBead {
 public:
  /// At least one bead. Periods [m]; 0: not periodic along this axis.
  NearestBead(std::span<const Bead> beads, const Vec3& period);

  /// From a point to the nearest surface of a bead [m]; inside a bead some value <= 0, not always the lowest.
  [[nodiscard]] double distance(const Vec3& point) const;

 private:
  struct Ball {
    Vec3 x;
    double radius = 0.0;
  };
  using Cell = std::array<int, 3>;

  void lay_cells_out(std::span<const Bead> beads);
  void sort_in(std::span<const Bead> beads);
  [[nodiscard]] Cell cell_of(const Vec3& point) const;
  void wrap(Cell& cell, Vec3& shift) const;
  [[nodiscard]] std::size_t index_of(const Cell& cell) const;
  void look_at(Cell cell, const Vec3& point, double& nearest) const;

  std::array<double, 3> low_{};
  std::array<double, 3> width_{};  ///< of a cell [m]
  std::array<double, 3> period_{};
  std::array<int, 3> count_{};  ///< cells
  double largest_radius_ = 0.0;
  std::vector<std::size_t> first_;  ///< balls of cell c: first_[c] to first_[c + 1] - 1
  std::vector<Ball> balls_;
};

}  // namespace packbed::analysis
