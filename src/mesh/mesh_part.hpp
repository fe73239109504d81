// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The cells of a mesh that one rank works on, their halo and their faces, as flat arrays: what a
/// finite-volume loop runs over.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/vec3.hpp"
#include "mesh/column_mesh.hpp"

namespace packbed::mesh {

/// What a face is made of; its metrics follow from it whenever the mesh is stretched.
struct FaceSource {
  enum class Kind : std::uint8_t { level, inner_edge, border_edge };
  Kind kind;
  std::int32_t index;  ///< level: cell of the cross-section; else the edge, inner or of the border
  std::int32_t layer;  ///< level: the layer above the face; else that of the face
};

/// A run of faces of one patch.
struct PatchFaces {
  Patch patch;
  std::int32_t first;
  std::int32_t count;
};

/// Part of a mesh. Cells: own ones in the order of the mesh, then the halo in the same order. Faces: all
/// with an own cell; first those between two cells, ordered by owner and neighbor, then those at the
/// border, patch by patch. The owner is the cell with the lower number in the whole mesh, so a face
/// looks the same way on every rank. SI units.
struct MeshPart {
  // --- cells
  std::int32_t own = 0;              ///< number of own cells
  std::vector<std::int64_t> cell{};  ///< number in the whole mesh
  std::vector<Vec3> center{};        ///< centroid [m]
  std::vector<double> volume{};      ///< [m3]
  std::vector<std::array<std::int32_t, 8>>
      corners{};               ///< of `points`: lower side counterclockwise, upper side
  std::vector<Vec3> points{};  ///< [m]
  std::vector<std::int64_t>
      point{};  ///< number of each point: level x points of the section + point

  // --- faces
  std::int32_t inner = 0;                ///< number of faces between two cells
  std::vector<std::int32_t> owner{};     ///< one per face
  std::vector<std::int32_t> neighbor{};  ///< one per inner face
  std::vector<Vec3> area{};              ///< from owner to neighbor, or outward [m2]
  std::vector<Vec3> face_center{};       ///< on the owner's side where a side is periodic [m]
  std::vector<Vec3> delta{};  ///< from the owner to its neighbor's image, or to the face [m]
  std::vector<FaceSource> source{};
  std::vector<PatchFaces> patches{};  ///< in the order of Patch, those that have faces

  [[nodiscard]] std::int32_t cell_count() const { return static_cast<std::int32_t>(cell.size()); }
  [[nodiscard]] std::int32_t face_count() const { return static_cast<std::int32_t>(owner.size()); }
};

/// Cells [first, last) of the mesh with their vertex neighbors as halo.
MeshPart mesh_part(const ColumnMesh& mesh, std::int64_t first, std::int64_t last);

/// The whole mesh, without halo.
MeshPart whole(const ColumnMesh& mesh);

/// Foreign cells that share a corner with cells [first, last), `rings` times over, in rising order.
std::vector<std::int64_t> halo_cells(const ColumnMesh& mesh,
                                     std::int64_t first,
                                     std::int64_t last,
                                     int rings = 1);

/// Brings points, centers, volumes, areas and deltas up to date after set_top.
void update_metrics(const ColumnMesh& mesh, MeshPart& part);

/// Volume [m3] that each face sweeps along its area vector while the top moves from `before` to
/// `after` [m]; one per face. What the faces of a cell sweep outward adds up to the growth of its volume
/// (space conservation law). Faces between cells side by side slide in their own plane and sweep nothing.
std::vector<double> swept_volumes(const ColumnMesh& mesh,
                                  const MeshPart& part,
                                  double before,
                                  double after);

}  // namespace packbed::mesh
