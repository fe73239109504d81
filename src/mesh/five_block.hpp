// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Round cross-section of five blocks: a square in the middle with bulged sides, and four blocks
/// between it and the wall (thesis fig. 5.6, "O-grid").

#include <cstdint>

#include "mesh/cross_section.hpp"

namespace packbed::mesh {

/// Distance of the wall points from the axis [m] that makes the polygon of 4 `core` facets as large as
/// the disc of `radius` [m].
double wall_point_radius(double radius, std::int32_t core);

/// core x core cells in the middle and core x ring in each of the other blocks, so core^2 + 4 core ring
/// in all: 588 of the thesis's table 5.2 with 14 and 7. The area of the mesh is that of the disc.
///
/// Cells are numbered row by row from y < 0 to y > 0, as if the corners were cut from a square: the
/// lower block from the wall inwards, then rows through left block, middle and right block, then the
/// upper block outwards. A run of numbers is thus a strip across the column.
CrossSection five_block_section(double radius, std::int32_t core, std::int32_t ring);

}  // namespace packbed::mesh
