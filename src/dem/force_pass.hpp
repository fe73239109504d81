// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The loop over the contacts: forces and torques on the beads, springs moved on by dt.

#include "dem/contact/contact_law.hpp"
#include "dem/contact_list.hpp"
#include "dem/particles.hpp"
#include "dem/rolling/rolling_law.hpp"
#include "dem/walls.hpp"

namespace packbed::dem {

/// How beads touch each other and walls.
struct ContactModel {
  ContactLaw contact;
  RollingLaw rolling;
  double friction = 0.0;  ///< bead on bead
};

/// Adds the forces of the pairs of the blocks [first, last) to the loads. Contacts are added one at
/// a time in the order of the list, so that a bead's sum does not depend on where blocks begin.
void add_contact_forces(const ContactModel& model,
                        ContactList& contacts,
                        std::size_t first,
                        std::size_t last,
                        Particles& particles,
                        double dt);

/// The same for all pairs.
inline void add_contact_forces(const ContactModel& model,
                               ContactList& contacts,
                               Particles& particles,
                               double dt) {
  add_contact_forces(model, contacts, 0, contacts.blocks.size(), particles, dt);
}

/// Adds the forces of one wall to the loads; returns the force on the wall [N].
Vec3 add_wall_forces(const ContactModel& model,
                     const Wall& wall,
                     WallContacts& contacts,
                     Particles& particles,
                     double dt);

}  // namespace packbed::dem
