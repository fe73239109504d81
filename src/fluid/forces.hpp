// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Convective and viscous forces on the liquid in a cell. Equations: docs/theory/liquid.md, section 4.

#include <span>
#include <vector>

#include "fluid/border.hpp"
#include "fluid/domain.hpp"
#include "fluid/options.hpp"

namespace packbed::fluid {

/// The state of the liquid that its forces depend on.
struct Flow {
  std::span<const Vec3> u;       ///< interstitial velocity, all cells [m/s]
  std::span<const double> q;     ///< normal superficial velocity (eps u).n, one per face [m/s]
  std::span<const double> flux;  ///< volume flux relative to the face, one per face [m3/s]
  std::span<const double> eps;   ///< void fraction, all cells
};

/// Void fraction by which viscous forces act at each face: that of two half cells in series; at a border
/// that of the cell, or of the wall.
std::vector<double> viscous_eps(const Domain& domain,
                                const Border& border,
                                std::span<const double> eps);

/// Velocity at each border face [m/s].
std::vector<Vec3> border_velocities(const Domain& domain, const Border& border, const Flow& flow);

/// Force per volume [N/m3] in own cells:
/// (1/V) sum_f { - rho flux (u_f - u_P) + eps_f mu |S| [ (grad u)_f n + (grad u)_f^T n - 2/3 (div u)_f n ] }.
std::vector<Vec3> forces(Domain& domain,
                         const Border& border,
                         const FluidOptions& options,
                         const Flow& flow,
                         std::span<const double> face_eps);

/// Force [N] with which the liquid drags at border face b, along the face.
Vec3 wall_shear(const Domain& domain,
                const Border& border,
                const FluidOptions& options,
                const Flow& flow,
                std::span<const double> face_eps,
                std::size_t b);

}  // namespace packbed::fluid
