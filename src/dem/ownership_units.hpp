// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Pieces of space by which beads belong to ranks. They are numbered, and a rank owns a run of numbers
/// (partition.hpp); every point of space is in one of them.

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/ranks.hpp"
#include "core/vec3.hpp"
#include "dem/domain.hpp"
#include "mesh/column_mesh.hpp"

namespace packbed::dem {

/// Units first, first + 1, ... last.
struct UnitRange {
  std::int64_t first;
  std::int64_t last;
};

/// Rows (z-slab, y-row) of the key grid, z slowest, over the range that has beads. Rows beyond belong to
/// the nearest one in the range.
class RowUnits {
 public:
  /// `cell` as in key_order.
  RowUnits(const Domain& domain, double cell) : domain_(domain), cell_(cell) {}

  /// Numbers the rows anew for the beads of all ranks. `own` are the centers of this rank's.
  void fit(const std::vector<Vec3>& own, const Ranks& ranks);
  [[nodiscard]] std::int64_t count() const { return count_[0] * count_[1]; }
  [[nodiscard]] std::int64_t unit(const Vec3& x) const;

  /// Units that may hold a point within `reach` of x, periodic sides included; and the same in whole
  /// slabs, which is quickly told.
  [[nodiscard]] std::vector<UnitRange> within(const Vec3& x, double reach) const;
  [[nodiscard]] std::vector<UnitRange> slabs_within(const Vec3& x, double reach) const;

 private:
  [[nodiscard]] std::int64_t slab(double a, std::size_t axis) const;
  [[nodiscard]] std::int64_t row(std::int64_t z, std::int64_t y) const;

  Domain domain_;
  double cell_;
  std::array<std::int64_t, 2> first_{};  ///< lowest y-row and z-slab with beads
  std::array<std::int64_t, 2> count_ = {1, 1};
};

/// Cells of the mesh of a column, where beads and liquid are to be shared alike. Its periodic sides
/// are those of the domain. The mesh may be stretched between renewals of the lists.
class CellUnits {
 public:
  CellUnits(const Domain& domain, std::shared_ptr<const mesh::ColumnMesh> mesh)
      : domain_(domain), mesh_(std::move(mesh)) {}

  void fit(const std::vector<Vec3>& /*own*/, const Ranks& /*ranks*/) {}
  [[nodiscard]] std::int64_t count() const { return mesh_->cell_count(); }
  [[nodiscard]] std::int64_t unit(const Vec3& x) const { return mesh_->nearest_cell(x); }

  /// As those of RowUnits; slabs are layers.
  [[nodiscard]] std::vector<UnitRange> within(const Vec3& x, double reach) const;
  [[nodiscard]] std::vector<UnitRange> slabs_within(const Vec3& x, double reach) const;

 private:
  Domain domain_;
  std::shared_ptr<const mesh::ColumnMesh> mesh_;
};

}  // namespace packbed::dem
