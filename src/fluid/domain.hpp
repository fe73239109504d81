// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The cells and faces on which a rank solves for the liquid.

#include <cstdint>
#include <span>
#include <vector>

#include "core/ranks.hpp"
#include "fluid/cell_halo.hpp"
#include "fluid/geometry.hpp"
#include "mesh/cell_partition.hpp"
#include "mesh/column_mesh.hpp"
#include "mesh/mesh_part.hpp"

namespace packbed::fluid {

struct Domain {
  /// All ranks make theirs at once. The partition has as many ranks as there are.
  Domain(const mesh::ColumnMesh& of, const mesh::CellPartition& partition, const Ranks& all);

  mesh::ColumnMesh mesh;
  mesh::MeshPart part;
  Geometry geometry;
  Ranks ranks;
  CellHalo halo;

  [[nodiscard]] std::size_t own() const { return static_cast<std::size_t>(part.own); }
  [[nodiscard]] std::size_t cells() const { return part.cell.size(); }
  [[nodiscard]] std::size_t faces() const { return part.owner.size(); }
  [[nodiscard]] std::size_t inner() const { return static_cast<std::size_t>(part.inner); }
  [[nodiscard]] std::size_t owner(std::size_t f) const {
    return static_cast<std::size_t>(part.owner[f]);
  }
  [[nodiscard]] std::size_t neighbor(std::size_t f) const {
    return static_cast<std::size_t>(part.neighbor[f]);
  }
  [[nodiscard]] bool is_own(std::size_t cell) const { return cell < own(); }

  /// Stretches the mesh; returns the velocity [m/s] of each face along its normal, while the top moves
  /// there within `dt` [s].
  std::vector<double> move_top(double z, double dt);

  /// Number of a face in the whole mesh, the same on every rank.
  [[nodiscard]] std::int64_t face_number(std::size_t f) const;
};

/// What passes each own cell: half the sum of the sizes of its fluxes, one per face.
std::vector<double> throughflow(const Domain& domain, std::span<const double> flux);

}  // namespace packbed::fluid
