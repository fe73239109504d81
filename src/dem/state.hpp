// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Everything that the next steps depend on, as plain records that know nothing of ranks or of the
/// order of beads: what a checkpoint holds, and what is edited where beads are added or taken away.
///
/// A Dem that takes a state over goes on with the same bits, on any number of ranks: order of beads,
/// pairs and near pairs follow from the centers at which they were found, which the state keeps.

#include <cstdint>
#include <vector>

#include "core/ranks.hpp"
#include "dem/contact/friction.hpp"
#include "dem/domain.hpp"
#include "dem/particles.hpp"
#include "dem/walls.hpp"

namespace packbed::dem {

struct BeadState {
  BeadProperties properties;
  Vec3 x;              ///< [m]
  Vec3 v;              ///< at the last half step [m/s]
  Vec3 w;              ///< likewise [rad/s]
  Vec3 reference;      ///< center when near pairs were last listed [m]
  Vec3 far_reference;  ///< center at the last renewal [m]
  Drag drag;           ///< of a liquid, if there is one
  CouplingMark coupled_at;
};

/// A near pair with springs; signs and image as seen from its first bead, which comes first in the
/// global order.
struct ContactState {
  std::int64_t id_i = 0;
  std::int64_t id_j = 0;
  Image image{};
  History history;
};

struct WallContactState {
  std::int64_t id = 0;
  std::int32_t wall = 0;
  History history;
};

/// Counters and lengths, alike on all ranks.
struct DemProgress {
  std::int64_t steps = 0;
  std::int64_t steps_before = 0;  ///< when the present step size came into force
  std::int64_t near_listed = 0;   ///< step at which near pairs were last listed
  std::int64_t renewals = 0;
  std::int64_t repartitions = 0;
  double time_before = 0.0;  ///< of steps_before [s]
  double step = 0.0;         ///< [s]
  double last_step = 0.0;    ///< 0 before the first [s]
  double skin = 0.0;         ///< [m]
  double near_skin = 0.0;    ///< [m]
  double moved = 0.0;        ///< since near pairs were listed, as Dem bounds it [m]
  double far_moved = 0.0;    ///< from the renewal until then [m]
  double walls_moved = 0.0;  ///< since the renewal [m]
  double cell = 0.0;         ///< width of the key grid [m]
  double inertia_scale = 1.0;
  double inertia_diameter = 0.0;    ///< 0: all beads alike [m]
  double background_damping = 0.0;  ///< [1/s]
  double friction = 0.0;
  double rolling_friction = 0.0;  ///< 0 where the law has none
  std::int64_t in_liquid = 0;     ///< whether beads have a drag
};

struct DemState {
  std::vector<BeadState> beads;
  std::vector<ContactState> contacts;           ///< those with a spring that is not zero
  std::vector<WallContactState> wall_contacts;  ///< all that are listed
  std::vector<Wall> walls;                      ///< where they are, with their motion
  DemProgress progress;
};

/// The shares of all ranks as one, on every rank.
DemState whole(const DemState& share, const Ranks& ranks);

/// The shares dealt out anew in the order of ids, so that a checkpoint does not show which rank had what.
DemState in_order_of_ids(DemState share, const Ranks& ranks);

}  // namespace packbed::dem
