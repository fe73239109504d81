// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// How much the end of a step counts, and how much its start.

#include <algorithm>
#include <cmath>

namespace packbed::fluid {

/// Weight of the end of the step: 1 Euler, 1/2 Crank-Nicolson.
inline double end_weight(double crank_nicolson) { return 1.0 / (1.0 + crank_nicolson); }

/// Weight w of the end of the step for a drag of rate z = exchange dt / (rho eps): at least `end`, and
/// at least 1/(1 - exp(-z)) - 1/z, by which (1 - (1-w) z)/(1 + w z) = exp(-z). The drag alone then decays
/// without overshoot for any step, and w -> 1/2 for small ones.
inline double drag_weight(double z, double end) {
  // Below 0.05 the series is exact to 1e-11; the closed form loses digits there.
  const double fitted =
      z < 0.05 ? 0.5 + z / 12.0 - z * z * z / 720.0 : -1.0 / std::expm1(-z) - 1.0 / z;
  return std::max(end, fitted);
}

}  // namespace packbed::fluid
