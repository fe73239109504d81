// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// One bead between two rigid plates: what all models of this folder agree on. SI units.
///
///   Delta   total approach of the two plates [m], what an indenter measures
///   delta   Delta / 2, the overlap of ONE contact; the bead has two, in series
///   F       force on a plate [N], positive in compression
///
/// The thesis writes eq. 3.23 with delta and eqs 3.26, 3.29 and C.20 with Delta; both are right, as
///   8/3 sqrt(R) (Delta/2)^(3/2) = 2/3 sqrt(2 R) Delta^(3/2).
/// With Delta in eq. 3.23 the force would be 2.83 times too large.

#include <cmath>

namespace packbed::continuum {

struct BeadShape {
  double radius = 0.0;   ///< R of the unloaded bead [m]
  double poisson = 0.0;  ///< nu [-], constant in time

  /// What multiplies 2 G Delta^(3/2) [m^(1/2)]: sqrt(2 R) / (3 (1 - nu)). Thesis eqs 3.29, C.20.
  [[nodiscard]] double factor() const { return std::sqrt(2.0 * radius) / (3.0 * (1.0 - poisson)); }
};

/// F of a bead with shear modulus G [Pa], thesis eq. C.20 for a constant G.
inline double elastic_force(const BeadShape& bead, double shear_modulus, double approach) {
  return bead.factor() * 2.0 * shear_modulus * approach * std::sqrt(approach);
}

/// Contact radius a = sqrt(delta R) [m], delta = Delta / 2. Thesis eq. 3.5 with a rigid plate.
inline double contact_radius(const BeadShape& bead, double approach) {
  return std::sqrt(0.5 * approach * bead.radius);
}

/// E = 2 G (1 + nu). Thesis eq. 3.24.
constexpr double youngs_modulus(double shear_modulus, double poisson) {
  return 2.0 * shear_modulus * (1.0 + poisson);
}

constexpr double shear_modulus(double youngs_modulus, double poisson) {
  return youngs_modulus / (2.0 * (1.0 + poisson));
}

}  // namespace packbed::continuum
