// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// What follows from the pores of a bead. SI units.

#include <cmath>
#include <numbers>

namespace packbed::continuum {

/// Density of the wet bead [kg/m3]: eps_pore rho_f + (1 - eps_pore) rho_dry. Thesis eq. 5.1.
constexpr double wet_density(double eps_pore, double rho_f, double rho_dry) {
  return eps_pore * rho_f + (1.0 - eps_pore) * rho_dry;
}

/// Permeability of the bead [m2]: eps_pore r^2 / K, r hydraulic radius of the pores, K Kozeny's constant, 5
/// for eps_pore >= 0.66. Thesis eq. 3.36.
constexpr double pore_permeability(double eps_pore, double pore_radius, double kozeny = 5.0) {
  return eps_pore * pore_radius * pore_radius / kozeny;
}

/// Diffusivity of the pore pressure [m2/s]: 2 (1 - nu) G k / ((1 - 2 nu) mu_f), nu < 1/2. Thesis eq. 3.35.
constexpr double poroelastic_diffusivity(double poisson,
                                         double shear_modulus,
                                         double permeability,
                                         double mu_f) {
  return 2.0 * (1.0 - poisson) * shear_modulus * permeability / ((1.0 - 2.0 * poisson) * mu_f);
}

/// Volume of a bead of radius r cut off by two plates a height h apart, both at the same distance from its
/// center: pi h (r^2 - h^2/12) [m3]. The thesis's "spherical segment" (section 6.7): r, measured on the
/// picture, is larger than that of the unloaded bead.
constexpr double flattened_volume(double r, double h) {
  return std::numbers::pi * h * (r * r - h * h / 12.0);
}

/// Poisson's ratio from pictures of a bead before (radius R) and in compression (height h, radius r):
///   (V0 - V) / V0 = (1 - 2 nu) (2R - h) / (2R). Thesis eq. 3.4.
constexpr double poisson_from_pictures(double radius, double height, double radius_compressed) {
  const double v0 = flattened_volume(radius, 2.0 * radius);
  const double strain = (2.0 * radius - height) / (2.0 * radius);
  return 0.5 * (1.0 - (v0 - flattened_volume(radius_compressed, height)) / v0 / strain);
}

}  // namespace packbed::continuum
