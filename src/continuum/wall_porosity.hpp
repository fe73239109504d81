// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Porosity near a wall.

#include <cmath>
#include <numbers>

namespace packbed::continuum {

/// Local porosity of a bed of equal spheres over the distance y from the wall of a round column, a damped
/// oscillation:
///   r* = y / y_min - 1
///   y_min = d/2 (D/d - sqrt((D/d - 1)^2 - 1))
///   eps = eps_min + (1 - eps_min) r*^2                                  for r* < 0
///   eps = eps_bulk + (eps_min - eps_bulk) exp(-r*/a) cos(pi r*/b)       for r* >= 0
/// For D > 2 d and 0 <= y <= D/2. Bey and Eigenberger 1997, thesis eqs 3.45-3.48 and fig. 3.7, with the
/// constants given there.
struct BeyEigenberger {
  double column_diameter = 0.0;  ///< D [m]
  double bead_diameter = 0.0;    ///< d [m]
  double eps_min = 0.24;         ///< at y_min
  double eps_bulk = 0.39;        ///< far from the wall
  double damping = 4.0;          ///< a
  double wavelength = 0.876;     ///< b: half a wave, in y_min

  [[nodiscard]] double y_min() const {
    const double ratio = column_diameter / bead_diameter;
    return 0.5 * bead_diameter * (ratio - std::sqrt((ratio - 1.0) * (ratio - 1.0) - 1.0));
  }

  [[nodiscard]] double operator()(double y) const {
    const double r = y / y_min() - 1.0;
    if (r < 0.0) return eps_min + (1.0 - eps_min) * r * r;
    return eps_bulk + (eps_min - eps_bulk) * std::exp(-r / damping) *
                          std::cos(std::numbers::pi * r / wavelength);
  }
};

}  // namespace packbed::continuum
