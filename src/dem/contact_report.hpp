// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Touching contacts with their forces, evaluated when they are asked for: for frames, force chains
/// and statistics.

#include <cstdint>
#include <vector>

#include "core/vec3.hpp"

namespace packbed::dem {

/// One touching contact at the present positions, with the velocities of the last half step.
struct ContactReport {
  std::int64_t id_i = 0;
  std::int64_t id_j = 0;  ///< -1 - number of the wall, for a wall
  Vec3 x;                 ///< center of bead i [m]
  Vec3 branch;            ///< from there to the center of bead j's image, or to the wall [m]
  Vec3 normal;            ///< normal force on i [N]
  Vec3 tangential;        ///< tangential force on i [N]
  double overlap = 0.0;   ///< [m]
};

}  // namespace packbed::dem
