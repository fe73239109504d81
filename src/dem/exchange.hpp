// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Beads and contacts on several ranks: who travels where at a renewal, and the halo between.
///
/// A rank has its own beads and copies of all foreign beads that may touch one of them (the halo),
/// in one array ordered by the global key. It evaluates every contact with at least one own bead with
/// its own copy of the springs, so a bead's forces are added in the same order everywhere, to the last
/// bit. It never moves a halo bead: the owner sends it after each step.

#include <cstdint>
#include <vector>

#include "core/ranks.hpp"
#include "dem/contact_list.hpp"
#include "dem/particles.hpp"
#include "dem/partition.hpp"
#include "dem/walls.hpp"

namespace packbed::dem {

/// A contact known by the ids of its beads; signs and image as seen from bead i.
struct NamedContact {
  std::int64_t id_i = 0;
  std::int64_t id_j = 0;
  Image image{};
  Coefficients coefficients;
  History history;
};

struct NamedWallContact {
  std::int64_t id = 0;
  std::int32_t wall = 0;
  Coefficients coefficients;
  History history;
};

/// A bead as it travels.
struct NamedBead {
  Motion motion;
  Spin spin;
  BeadProperties properties;
  std::int32_t owner = 0;
};

/// Everything that a rank takes over a renewal.
struct Luggage {
  std::vector<NamedBead> beads;
  std::vector<NamedContact> contacts;
  std::vector<NamedWallContact> wall_contacts;
};

/// Own beads and all contacts, by name. `wraps` as from wrap(), for own and halo beads.
Luggage pack(const Particles& particles,
             const std::vector<PairContact>& pairs,
             const std::vector<WallContacts>& walls,
             const std::vector<Image>& wraps);

/// Sends beads to the ranks that own their places now, with their contacts. Throws DivergenceError if
/// the number of beads of all ranks has changed.
Luggage migrate(const Luggage& luggage, const Partition& partition, const Ranks& ranks);

/// Copies of foreign beads within `reach` of rows that this rank owns.
std::vector<NamedBead> halo(const std::vector<NamedBead>& own,
                            const Partition& partition,
                            double reach,
                            const Ranks& ranks);

/// Own and foreign beads as particles, not yet sorted.
void place_beads(const std::vector<NamedBead>& own,
                 const std::vector<NamedBead>& foreign,
                 Particles& particles);

/// Contacts by the places of their beads; those of beads that are not here are left out.
struct PlacedContacts {
  std::vector<PairContact> pairs;
  std::vector<WallContacts> walls;
};
PlacedContacts place_contacts(const Luggage& luggage,
                              const Particles& particles,
                              std::size_t wall_count);

/// Which beads are sent to and received from each rank after every step: those in near pairs. Other
/// halo beads drift on unseen until the next renewal.
class HaloExchange {
 public:
  HaloExchange() = default;
  /// For the halo beads that `pairs` use; the owners are told.
  HaloExchange(const Particles& particles, const std::vector<PairKey>& pairs, const Ranks& ranks);

  /// Brings position, velocity and spin of the halo beads up to date.
  void refresh(Particles& particles, const Ranks& ranks) const;

 private:
  std::vector<std::vector<std::int32_t>> send_;     ///< places of own beads, by rank
  std::vector<std::vector<std::int32_t>> receive_;  ///< places of halo beads, by rank
};

}  // namespace packbed::dem
