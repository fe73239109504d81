// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Which rank owns which bead: space is cut into numbered units, rows of the key grid or cells of the mesh,
/// and each rank owns a run of them. Beads are ordered alike whoever owns them, so the own beads of a
/// rank need not be a piece of that order.

#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "core/ranks.hpp"
#include "core/vec3.hpp"
#include "dem/domain.hpp"
#include "dem/ownership_units.hpp"
#include "mesh/cell_partition.hpp"

namespace packbed::dem {

class Partition {
 public:
  /// By the cells of `mesh`, or by rows if there is none; `cell` as in key_order.
  Partition(const Domain& domain,
            double cell,
            const Ranks& ranks,
            std::shared_ptr<const mesh::ColumnMesh> mesh = {});

  /// Cuts the units anew if a rank would have more than `tolerance` times the mean work, or if `always`.
  /// `own` are the centers of this rank's beads, `work` what each costs, in whole numbers. Returns the
  /// work of the fullest rank over the mean, before the cut.
  double balance(const std::vector<Vec3>& own,
                 const std::vector<std::int64_t>& work,
                 double tolerance,
                 bool always);

  [[nodiscard]] int owner(const Vec3& x) const;
  /// Ranks that own units within `reach` of a point, periodic sides included, in rising order.
  [[nodiscard]] std::vector<int> owners_within(const Vec3& x, double reach) const;

  /// The runs of units. Those of cells are the partition of the mesh.
  [[nodiscard]] const mesh::CellPartition& runs() const { return runs_; }

 private:
  [[nodiscard]] double fullest_over_mean(const std::vector<Vec3>& own,
                                         const std::vector<std::int64_t>& work) const;

  std::variant<RowUnits, CellUnits> units_;
  Ranks ranks_;
  mesh::CellPartition runs_;
};

}  // namespace packbed::dem
