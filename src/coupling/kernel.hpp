// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The smooth compact kernel that spreads a bead over cells: the biweight, once continuously
/// differentiable, zero from distance 1 on. Lengths in reaches; neither is normalized to a length.

namespace packbed::coupling {

/// Along a line: 15/16 (1 - s^2)^2; its integral from -1 to s.
constexpr double kernel_integral(double s) {
  if (s <= -1.0) return 0.0;
  if (s >= 1.0) return 1.0;
  const double square = s * s;
  return 0.5 + 15.0 / 16.0 * s * (1.0 - square * (2.0 / 3.0 - 0.2 * square));
}

/// Radial, of the squared distance: (1 - r^2)^2.
constexpr double kernel(double square) {
  return square < 1.0 ? (1.0 - square) * (1.0 - square) : 0.0;
}

}  // namespace packbed::coupling
