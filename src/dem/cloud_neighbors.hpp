// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Pairs of near beads of a cloud, in little memory: a row for each bead, with
/// its neighbors that are smaller (or as large and of lower index), each with its image.

#include <cstdint>
#include <span>
#include <vector>

#include "dem/cloud_room.hpp"

namespace packbed::dem {

struct CloudNeighbor {
  std::int32_t j;
  std::int8_t image[2];  ///< of j over the periodic sides in x and y
};

struct CloudNeighbors {
  std::vector<std::int64_t> first;  ///< row of bead i: [first[i], first[i + 1])
  std::vector<CloudNeighbor> list;
};

/// All pairs, images of their own, with |x_i - x_j| < scale (R_i + R_j) + skin. Lengths in m.
CloudNeighbors find_cloud_neighbors(const Room& room,
                                    std::span<const Vec3> x,
                                    std::span<const double> diameters,
                                    double scale,
                                    double skin);

}  // namespace packbed::dem
