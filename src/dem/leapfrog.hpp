// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// One step of the beads: v(n + 1/2) = v(n - 1/2) + kick F / m, x(n + 1) = x(n) + drift v(n + 1/2),
/// spins likewise. A background damping c acts on the mean of old and new velocity, the drag of a liquid on
/// the new one (implicit Euler: stable and monotone however stiff it is).

#include "dem/particles.hpp"

namespace packbed::dem {

struct Leapfrog {
  double kick;     ///< over which forces act: the mean of the last and this step [s]
  double drift;    ///< over which velocities act: this step [s]
  double damping;  ///< c [1/s]
};

/// Moves the beads [first, last) and sets their loads back to their weights. Returns the largest
/// displacement since the reference positions in each direction; NaN if one is.
Vec3 move_beads(Particles& particles, std::size_t first, std::size_t last, const Leapfrog& step);

}  // namespace packbed::dem
