// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// What a contact law is given and what it returns. The sign conventions of all contacts are
/// fixed here and nowhere else:
///
///   normal    unit vector from body j towards body i; a repulsive force on i points along it
///   overlap   R_i + R_j - |x_i - x_j| (walls: R_i - distance), positive while the bodies touch
///   v_n       (v_i - v_j) . normal: negative on approach
///   u_t       tangential velocity of i minus that of j at the contact point, with arms
///             c = R - overlap / 2 (walls: R_i - overlap, where the rigid wall is):
///             (v_i - v_j) - v_n normal - (c_i w_i + c_j w_j) x normal
///   spring    tangential elongation: integral of u_t, kept in the contact plane
///   force     acts on i; j receives its opposite
///
/// Laws are branch-free and take plain doubles, so that the same text serves one contact in a test
/// and 32 lanes in the loop (dem/force_pass.cpp).

#include <concepts>
#include <string_view>

#include "dem/material.hpp"

namespace packbed::dem {

/// Two bodies that may touch. A wall is body j with infinite radius and mass.
struct Pair {
  Material i, j;
  double r_eff = 0.0;     ///< R* [m]
  double m_eff = 0.0;     ///< m*, true mass [kg]
  double m_scaled = 0.0;  ///< m* of the masses that move: times the inertia scale [kg]
};

/// Three numbers that a law works out once per pair and that the contact list keeps with it.
struct Coefficients {
  double a = 0.0, b = 0.0, c = 0.0;
};

/// What a law says of one contact in one instant.
struct Response {
  double f_n;      ///< normal force along the normal [N]; 0 where the bodies do not touch
  double k_t;      ///< tangential stiffness [N/m]
  double gamma_t;  ///< tangential damping [kg/s]
};

/// A contact law is a small value type without state.
template <class Law>
concept ContactLawType =
    requires(const Law& law, const Pair& pair, const Coefficients& k, double x) {
  { law.coefficients(pair) } -> std::same_as<Coefficients>;
  { law(x, x, k) } -> std::same_as<Response>;       // overlap, v_n, coefficients
  { law.stiffness(x, k) } -> std::same_as<double>;  // d f_n / d overlap at an overlap [N/m]
  { law.damping(x, k) } -> std::same_as<double>;    // largest normal damping there [kg/s]
  { law.energy(x, k) } -> std::same_as<double>;     // of the normal spring [J]
  { Law::name } -> std::convertible_to<std::string_view>;
  requires noexcept(law(x, x, k));
};

/// Normal force of touching bodies only; without tension the damped force never pulls.
constexpr double touching_force(double f_n, double overlap, bool tension) {
  const double pushed = tension ? f_n : (f_n > 0.0 ? f_n : 0.0);
  return overlap > 0.0 ? pushed : 0.0;
}

/// Damping ratio |ln e| / sqrt(ln^2 e + pi^2) of a coefficient of restitution in (0, 1].
double damping_ratio(double restitution);

}  // namespace packbed::dem
