// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Value at a face in the convective term: from the cell that the liquid comes from (C) towards the one
/// that it goes to (D).

#include <algorithm>
#include <cmath>

namespace packbed::fluid {

/// Part of the way from C to D that a limited scheme goes, over that of linear interpolation (0: upwind,
/// 1: central, up to 2). r = 2 (grad u)_C . d / (u_D - u_C) - 1. MUSCL as in OpenFOAM.
inline double muscl(double r) { return std::max(0.0, std::min({2.0 * r, 0.5 * r + 0.5, 2.0})); }

/// u_f for values u_c and u_d, `rise` = (grad u)_C . d with d from C to D, and weight of D in a linear
/// interpolation.
inline double limited_value(double u_c, double u_d, double rise, double weight) {
  const double step = u_d - u_c;
  // A step of rounding has no meaningful r, and its limited value is u_c to round-off.
  if (std::abs(step) <= 1e-14 * (std::abs(u_c) + std::abs(u_d))) return u_c;
  return u_c + weight * muscl(2.0 * rise / step - 1.0) * step;
}

}  // namespace packbed::fluid
