// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

namespace packbed::continuum {

/// How the plates move: from first touch to `depth` at constant speed in `ramp_time`, held for
/// `hold_time`, then back at the same speed. A ramp of no time is a step.
struct Loading {
  double depth = 0.0;                                          ///< largest Delta [m]
  double ramp_time = 0.0;                                      ///< [s]
  double hold_time = std::numeric_limits<double>::infinity();  ///< [s]

  [[nodiscard]] double speed() const { return depth / ramp_time; }
  [[nodiscard]] double unload_start() const { return ramp_time + hold_time; }

  /// Delta at time t since first touch [m]; 0 after the plates are back.
  [[nodiscard]] double approach(double t) const {
    if (t < ramp_time) return speed() * t;
    if (t <= unload_start()) return depth;
    const double left = depth - speed() * (t - unload_start());
    return left > 0.0 ? left : 0.0;
  }
};

}  // namespace packbed::continuum
