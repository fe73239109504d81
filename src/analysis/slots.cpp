// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/slots.hpp"

#include <cassert>
#include <cmath>

#include "analysis/overlap.hpp"

namespace packbed::analysis {

std::vector<double> even_edges(double low, double high, double width) {
  assert(width > 0.0 && high > low);
  // 1e-9: a length of n widths up to rounding has n bins.
  const auto count =
      static_cast<std::size_t>(std::max(1.0, std::ceil((high - low) / width - 1e-9)));
  std::vector<double> edges;
  edges.reserve(count + 1);
  for (std::size_t k = 0; k < count; ++k) edges.push_back(low + static_cast<double>(k) * width);
  edges.push_back(high);
  return edges;
}

std::vector<double> solid_between(std::span<const Bead> beads,
                                  std::span<const double> heights,
                                  const Ranks& ranks) {
  Slots slots(heights, largest_bead_volume(beads, ranks));
  for (const auto& bead : beads) {
    slots.spread(bead.x.z - bead.radius, bead.x.z + bead.radius, sphere_volume(bead.radius),
                 [&](double edge) { return volume_below(bead.radius, edge - bead.x.z); });
  }
  const auto all = slots.totals(ranks);
  return {all.begin() + 1, all.end() - 1};
}

}  // namespace packbed::analysis
