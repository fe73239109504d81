// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "continuum/bead/plate_contact.hpp"

namespace packbed::continuum {

/// How a poroelastic contact relaxes after a step: 1 at tau_p = 0, 0 at the end.
///   g = 0.491 exp(-0.908 sqrt(tau_p)) + 0.509 exp(-1.679 tau_p),  tau_p = D t / a^2
/// Hu et al. 2010 (finite elements), thesis eq. 3.40.
inline double poroelastic_relaxation(double tau_p) {
  return 0.491 * std::exp(-0.908 * std::sqrt(tau_p)) + 0.509 * std::exp(-1.679 * tau_p);
}

/// Porous bead pressed to a constant Delta at t = 0; liquid leaves the contact by diffusion.
///   F0 = 16/3 G a delta, a = sqrt(delta R), delta = Delta / 2      (eqs 3.39, 3.5)
///   F0 / F_inf = 2 (1 - nu)                                        (eq. 3.37)
///   F(t) = F_inf + (F0 - F_inf) g(D t / a^2)                       (eq. 3.38)
/// F0 is Hertz's law for an incompressible bead (nu = 1/2), F_inf that for the drained bead. Known for a
/// step; for a ramp see poroelastic_ramp.hpp.
struct PoroelasticBead {
  BeadShape shape;             ///< nu of the drained bead
  double shear_modulus = 0.0;  ///< G [Pa]
  double diffusivity = 0.0;    ///< D [m2/s]

  [[nodiscard]] double initial_force(double approach) const {
    return 16.0 / 3.0 * shear_modulus * contact_radius(shape, approach) * 0.5 * approach;
  }
  [[nodiscard]] double final_force(double approach) const {
    return initial_force(approach) / (2.0 * (1.0 - shape.poisson));
  }
  [[nodiscard]] double force(double approach, double t) const {
    const double a = contact_radius(shape, approach);
    const double f_inf = final_force(approach);
    return f_inf +
           (initial_force(approach) - f_inf) * poroelastic_relaxation(diffusivity * t / (a * a));
  }
};

}  // namespace packbed::continuum
