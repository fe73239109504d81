// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// How far beads are pressed into each other and into walls, and where spheres that touch in pairs stop being a
/// picture of the bed. One process has all beads and contacts.
///
/// A contact law takes its contact for small and alone. At an overlap of 0.1 d two equal beads have a Hertz
/// contact radius sqrt(R* overlap) of 0.32 R, where the theory wants it much smaller than R (Johnson, Contact
/// Mechanics (1985), section 4.1), and from 1 - sqrt(3)/2 = 0.134 d on the caps of three beads that touch each
/// other meet: the throat between them is closed, contacts of a bead act on each other (Brodu, Dijksman and
/// Behringer, Phys. Rev. E 91 (2015) 032201), and volumes that count each lens once are wrong as well.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "analysis/bead.hpp"
#include "analysis/contact_force.hpp"

namespace packbed::analysis {

inline constexpr double large_overlap = 0.1;  ///< of the smaller diameter: laws become doubtful
inline constexpr double very_large_overlap = 0.2;  ///< caps of neighbors meet nearly everywhere

/// A bead and its contacts, walls included. The cap of a contact is what the plane of the common circle cuts
/// off the bead.
struct BeadOverlap {
  std::int64_t id = 0;
  Vec3 x;                  ///< center [m]
  double diameter = 0.0;   ///< [m]
  int contacts = 0;        ///< with beads and walls
  double largest = 0.0;    ///< overlap over the bead's diameter
  double sum = 0.0;        ///< of them
  double capped = 0.0;     ///< volume of all caps over that of the bead; common parts count twice
  bool caps_meet = false;  ///< whether two of its caps have a common part
};

/// One per bead, by id. ValueError if ids are not unique or a contact has a bead that is not there.
std::vector<BeadOverlap> bead_overlaps(std::span<const Bead> beads,
                                       std::span<const ContactForce> contacts);

/// The `count` beads with the largest overlaps, the largest first; equal ones by id.
std::vector<BeadOverlap> most_overlapped(std::span<const BeadOverlap> beads, std::size_t count);

/// Whether the bed can be believed. Overlaps of contacts are over the smaller diameter of the two beads, or over
/// that of the one at a wall.
struct OverlapFigures {
  std::int64_t contacts = 0;      ///< walls included
  double mean = 0.0;              ///< overlap / diameter, mean of contacts
  double largest = 0.0;           ///< overlap / diameter
  double large_share = 0.0;       ///< of contacts above `large_overlap`
  double very_large_share = 0.0;  ///< of contacts above `very_large_overlap`
  std::int64_t caps_meet = 0;     ///< beads
  double capped_share = 0.0;  ///< of beads, with more than `capped_limit` of their volume in caps
};
OverlapFigures overlap_figures(std::span<const Bead> beads,
                               std::span<const ContactForce> contacts,
                               double capped_limit = 0.1);

}  // namespace packbed::analysis
