// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The liquid between two steps as plain records, by numbers of the whole mesh: for checkpoints and for
/// ranks that own cells anew.

#include <cstdint>
#include <vector>

#include "core/vec3.hpp"

namespace packbed::fluid {

struct CellRecord {
  std::int64_t cell = 0;  ///< number in the whole mesh
  double eps = 1.0;
  double p = 0.0;  ///< dynamic pressure [Pa]
  Vec3 u{};        ///< interstitial [m/s]
  Vec3 grad_p{};   ///< [Pa/m]
  Vec3 force{};    ///< convective and viscous, per volume [N/m3]
  Vec3 drag{};     ///< on the liquid, per volume [N/m3]
};

struct FaceRecord {
  std::int64_t face = 0;     ///< Domain::face_number
  std::int64_t owner = 0;    ///< cell
  double q = 0.0;            ///< normal superficial velocity [m/s]
  double flux = 0.0;         ///< volume, relative to the face [m3/s]
  double pressure = 0.0;     ///< dynamic; of border faces [Pa]
  double conductance = 0.0;  ///< by which the preconditioner was made; 0 if there is none
};

struct FluidState {
  double time = 0.0;        ///< [s]
  double top = 0.0;         ///< z of the upper end of the mesh [m]
  double inlet = 0.0;       ///< superficial velocity there [m/s]
  double per_decade = 0.0;  ///< iterations per decade of the preconditioner when it was new
  std::vector<CellRecord> cells{};
  std::vector<FaceRecord> faces{};
};

}  // namespace packbed::fluid
