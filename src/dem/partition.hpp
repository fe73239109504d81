// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Which rank owns which bead: the rows (z-slab, y-row) of the key grid, in their order, are cut into
/// one run of rows per rank. The order of beads is that of the rows too, so a rank owns a piece of
/// the global order.

#include <array>
#include <cstdint>
#include <vector>

#include "core/ranks.hpp"
#include "core/vec3.hpp"
#include "dem/domain.hpp"

namespace packbed::dem {

class Partition {
 public:
  /// `cell` as in key_order.
  Partition(const Domain& domain, double cell, const Ranks& ranks)
      : domain_(domain), cell_(cell), ranks_(ranks) {}

  /// Cuts the rows anew if a rank would own more than `tolerance` times the mean number of beads, or
  /// if `always`. `own` are the centers of this rank's beads. Returns the load of the fullest rank over
  /// the mean, before the cut.
  double balance(const std::vector<Vec3>& own, double tolerance, bool always);

  [[nodiscard]] int owner(const Vec3& x) const;
  /// Ranks that own rows within `reach` of a point, periodic sides included.
  [[nodiscard]] std::vector<int> owners_within(const Vec3& x, double reach) const;

 private:
  /// y-row and z-slab of a coordinate.
  [[nodiscard]] std::int64_t slab(double a, std::size_t axis) const;
  [[nodiscard]] std::vector<std::int64_t> slabs_within(double a,
                                                       double reach,
                                                       std::size_t axis) const;
  [[nodiscard]] int owner_of_row(std::int64_t z, std::int64_t y) const;
  [[nodiscard]] std::int64_t row(std::int64_t z, std::int64_t y) const;
  void measure(const std::vector<Vec3>& own);

  Domain domain_;
  double cell_;
  Ranks ranks_;
  std::array<std::int64_t, 2> first_{};  ///< lowest y-row and z-slab with beads
  std::array<std::int64_t, 2> count_ = {1, 1};
  std::vector<std::int64_t> end_;  ///< row behind the last one of each rank
};

}  // namespace packbed::dem
