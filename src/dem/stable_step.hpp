// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The largest time step at which a bed of beads stays at rest.

#include <cstdint>

#include "dem/force_pass.hpp"

namespace packbed::dem {

inline constexpr double rotation_share = 0.4;     ///< I / (m R^2) of a sphere
inline constexpr double touching_overlap = 0.01;  ///< of R*: what beads that just touch will see

/// Largest stable step of an oscillator, the root of step^2 w2 + 2 step c = 4 [s]; w2 [1/s2], c [1/s].
/// Infinite without a spring.
double largest_step(double w2, double c);

/// The bead that limits the step, and how.
struct StableStep {
  double step = 0.0;       ///< [s]; infinite if nothing touches
  std::int64_t bead = -1;  ///< id of the bead that limits it
  int contacts = 0;        ///< that this bead has
  Vec3 x = {};             ///< where it is [m]
  bool of_all = false;     ///< all its contacts together limit it, not a single one
};

/// The smaller of, for each bead,
///   the limit of its contacts together, step^2 w^2 + 2 step c = 4 with w^2 = sum k / (0.4 m),
///   c = sum gamma / (0.4 m): fitted to where beds begin to boil, by rotation on the tangential
///   springs (I = 0.4 m R^2);
///   the limit of each sticking contact alone, exact: w^2 = 3.5 k / m*, c = 3.5 gamma / m*.
/// Stiffness and damping are those at the present overlap, or at 1 % of R* if that is more.
/// On several ranks: of this rank's beads.
StableStep stable_step(const ContactModel& model,
                       const Particles& particles,
                       const ContactList& contacts,
                       const std::vector<Wall>& walls,
                       const std::vector<WallContacts>& wall_contacts);

}  // namespace packbed::dem
