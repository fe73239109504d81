// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The balance of momentum of one step, cell by cell, and the flux through a face that follows from it.
/// Equations: docs/theory/liquid.md, sections 3 and 5.

#include <span>
#include <vector>

#include "fluid/domain.hpp"

namespace packbed::fluid {

/// Of a cell, per its volume and over eps: what its superficial velocity meets,
///   resistance (eps u) = drive + inertia (eps u)_old - grad p.
struct CellBalance {
  double resistance = 0.0;  ///< inertia and implicit drag [Pa s/m2]
  double inertia = 0.0;     ///< share of the old velocity [Pa s/m2]
  double viscous = 0.0;     ///< what neighbors exchange with it by viscosity [Pa s/m2]
};

/// flux = conductance (p_owner - p_neighbor + push), at the border less the pressure there: conductances
/// |S| / (R_P d_P + R_N d_N) of all faces [m3/(s Pa)]. `cells` has the halo.
std::vector<double> conductances(const Domain& domain, std::span<const CellBalance> cells);

/// The pushes of all faces [Pa]. `drive` [Pa/m] has the halo; `q_old`: normal superficial velocities of faces at the
/// start of the step [m/s]; `grad_p` [Pa/m], with halo, serves faces that lean.
std::vector<double> pushes(const Domain& domain,
                           std::span<const CellBalance> cells,
                           std::span<const Vec3> drive,
                           std::span<const double> q_old,
                           std::span<const Vec3> grad_p);

/// Share of the part of q that cells do not see (unseen, gradient.hpp) by which a corrector reduces it, one per
/// inner face.
std::vector<double> damping(const Domain& domain, std::span<const CellBalance> cells);

}  // namespace packbed::fluid
