// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/bead.hpp"

#include <algorithm>

#include "analysis/overlap.hpp"

namespace packbed::analysis {

std::vector<Bead> own_beads(const dem::Particles& particles) {
  std::vector<Bead> beads;
  beads.reserve(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (!particles.is_own(i)) continue;
    beads.push_back({particles.motion[i].x, particles.radius(i), particles.properties[i].id});
  }
  return beads;
}

double largest_bead_volume(std::span<const Bead> beads, const Ranks& ranks) {
  double radius = 0.0;
  for (const auto& bead : beads) radius = std::max(radius, bead.radius);
  return sphere_volume(ranks.max(radius));
}

}  // namespace packbed::analysis
