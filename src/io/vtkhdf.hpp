// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Meshes with data for ParaView: VTKHDF 1.0, type UnstructuredGrid, which ParaView 5.11 and
/// VTK 9.1 read from files ending in .hdf.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/vec3.hpp"

namespace packbed::io {

/// Values at points or cells, one for each; a view of the caller's data. The name has the unit:
/// "velocity_m_s".
struct FrameArray {
  std::string name;
  std::variant<std::span<const double>,
               std::span<const Vec3>,
               std::span<const std::int64_t>,
               std::span<const std::int32_t>,
               std::span<const std::uint8_t>>
      values;
};

/// Numbers of VTK for the shapes of cells.
enum class CellShape : std::uint8_t { vertex = 1, line = 3, quadrilateral = 9, hexahedron = 12 };

/// A mesh of cells of one shape. Views of the caller's data.
struct UnstructuredGrid {
  CellShape shape = CellShape::vertex;
  std::span<const Vec3> points;                         ///< [m]
  std::span<const std::int64_t> connectivity;           ///< points of each cell, in VTK's order
  std::vector<FrameArray> point_data;                   ///< one value per point
  std::vector<FrameArray> cell_data;                    ///< one value per cell
  std::vector<std::pair<std::string, double>> numbers;  ///< of the whole: {"time_s", 0.5}
};

/// How numbers are stored.
struct FrameOptions {
  bool double_precision = false;  ///< positions and real values with 64 bits instead of 32
  int deflate = 0;                ///< compression by zlib, 0 (none) to 9
};

/// Writes the whole file or nothing: it is made in memory, written under a temporary name and
/// renamed. Throws DataError if it cannot be written. The same data give the same bytes.
void write_unstructured_grid(const std::filesystem::path& file,
                             const UnstructuredGrid& grid,
                             const FrameOptions& options = {});

}  // namespace packbed::io
