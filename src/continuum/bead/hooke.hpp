// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <numbers>

#include "continuum/bead/plate_contact.hpp"

namespace packbed::continuum {

/// Linear spring of the bead simulation, per contact F = k delta, delta = Delta / 2, with the stiffness
/// that gives a collision at the speed V the overlap and energy of Hertz's law:
///   k = 16/15 sqrt(R) E* (15 m V^2 / (16 sqrt(R) E*))^(1/5)
/// Thesis eq. 4.21, which prints sqrt(R* Y*) for sqrt(R*) Y*; against a rigid plate, where R* = R, m* = m
/// and Y* = E* = E / (1 - nu^2). E means nothing without V.
struct HookeBead {
  BeadShape shape;
  double youngs_modulus = 0.0;           ///< E [Pa], of the linear law
  double density = 0.0;                  ///< of the wet bead [kg/m3]
  double characteristic_velocity = 0.0;  ///< V [m/s]

  [[nodiscard]] double mass() const {
    const double r = shape.radius;
    return 4.0 / 3.0 * std::numbers::pi * r * r * r * density;
  }

  /// k of one contact [N/m].
  [[nodiscard]] double stiffness() const {
    const double hertz =
        std::sqrt(shape.radius) * youngs_modulus / (1.0 - shape.poisson * shape.poisson);
    const double v2 = characteristic_velocity * characteristic_velocity;
    return 16.0 / 15.0 * hertz * std::pow(15.0 * mass() * v2 / (16.0 * hertz), 0.2);
  }

  [[nodiscard]] double force(double approach) const { return stiffness() * 0.5 * approach; }

  /// E for which the stiffness is k: eq. 4.21 solved for E, k being proportional to E^(4/5).
  [[nodiscard]] double youngs_modulus_of(double k) const {
    HookeBead one = *this;
    one.youngs_modulus = 1.0;
    return std::pow(k / one.stiffness(), 1.25);
  }
};

}  // namespace packbed::continuum
