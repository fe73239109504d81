// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "dem/dem.hpp"

namespace packbed::dem {
namespace {

// Halo beads too: the contacts of this rank see them.
void scale(Particles& p, double factor) {
  const double volume = factor * factor * factor;
  for (std::size_t i = 0; i < p.size(); ++i) {
    auto& bead = p.properties[i];
    bead.diameter *= factor;
    bead.mass *= volume;
    bead.weight *= volume;
    p.motion[i].inv_mass /= volume;
    p.motion[i].inv_inertia /= volume * factor * factor;
    p.spin[i].half_radius *= factor;
    p.load[i].weight = bead.weight;
    p.load[i].force = {0.0, 0.0, -bead.weight};
  }
}

}  // namespace

void Dem::scale_diameters(double factor) {
  if (!(factor > 0.0) || !std::isfinite(factor)) {
    throw ValueError(
        fmt::format("diameters cannot be scaled by {}; the factor must be positive", factor));
  }
  scale(particles_, factor);
  largest_diameter_ *= factor;
  options_.inertia_diameter *= factor;
  auto pairs = contacts_.pairs();
  for (auto& p : pairs) p.coefficients = coefficients_of(p);
  contacts_ = ContactList(pairs, options_.domain, static_cast<std::int32_t>(particles_.size()));
  for (auto& contacts : wall_contacts_) {
    for (auto& contact : contacts) contact.coefficients.a = -1.0;  // filled in at the renewal
  }
  renew();
  check_overlaps();
}

}  // namespace packbed::dem
