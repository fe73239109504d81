// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The mesh of a column as a whole: a cross-section repeated in equal layers from the outlet (z = 0) to
/// the top (inlet, plunger). It is small, so every rank has all of it; the arrays of the cells that a
/// rank works on are made by mesh_part.hpp.

#include <cstdint>
#include <optional>
#include <vector>

#include "core/vec3.hpp"
#include "mesh/cell_counts.hpp"
#include "mesh/column_shape.hpp"
#include "mesh/cross_section.hpp"
#include "mesh/section_locator.hpp"

namespace packbed::mesh {

/// Cell c of layer k has the number k cells_per_layer + c: layer by layer from the outlet up, within a
/// layer as in the cross-section.
class ColumnMesh {
 public:
  ColumnMesh(const ColumnShape& shape, const CellCounts& counts);

  [[nodiscard]] const CrossSection& section() const { return section_; }
  [[nodiscard]] std::int32_t layers() const { return layers_; }
  [[nodiscard]] std::int64_t cells_per_layer() const { return section_.cell_count(); }
  [[nodiscard]] std::int64_t cell_count() const { return layers_ * cells_per_layer(); }
  /// Whether the top layer lies under the lowest one: a box that is periodic in z, of two layers or more.
  [[nodiscard]] bool is_periodic_in_z() const { return periodic_z_; }

  [[nodiscard]] double top() const { return top_; }  ///< z of the upper end [m]
  /// Stretches all layers alike, so that the upper end is at z > 0 [m]. Numbers and neighbors stay. Must
  /// not be called on a mesh that is periodic in z.
  void set_top(double z);
  /// z of the lower side of layer k [m]; that of layer layers() is the top.
  [[nodiscard]] double level(std::int32_t k) const { return level(k, top_); }
  /// The same, with the top elsewhere.
  [[nodiscard]] double level(std::int32_t k, double top) const { return top * k / layers_; }

  [[nodiscard]] double volume(std::int64_t cell) const;  ///< [m3]
  [[nodiscard]] Vec3 center(std::int64_t cell) const;    ///< centroid [m]

  /// The cell that holds a point [m]. On a face, edge or corner it is the lowest-numbered of the cells there.
  /// Points between a facet and the round wall, or outside by less than a hundredth of a cell (rounding)
  /// belong to the cell at the border, as told at SectionLocator. Nothing for points farther outside; a
  /// periodic side is a border too, so wrap points first.
  [[nodiscard]] std::optional<std::int64_t> cell_at(const Vec3& x) const;
  /// The same for points anywhere: those outside count as the nearest point of the bounding box.
  [[nodiscard]] std::int64_t nearest_cell(const Vec3& x) const;
  /// Layer of a height; the lowest or highest one for points outside.
  [[nodiscard]] std::int32_t layer_at(double z) const;
  [[nodiscard]] const SectionLocator& locator() const { return locator_; }

  /// Cells that share a corner with a cell, itself and periodic images included, in rising order.
  [[nodiscard]] std::vector<std::int64_t> vertex_neighbors(std::int64_t cell) const;

 private:
  CrossSection section_;
  SectionLocator locator_;
  std::int32_t layers_;
  bool periodic_z_;
  double top_;
  std::optional<double>
      radius_;    ///< of a round column, or of its wall points, whichever is larger [m]
  double slack_;  ///< how far outside a point may be [m]
};

}  // namespace packbed::mesh
