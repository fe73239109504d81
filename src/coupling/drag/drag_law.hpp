// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The list of drag laws, and what they give. To add one: write its header, put it in the variant, give it
/// its row in drag_laws_test.cpp, name it in setup/.
///
/// A law is a function F(solid fraction, Re): drag over Stokes drag at the same superficial slip,
///   F_drag = 3 pi eta d F alpha_f (u_f - v),   Re = rho_f d alpha_f |u_f - v| / eta  (thesis eq. 4.7).
/// It is drag without the share of the mean pressure gradient (form A, as thesis eq. 4.5). All are finite
/// at Re = 0 and grow with the solid fraction.

#include <cmath>
#include <numbers>
#include <variant>

#include "coupling/drag/beetstra.hpp"
#include "coupling/drag/di_felice.hpp"
#include "coupling/drag/ergun.hpp"
#include "coupling/drag/gidaspow.hpp"
#include "coupling/drag/koch_hill.hpp"

namespace packbed::coupling {

using DragLaw = std::variant<KochHill, Ergun, Gidaspow, DiFelice, Beetstra>;

/// No law has been measured, or can be believed, above this solid fraction.
inline constexpr double largest_solid_fraction = 0.85;

/// Reynolds number of a bead, thesis eq. 4.7; `slip` = |u_f - v| [m/s], `eta` and `rho` of the liquid.
inline double bead_reynolds(double rho, double eta, double d, double void_fraction, double slip) {
  return rho * d * void_fraction * slip / eta;
}

/// Drag coefficient of a grain that stands for coarse_grain^3 beads, from its diameter D [m]:
///   K = cg^3 3 pi eta (D / cg) alpha_f F = V 18 eta alpha_f F / d^2,  d = D / cg   [kg/s]
/// so that F_drag = K (u_f - v). Thesis eqs 4.5 and 5.8 (corrected: the law is evaluated with d, and the drag
/// of one bead multiplied by cg^3).
inline double grain_coefficient(
    double factor, double eta, double grain_diameter, double coarse_grain, double void_fraction) {
  return coarse_grain * coarse_grain * 3.0 * std::numbers::pi * eta * grain_diameter *
         void_fraction * factor;
}

}  // namespace packbed::coupling
