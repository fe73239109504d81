// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "continuum/bead/plate_contact.hpp"

namespace packbed::continuum {

/// Elastic bead between rigid plates, per contact
///   F = 4/3 E* sqrt(R) delta^(3/2),  E* = E / (1 - nu^2),  delta = Delta / 2
/// Thesis eqs 3.1 to 3.3 with E_j and R_j of the plate infinite.
struct HertzBead {
  BeadShape shape;
  double youngs_modulus = 0.0;  ///< E [Pa]

  [[nodiscard]] double force(double approach) const {
    const double e_eff = youngs_modulus / (1.0 - shape.poisson * shape.poisson);
    const double delta = 0.5 * approach;
    return 4.0 / 3.0 * e_eff * std::sqrt(shape.radius) * delta * std::sqrt(delta);
  }

  /// Delta that the force F makes: 2 (9 F^2 / (16 E*^2 R))^(1/3). Thesis eq. 3.7, which prints E* for
  /// E*^2.
  [[nodiscard]] double approach(double force) const {
    const double e_eff = youngs_modulus / (1.0 - shape.poisson * shape.poisson);
    return 2.0 * std::cbrt(9.0 * force * force / (16.0 * e_eff * e_eff * shape.radius));
  }

  /// Elastic energy of both contacts, 2/5 F Delta [J]. Thesis eqs 3.6 to 3.9 (E*^2 as above).
  [[nodiscard]] double energy(double approach) const { return 0.4 * force(approach) * approach; }
};

}  // namespace packbed::continuum
