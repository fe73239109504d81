// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// What happened in a bed between two states besides its even compression (thesis section 7.1.2): beads that
/// moved against their neighbors, contacts lost and made. One process has all beads; how far voids closed is
/// told by `void_sizes` of both states.

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/bead.hpp"
#include "analysis/contact_force.hpp"

namespace packbed::analysis {

/// A bead of both states.
struct MovedBead {
  std::int64_t id = 0;
  Vec3 x;      ///< center in the first state [m]
  Vec3 moved;  ///< displacement to the second one [m]
};

struct Displacements {
  std::vector<MovedBead> beads;  ///< by id
  std::int64_t gone = 0;         ///< beads of the first state alone
  std::int64_t come = 0;         ///< beads of the second state alone
};

/// Ids must be unique within a state. Over a periodic side of length `period` (0: not periodic) [m] the
/// shortest displacement is meant: a bead must not have moved by more than half of it.
Displacements displacements(std::span<const Bead> before,
                            std::span<const Bead> after,
                            const Vec3& period);

/// D^2_min of one bead.
struct NonAffine {
  std::int64_t id = 0;
  Vec3 x;               ///< center in the first state [m]
  double square = 0.0;  ///< D^2_min [m2]
};

struct NonAffineMotion {
  std::vector<NonAffine> beads;        ///< by id
  std::int64_t left_out = 0;           ///< beads of both states without enough neighbors
  std::int64_t contacts_left_out = 0;  ///< between beads of which one is not in both states
  double mean_square = 0.0;            ///< of `beads` [m2]
};

/// Falk and Langer's D^2_min with the beads that touched in the first state as neighbors,
///   D^2_min = min over F of 1/n sum over n neighbors of |l' - F l|^2,
/// l the branch to a neighbor in the first state, l' in the second: what no rotation, stretch or shear of the
/// neighborhood explains. A bead needs at least four neighbors that do not lie in a plane with it; beads with
/// fewer are left out and counted. `contacts` are those of the first state; walls do not count.
/// Source: Falk and Langer, Phys. Rev. E 57 (1998) 7192, section II, with contacts in place of a
/// cutoff and the mean in place of the sum.
NonAffineMotion non_affine_motion(const Displacements& displacements,
                                  std::span<const ContactForce> contacts);

/// Displacement beyond the vertical one of the bed.
struct Wandering {
  std::vector<MovedBead> beads;  ///< by id, `moved` without the vertical motion of the bed there
  double lateral = 0.0;          ///< root of the mean square of x and y [m]
  double vertical = 0.0;         ///< root of the mean square of z [m]
};

/// The vertical motion of the bed at a height is interpolated between the mean heights and mean vertical
/// displacements of `slabs` slabs of equal thickness (at least 1; those without beads are skipped) and
/// continued below and above; so a bed that is stretched evenly does not wander.
Wandering wandering(const Displacements& displacements, int slabs);

/// Contacts of two states, by ids, each as often as it is there.
struct ContactChanges {
  std::int64_t before = 0;
  std::int64_t after = 0;
  std::int64_t lost = 0;
  std::int64_t made = 0;
  double lost_share = 0.0;  ///< of `before`
  double made_share = 0.0;  ///< of `after`
};

/// Between beads; walls do not count.
ContactChanges contact_changes(std::span<const TouchingPair> before,
                               std::span<const TouchingPair> after);

}  // namespace packbed::analysis
