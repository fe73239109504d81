// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The many names of how far a bed is compressed. H0 is its height settled by gravity, H the present one.
/// Beads keep their volume.

namespace packbed::continuum {

/// lambda = (H0 - H) / H0: thesis eq. 3.72. All others follow from it.
struct Compression {
  double lambda = 0.0;

  /// lambda* = (H0 - H) / H, of Keener et al. 2004; eq. 3.74 needs this one.
  [[nodiscard]] constexpr double relative_to_packed() const { return lambda / (1.0 - lambda); }
  /// Compression factor H0 / H.
  [[nodiscard]] constexpr double factor() const { return 1.0 / (1.0 - lambda); }
  /// Packing density phi = (1 - eps0) / (1 - lambda). Thesis eq. 3.73.
  [[nodiscard]] constexpr double density(double eps0) const {
    return (1.0 - eps0) / (1.0 - lambda);
  }
  /// eps = (eps0 - lambda) / (1 - lambda). Thesis below eq. 3.73, and eq. 7.9.
  [[nodiscard]] constexpr double porosity(double eps0) const {
    return (eps0 - lambda) / (1.0 - lambda);
  }
  /// Packing factor: height of the bed as it was consolidated before the plunger touched it, over H.
  /// `consolidated` is lambda of that bed.
  [[nodiscard]] constexpr double packing_factor(double consolidated) const {
    return (1.0 - consolidated) / (1.0 - lambda);
  }

  static constexpr Compression from_relative_to_packed(double lambda_star) {
    return {lambda_star / (1.0 + lambda_star)};
  }
  static constexpr Compression from_factor(double factor) { return {1.0 - 1.0 / factor}; }
  static constexpr Compression from_density(double phi, double eps0) {
    return {1.0 - (1.0 - eps0) / phi};
  }
  static constexpr Compression from_porosity(double eps, double eps0) {
    return from_density(1.0 - eps, eps0);
  }
  static constexpr Compression from_packing_factor(double factor, double consolidated) {
    return {1.0 - (1.0 - consolidated) / factor};
  }
};

}  // namespace packbed::continuum
