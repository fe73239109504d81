// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace packbed::coupling {

/// Ergun 1952, for beds: beta = 150 eta a^2 / (alpha_f d^2) + 1.75 rho a |u_f - v| / d, so
///   F = (150 a + 1.75 Re) / (18 alpha_f^2)
/// with a the solid fraction. Not for a single bead: F -> 0.
struct Ergun {
  static constexpr const char* name = "ergun";

  double operator()(double solid_fraction, double reynolds) const {
    const double alpha_f = 1.0 - solid_fraction;
    return (150.0 * solid_fraction + 1.75 * reynolds) / (18.0 * alpha_f * alpha_f);
  }
};

}  // namespace packbed::coupling
