// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The smooth compact kernel that spreads a bead over cells: the biweight, once continuously
/// differentiable, zero from distance 1 on. Lengths in reaches; neither is normalized to a length.

namespace packbed::coupling {

/// Along a line: 15/16 (1 - s^2)^2; its integral from -1 to s. In powers of the distance from the nearer end: it never
/// is below 0 or above 1 by rounding, or a cell that a bead just reaches would have a negative share of it.
constexpr double kernel_integral(double s) {
  if (s <= -1.0) return 0.0;
  if (s > 0.0) return 1.0 - kernel_integral(-s);
  const double x = 1.0 + s;
  return x * x * x * (1.25 - x * (0.9375 - 0.1875 * x));
}

/// Radial, of the squared distance: (1 - r^2)^2.
constexpr double kernel(double square) {
  return square < 1.0 ? (1.0 - square) * (1.0 - square) : 0.0;
}

}  // namespace packbed::coupling
