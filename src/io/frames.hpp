// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Frames of a run for ParaView: beads, the contacts between them, the liquid (docs/manual/output-files.md).
/// One process writes; on several ranks the data are gathered before.

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "core/vec3.hpp"
#include "io/vtkhdf.hpp"
#include "mesh/column_mesh.hpp"

namespace packbed::io {

/// Beads at one time. Views of the caller's data.
struct BeadFrame {
  double time = 0.0;               ///< [s]
  std::span<const Vec3> x;         ///< centers [m]
  std::span<const double> radius;  ///< [m]
  std::span<const std::int64_t> id;
  std::vector<FrameArray> more;  ///< one value per bead: {"velocity_m_s", v}, ...
};

/// Writes beads as points with `radius_m`, `diameter_m`, `id` and the arrays of `more`.
/// Throws DataError if the file cannot be written.
void write_bead_frame(const std::filesystem::path& file,
                      const BeadFrame& frame,
                      const FrameOptions& options = {});

/// A contact as a line. `to` is where the partner is as seen from `from`: for a periodic contact the
/// image that touches, not the bead on the other side of the box.
struct ContactLine {
  Vec3 from;  ///< center of bead i [m]
  Vec3 to;    ///< center of bead j, or the point of the wall that i touches [m]
  std::int64_t id_i = 0;
  std::int64_t id_j = 0;          ///< or wall_id(wall)
  double normal_force = 0.0;      ///< positive where they push [N]
  double tangential_force = 0.0;  ///< amount [N]
  double overlap = 0.0;           ///< [m]
  Vec3 tangential;                ///< force on bead i along the surface [N]
  bool operator==(const ContactLine&) const = default;
};

/// What stands for a wall where ids of beads stand: -1 for wall 0, -2 for wall 1 ...
constexpr std::int64_t wall_id(std::int64_t wall) { return -1 - wall; }

/// Contacts at one time.
struct ContactFrame {
  double time = 0.0;  ///< [s]
  std::span<const ContactLine> contacts;
};

/// Writes contacts as lines with `normal_force_N`, `tangential_force_N`, `tangential_force_vector_N`,
/// `overlap_m`, `id_i` and `id_j`; each has two points of its own. Throws DataError if the file cannot be written.
void write_contact_frame(const std::filesystem::path& file,
                         const ContactFrame& frame,
                         const FrameOptions& options = {});

/// The liquid at one time: the cells of a mesh, one value each, in the order of the mesh.
struct LiquidFrame {
  double time = 0.0;  ///< [s]
  const mesh::ColumnMesh& mesh;
  std::vector<FrameArray> cells;  ///< {"velocity_m_s", u}, ...
};

/// Writes the cells as hexahedra. Throws DataError if the file cannot be written.
void write_liquid_frame(const std::filesystem::path& file,
                        const LiquidFrame& frame,
                        const FrameOptions& options = {});

}  // namespace packbed::io
