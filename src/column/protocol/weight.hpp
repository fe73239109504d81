// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numbers>

#include "dem/particles.hpp"

namespace packbed::column {

/// Weight of a bead less its buoyancy in a liquid of this density [N]; gravity in m/s2.
inline double weight_of(const dem::BeadProperties& bead, double gravity, double liquid_density) {
  const double volume = std::numbers::pi / 6.0 * bead.diameter * bead.diameter * bead.diameter;
  return (bead.density - liquid_density) * volume * gravity;
}

}  // namespace packbed::column
