// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The one matrix between beads and cells: w_ic = integral of a smooth compact kernel around bead i over cell
/// c, over its integral over the column. Rows add up to 1, so that no volume, momentum or force is lost, and
/// they change smoothly when a bead moves. A row is the product of shares in the plane and along z.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/vec3.hpp"
#include "coupling/section_weights.hpp"
#include "mesh/column_mesh.hpp"

namespace packbed::coupling {

struct WeightOptions {
  double reach = 0.0;    ///< of the kernel in the plane [m]
  double reach_z = 0.0;  ///< along z [m]
};

class Weights {
 public:
  /// Throws ValueError for a reach that is not positive or beyond half a periodic length.
  Weights(const mesh::ColumnMesh& mesh,
          const mesh::ColumnShape& shape,
          const WeightOptions& options);

  /// Rows for beads at these centers [m]. `mesh` is that of the constructor, perhaps stretched since.
  void set_rows(const mesh::ColumnMesh& mesh, std::span<const Vec3> centers);
  /// Whether there is one cell in y, which does not count.
  [[nodiscard]] bool is_empty_y() const { return is_empty_y_; }
  [[nodiscard]] std::size_t rows() const { return layer_first_.size(); }

  /// Calls visit(cell of the whole mesh, w_ic) for each cell of row i.
  template <class Visit>
  void for_each(std::size_t i, Visit visit) const {
    for (std::size_t k = 0; k < layers_per_row_; ++k) {
      const double along = layer_weight_[i * layers_per_row_ + k];
      if (along == 0.0) continue;
      const std::int64_t layer = (layer_first_[i] + static_cast<std::int64_t>(k)) % layers_;
      for (auto e = plane_first_[i]; e < plane_first_[i + 1]; ++e) {
        visit(layer * cells_per_layer_ + plane_[e].cell, along * plane_[e].weight);
      }
    }
  }

  /// How many layers a row may reach up or down from that of its bead.
  [[nodiscard]] std::int64_t reach_in_layers(const mesh::ColumnMesh& mesh) const;

 private:
  void set_layers(const mesh::ColumnMesh& mesh, double z, std::size_t i);

  SectionWeights section_;
  bool is_empty_y_;
  double reach_z_;
  std::int64_t layers_;
  std::int64_t cells_per_layer_;
  bool periodic_z_;
  std::size_t layers_per_row_ = 0;
  std::vector<std::int32_t> layer_first_{};
  std::vector<double> layer_weight_{};      ///< layers_per_row_ per row
  std::vector<std::size_t> plane_first_{};  ///< of each row in plane_, and the end
  std::vector<CellWeight> plane_{};
};

}  // namespace packbed::coupling
