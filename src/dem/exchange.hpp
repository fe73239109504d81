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
#include <unordered_map>
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

/// Places of some beads by their ids; -1 for those that are not here.
using PlaceOfId = std::unordered_map<std::int64_t, std::int32_t>;

/// A bead as it travels.
struct NamedBead {
  Motion motion;
  Spin spin;
  BeadProperties properties;
  std::int32_t owner = 0;
  Drag drag;
  CouplingMark coupled_at;
};

/// What comes to a rank, or goes from it, at a renewal.
struct Luggage {
  std::vector<NamedBead> beads;
  std::vector<NamedContact> contacts;
  std::vector<NamedWallContact> wall_contacts;
};

std::vector<Vec3> own_centers(const Particles& particles);

/// What each of them costs in a step: one for the bead and one for each pair listed with it.
std::vector<std::int64_t> own_work(const Particles& particles, const ContactList& contacts);

/// The rank that owns the place of each own bead now; -1 for halo beads.
std::vector<std::int32_t> new_owners(const Particles& particles, const Partition& partition);

/// Sends the own beads that belong to other ranks now there, with their contacts, and returns what arrives
/// here. Nothing is taken away here. `owners` as above, `wraps` as from wrap(). A contact goes wherever one
/// of its beads goes; it may arrive where it is known already.
Luggage migrate(const Particles& particles,
                const ContactList& contacts,
                const std::vector<WallContacts>& walls,
                const std::vector<Image>& wraps,
                const std::vector<std::int32_t>& owners,
                const Ranks& ranks);

/// Copies of foreign beads within `reach` of rows that this rank owns. All beads here are own.
std::vector<NamedBead> halo(const Particles& own,
                            const Partition& partition,
                            double reach,
                            const Ranks& ranks);

/// Adds them before the dummies.
void add(Particles& particles, const std::vector<NamedBead>& beads);

/// Runs of own beads in the order of beads, as first and last + 1. By rows there is one, but for beads that
/// escaped; by cells of a mesh there are many.
struct Run {
  std::size_t first = 0;
  std::size_t last = 0;
};
std::vector<Run> own_runs(const Particles& particles);

/// Which beads are sent to and received from each rank after every step: those in listed pairs. Other
/// halo beads stay where they are until the next renewal.
class HaloExchange {
 public:
  HaloExchange() = default;
  HaloExchange(const HaloExchange&) = delete;  // mails point to the buffers
  HaloExchange& operator=(const HaloExchange&) = delete;
  HaloExchange(HaloExchange&&) = default;
  HaloExchange& operator=(HaloExchange&&) = default;
  ~HaloExchange() = default;
  /// For the halo beads that `pairs` use; the owners are told.
  HaloExchange(const Particles& particles, const std::vector<PairKey>& pairs, const Ranks& ranks);

  /// Brings position, velocity and spin of the halo beads up to date.
  void refresh(Particles& particles, const Ranks& ranks);

 private:
  /// What an owner tells of a bead.
  struct State {
    Vec3 x, v, w;
  };
  /// With one other rank: places of own and of halo beads, and what is told of them.
  struct Neighbor {
    int rank = 0;
    std::vector<std::int32_t> send, receive;
    std::vector<State> out, in;
  };
  std::vector<Neighbor> neighbors_;
  std::vector<Ranks::Mail> mails_;
};

}  // namespace packbed::dem
