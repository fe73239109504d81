// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The time step before a bed exists, from the beads alone.

#include <vector>

#include "dem/contact/contact_law.hpp"
#include "dem/particles.hpp"
#include "dem/walls.hpp"

namespace packbed::dem {

struct StepChoice {
  double step;                       ///< recommended [s]
  double contact_time;               ///< of the shortest contact, undamped [s]
  double contact_time_per_diameter;  ///< the least, over the diameter of its bead [s/m]
  double smallest_diameter;          ///< [m]
  double stable_in_a_bed;            ///< estimate with `bed_contacts` contacts per bead [s]
};

/// Contacts of a bead in a compressed bed, for the estimate.
inline constexpr int bed_contacts = 8;
/// Fewest steps that a contact may take.
inline constexpr double fewest_steps_per_contact = 10.0;

/// The smaller of 0.8 times the stable step of the most delicate bead in a bed (see stable_step.hpp)
/// and the shortest contact over `fewest_steps_per_contact`. Each bead meets one like itself (contact
/// time), one of mean size (bed) and the walls. Infinite for no beads.
StepChoice choose_step(const ContactLaw& law,
                       const std::vector<BeadProperties>& beads,
                       const std::vector<Material>& walls,
                       double inertia_scale);

}  // namespace packbed::dem
