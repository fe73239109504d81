// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Flow through a bed of porosity eps and bead size d32. Gradients in Pa/m along the flow, u_superficial in m/s,
/// mu_f in Pa s. Carman's own form of Kozeny-Carman is in packed_bed.hpp.

#include <string_view>

#include "continuum/packed_bed.hpp"

namespace packbed::continuum {

/// kappa = d32^2 eps^3 / (180 (1 - eps)^2) [m2], so that dp/dz = mu_f u_superficial / kappa. Thesis eqs 3.56
/// (Darcy), 3.57.
constexpr double kozeny_carman_permeability(double eps, double d32) {
  return d32 * d32 * eps * eps * eps / (180.0 * (1.0 - eps) * (1.0 - eps));
}

/// Blake-Kozeny, factor 150 for Carman's 180. Thesis eq. 3.61.
constexpr double blake_kozeny_gradient(double eps, double d32, double mu_f, double u_superficial) {
  return 150.0 / 180.0 * kozeny_carman_gradient(eps, d32, mu_f, u_superficial);
}

/// Ergun: Blake-Kozeny and 1.75 (1 - eps) rho_f u_superficial^2 / (d32 eps^3). Thesis eq. 3.63.
constexpr double ergun_gradient(
    double eps, double d32, double rho_f, double mu_f, double u_superficial) {
  return blake_kozeny_gradient(eps, d32, mu_f, u_superficial) +
         1.75 * (1.0 - eps) * rho_f * u_superficial * u_superficial / (d32 * eps * eps * eps);
}

/// Re_p = rho_f u_superficial d / mu_f: thesis eq. 3.53 with the bead size.
constexpr double particle_reynolds(double rho_f, double u_superficial, double d, double mu_f) {
  return rho_f * u_superficial * d / mu_f;
}

/// Re_B = Re_p / (1 - eps). Thesis eq. 3.54. (Re_B' = Re_p / eps, eq. 3.55, is `bed_reynolds`.)
constexpr double solid_reynolds(
    double rho_f, double u_superficial, double d, double mu_f, double eps) {
  return particle_reynolds(rho_f, u_superficial, d, mu_f) / (1.0 - eps);
}

/// Laminar below Re_p = 10, turbulent above 300. Thesis section 3.3.1.
constexpr std::string_view flow_regime(double re_p) {
  if (re_p < 10.0) return "laminar";
  return re_p <= 300.0 ? "transitional" : "turbulent";
}

}  // namespace packbed::continuum
