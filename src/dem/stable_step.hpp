// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The largest time step at which a bed of beads stays at rest.

#include <cstdint>
#include <string_view>

#include "dem/force_pass.hpp"

namespace packbed::dem {

/// The bead that limits the step, and how.
struct StableStep {
  double step;                 ///< [s]; infinite if nothing touches
  std::int64_t bead = -1;      ///< id of the bead that limits it
  int contacts = 0;            ///< that this bead has
  std::string_view mode = "";  ///< "rotation" (on the tangential springs) or "translation"
};

/// Estimate from each bead's own contacts, fitted to where beds begin to boil:
///   step^2 w^2 + 2 step c = 4,  w^2 = sum k / m_mode,  c = sum gamma / m_mode
/// with m_mode = 0.4 m for the rotation on the tangential springs (I = 0.4 m R^2) and m for the
/// translation. Stiffness and damping are those at the present overlap, or at `least_overlap` of
/// the radius if that is more, so that beads about to touch count.
StableStep stable_step(const ContactModel& model,
                       const Particles& particles,
                       const ContactList& contacts,
                       const std::vector<Wall>& walls,
                       const std::vector<WallContacts>& wall_contacts);

}  // namespace packbed::dem
