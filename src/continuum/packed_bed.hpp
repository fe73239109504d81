// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Figures of a packed bed from its porosity and bead size. SI units; u_superficial is u_0.

namespace packbed::continuum {

/// Kozeny-Carman pressure gradient with Carman's factor 180 [Pa/m]:
///   dp/dz = 180 mu_f (1 - eps)^2 u_superficial / (eps^3 d32^2)
/// Thesis eqs 3.56 and 3.57; laminar flow (re_bed below about 10).
constexpr double kozeny_carman_gradient(double eps, double d32, double mu_f, double u_superficial) {
  const double phi = 1.0 - eps;
  return 180.0 * mu_f * phi * phi * u_superficial / (eps * eps * eps * d32 * d32);
}

/// Reynolds number of the pores, rho_f u_superficial d32 / (mu_f eps). Thesis eq. 3.55, fig. 7.2.
constexpr double bed_reynolds(
    double rho_f, double u_superficial, double d32, double mu_f, double eps) {
  return rho_f * u_superficial * d32 / (mu_f * eps);
}

/// Stokes number of the flow: relaxation time of a bead, rho_p d32^2 / (18 mu_f), over the time
/// d / u_superficial that the liquid takes to pass it. Thesis eq. 8.1, with d = d32. (The impact
/// Stokes number of viscous restitution is another one.)
constexpr double flow_stokes(double rho_p, double d32, double mu_f, double u_superficial) {
  return rho_p * d32 * u_superficial / (18.0 * mu_f);
}

}  // namespace packbed::continuum
