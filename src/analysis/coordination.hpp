// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Contacts per bead, with and without rattlers.

#include <cstdint>
#include <span>
#include <vector>

#include "dem/dem.hpp"

namespace packbed::analysis {

/// Two beads that touch, by their ids, each contact once; two images of a bead that touch the same bead in
/// a thin periodic slice are two contacts. With `j` = wall_id: a bead and a wall.
struct TouchingPair {
  std::int64_t i = 0;
  std::int64_t j = 0;
};
inline constexpr std::int64_t wall_id = -1;

/// Contacts of this rank: each contact of the bed is on one rank. `Ranks::gather` brings them together.
std::vector<TouchingPair> touching_pairs(const dem::Dem& dem);

struct Coordination {
  double mean = 0.0;                   ///< contacts with beads, per bead
  double mean_without_rattlers = 0.0;  ///< the same of the beads that are left; 0 if none is
  std::int64_t rattlers = 0;           ///< beads taken away
};

/// Contacts that hold a bead in place: four without friction; with friction two may (Thornton, Geotechnique 50
/// (2000) 43: beads with one contact or none have no part in the state of stress).
inline constexpr int holding_frictionless = 4;
inline constexpr int holding_with_friction = 2;

/// Of `beads` beads and all their contacts. A rattler has fewer than `holding` contacts and bears no load.
/// Rattlers are taken away with their contacts, again and again until none is left. In a bed with friction, which
/// stands on five contacts per bead, the rule of four would take all beads away.
/// Contacts with walls hold a bead like others, but do not count in the means.
Coordination coordination(std::span<const TouchingPair> pairs,
                          std::int64_t beads,
                          int holding = holding_frictionless);

}  // namespace packbed::analysis
