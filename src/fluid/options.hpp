// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// What a user may choose about the liquid and its solver. SI units.

#include "core/vec3.hpp"
#include "fluid/boundary.hpp"

namespace packbed::fluid {

/// Velocity at a face in the convective term. `limited`: second order, between upwind and downwind
/// (MUSCL: min(2 r, (1 + r)/2, 2), per component); the thesis's choice (table B.5).
enum class Convection { none, upwind, central, limited };

struct FluidOptions {
  double rho_f = 998.2;           ///< density [kg/m3]
  double mu_f = 1.0e-3;           ///< dynamic viscosity [Pa s]
  Vec3 gravity{0.0, 0.0, -9.81};  ///< [m/s2]
  Boundaries boundaries{};

  /// 0: Euler; 1: Crank-Nicolson; the thesis: 0.3. Convection and viscous forces at the end of the
  /// step count with 1/(1 + crank_nicolson), those at its start with the rest.
  double crank_nicolson = 0.3;
  Convection convection = Convection::limited;
  int correctors = 2;  ///< pressure solves per step, >= 1

  /// Of the pressure solve: continuity error over what passes the cells, both as 2-norms.
  double pressure_tolerance = 1e-8;
  /// Of the first guess of the velocity: residual over what the cells hold of momentum, 2-norms.
  double momentum_tolerance = 1e-8;
  int most_iterations = 500;  ///< of one linear solve

  /// Throws ValueError for a number out of its range.
  void check() const;
  bool operator==(const FluidOptions&) const = default;
};

}  // namespace packbed::fluid
