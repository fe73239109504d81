// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The implicit part of the forces in a first guess of the velocity. It need not be exact: correctors
/// take the forces anew.

#include <span>
#include <vector>

#include "fluid/border.hpp"
#include "fluid/domain.hpp"
#include "fluid/forces.hpp"
#include "fluid/linear_solver.hpp"
#include "fluid/options.hpp"

namespace packbed::fluid {

/// Upwind convection and compact diffusion, times `weight`, as a matrix [kg/s] on velocities. The diagonal of
/// a row is what its neighbors and borders have; nothing of inertia and drag.
FaceMatrix transport_matrix(const Domain& domain,
                            const Border& border,
                            const FluidOptions& options,
                            const Flow& flow,
                            std::span<const double> face_eps,
                            double weight);

/// Sum over the inner faces of each own cell of eps_f mu |S| / distance, times `weight` [kg/s].
std::vector<double> viscous_exchange(const Domain& domain,
                                     const FluidOptions& options,
                                     std::span<const double> face_eps,
                                     double weight);

/// Solves matrix du = rhs, component by component; own cells. `momentum`: 2-norm of diagonal times velocity, to
/// which the tolerance refers. Adds to the report.
std::vector<Vec3> solve_momentum(const Domain& domain,
                                 LinearSolver& solver,
                                 const FaceMatrix& matrix,
                                 std::span<const Vec3> rhs,
                                 const FluidOptions& options,
                                 double momentum,
                                 SolveReport& report);

/// 2-norm over the own cells of all ranks, the same bits for one number of ranks.
double norm_of(const Ranks& ranks, std::span<const double> values);

}  // namespace packbed::fluid
