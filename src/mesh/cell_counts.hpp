// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// How many cells a column mesh has in each direction.

#include <cstdint>
#include <optional>

#include "mesh/column_shape.hpp"

namespace packbed::mesh {

/// What a user asks for: a size of cells, and numbers where they are to be exact.
struct MeshOptions {
  double cell = 0.35e-3;                  ///< aimed at in every direction [m]
  std::optional<std::int64_t> cells_x{};  ///< of a slice or box
  std::optional<std::int64_t> cells_y{};  ///< of a slice or box
  std::optional<std::int64_t> core{};     ///< of a cylinder: along a side of the middle block
  std::optional<std::int64_t> ring{};     ///< of a cylinder: from the middle block to the wall
  std::optional<std::int64_t> layers{};   ///< in z
  bool operator==(const MeshOptions&) const = default;
};

struct CellCounts {
  std::int32_t x = 0;       ///< slice and box; 0 for a cylinder
  std::int32_t y = 0;       ///< slice and box; 0 for a cylinder
  std::int32_t core = 0;    ///< cylinder
  std::int32_t ring = 0;    ///< cylinder
  std::int32_t layers = 1;  ///< in z

  [[nodiscard]] std::int64_t per_layer() const {
    return core > 0 ? std::int64_t{core} * core + std::int64_t{4} * core * ring
                    : std::int64_t{x} * y;
  }
  [[nodiscard]] std::int64_t all() const { return per_layer() * layers; }
};

inline constexpr double most_cells_per_layer = 1e6;
inline constexpr double most_cells = 2e8;  ///< corners and faces still count in 32 bits

/// Whole numbers of cells nearest to the size asked for, at least one (core: two) in every direction.
/// A slice has one cell in y, the five blocks half as many cells in a ring as in the core, unless
/// given. Throws ValueError if there are more than `most_cells` or `most_cells_per_layer`.
CellCounts cell_counts(const ColumnShape& shape, const MeshOptions& options);

}  // namespace packbed::mesh
