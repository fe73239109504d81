// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// A bed as its analysis sees it: spheres. Every function of this folder that takes beads and
/// `Ranks` is given the beads of this rank, each bead of the bed on one rank; all ranks call it, and
/// get the same bits on any number of ranks.

#include <cstdint>
#include <span>
#include <vector>

#include "core/ranks.hpp"
#include "core/vec3.hpp"
#include "dem/particles.hpp"

namespace packbed::analysis {

struct Bead {
  Vec3 x;               ///< center [m]
  double radius = 0.0;  ///< [m]
  std::int64_t id = 0;  ///< same bead, same id at all times; only sections ask for it
};

/// An interval of a coordinate [m].
struct Range {
  double low = 0.0;
  double high = 0.0;
};

/// The beads that this rank owns.
std::vector<Bead> own_beads(const dem::Particles& particles);

/// Volume of the largest bead of all ranks [m3]; 0 without beads.
double largest_bead_volume(std::span<const Bead> beads, const Ranks& ranks);

}  // namespace packbed::analysis
