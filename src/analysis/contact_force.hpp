// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Contacts as the statistics of forces see them: what a frame on disk holds of each, and what a running
/// `Dem` tells. All functions of this folder that take them, as those of `velocity_variance.hpp`,
/// `granular_temperature.hpp`, `rearrangement.hpp` and `void_sizes.hpp`, work on the data of the whole bed
/// in one process, where frames and contacts are gathered; nothing is exchanged between ranks. They add in
/// the order of the input. Without contacts figures are 0 and lists empty, never NaN.

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/coordination.hpp"
#include "core/vec3.hpp"
#include "dem/contact_report.hpp"

namespace packbed::analysis {

/// One touching contact. Each contact of the bed is there once, told from either of its beads.
struct ContactForce {
  std::int64_t i = 0;
  std::int64_t j = 0;       ///< < 0: a wall, -1 - its number
  Vec3 x;                   ///< center of bead i [m]
  Vec3 branch;              ///< from there to the center of bead j's image, or to the wall [m]
  double normal = 0.0;      ///< normal force, positive where they push [N]
  double tangential = 0.0;  ///< amount of the tangential force [N]
  double overlap = 0.0;     ///< [m]

  [[nodiscard]] bool with_wall() const { return j < 0; }
};

/// Contacts that a `Dem` reports, in their order.
std::vector<ContactForce> contact_forces(std::span<const dem::ContactReport> contacts);

/// Their tangential forces on beads i [N], which frames do not hold; for `stress_profile`.
std::vector<Vec3> tangential_forces(std::span<const dem::ContactReport> contacts);

/// For `coordination` and `contact_changes`: the same contacts by ids, every wall as wall_id.
std::vector<TouchingPair> touching_pairs(std::span<const ContactForce> contacts);

/// Unit vector along the branch; zero if that has no length.
Vec3 contact_normal(const ContactForce& contact);

/// Contacts between beads that push, on which all statistics of forces rest: F > 0. The rest (walls,
/// and beads that touch while damping or adhesion leaves no push) is left out and can be counted.
inline bool pushes(const ContactForce& contact) {
  return !contact.with_wall() && contact.normal > 0.0;
}

/// Mean of F over them [N].
double mean_force(std::span<const ContactForce> contacts);

}  // namespace packbed::analysis
