// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// X-rays in a porous bead. mu/rho is the mass attenuation coefficient [m2/kg].

#include <cmath>

namespace packbed::continuum {

/// mu/rho of a bead of matrix and liquid: sum of w_i (mu/rho)_i with the mass shares
/// w_liquid = eps_pore rho_f / rho_p, w_matrix = 1 - w_liquid. Thesis eq. 7.1 and below, with rho_p of
/// eq. 5.1.
constexpr double bead_attenuation(
    double eps_pore, double rho_f, double rho_dry, double of_liquid, double of_matrix) {
  const double rho_p = eps_pore * rho_f + (1.0 - eps_pore) * rho_dry;
  const double w = eps_pore * rho_f / rho_p;
  return w * of_liquid + (1.0 - w) * of_matrix;
}

/// Share of the photons that are absorbed over a length: 1 - exp(-(mu/rho) rho length). Thesis eq. 5.2.
inline double absorbed_share(double mass_attenuation, double density, double length) {
  return -std::expm1(-mass_attenuation * density * length);
}

}  // namespace packbed::continuum
