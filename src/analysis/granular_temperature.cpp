// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/granular_temperature.hpp"

#include <algorithm>
#include <cassert>
#include <optional>

namespace packbed::analysis {
namespace {

std::optional<std::size_t> slab_of(double z, std::span<const double> edges) {
  const auto above = std::ranges::upper_bound(edges, z) - edges.begin();
  if (above == 0 || above == std::ssize(edges)) return std::nullopt;
  return static_cast<std::size_t>(above) - 1;
}

}  // namespace

GranularTemperature granular_temperature(std::span<const MovingBead> beads,
                                         std::span<const double> edges) {
  assert(edges.size() >= 2);
  GranularTemperature t;
  t.slabs.resize(edges.size() - 1);
  for (const auto& bead : beads) {
    const auto slab = slab_of(bead.x.z, edges);
    if (!slab) {
      ++t.outside;
      continue;
    }
    ++t.slabs[*slab].beads;
    t.slabs[*slab].mean += bead.v;
  }
  for (auto& slab : t.slabs) {
    if (slab.beads > 0) slab.mean *= 1.0 / static_cast<double>(slab.beads);
  }
  for (const auto& bead : beads) {
    const auto slab = slab_of(bead.x.z, edges);
    if (!slab) continue;
    const Vec3 fluctuation = bead.v - t.slabs[*slab].mean;
    t.slabs[*slab].temperature += dot(fluctuation, fluctuation) / 3.0;
  }
  double all = 0.0;
  for (std::size_t k = 0; k < t.slabs.size(); ++k) {
    auto& slab = t.slabs[k];
    slab.z = {edges[k], edges[k + 1]};
    if (slab.beads == 0) continue;
    const auto n = static_cast<double>(slab.beads);
    t.mean += slab.temperature;
    all += n;
    slab.temperature /= n;
  }
  if (all > 0.0) t.mean /= all;
  return t;
}

}  // namespace packbed::analysis
