// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The pressure of one corrector, from continuity, and when its preconditioner is made anew.

#include <span>
#include <string>
#include <vector>

#include "fluid/border.hpp"
#include "fluid/domain.hpp"
#include "fluid/linear_solver.hpp"
#include "fluid/options.hpp"

namespace packbed::fluid {

/// What a run that goes on from here must know of the solver: from what its preconditioner was made.
struct PreconditionerState {
  std::vector<double> conductance;  ///< one per face; empty: it will be made at the next solve
  double per_decade =
      0.0;  ///< iterations per factor 10 of residual, when it was new; 0: not yet known
};

class PressureSolver {
 public:
  PressureSolver(const Domain& domain, const Border& border);

  /// Solves sum_f conductance (p_P - p_N) = rhs for a change of pressure, with its halo, so that the 2-norm of the
  /// residual is at most the tolerance of `options` times `size` [m3/s]. Without outlet the sum of rhs must vanish,
  /// and p gets the mean 0.
  SolveReport solve(Domain& domain,
                    const Border& border,
                    std::span<const double> conductance,
                    std::vector<double>& rhs,
                    double size,
                    const FluidOptions& options,
                    std::vector<double>& p);

  [[nodiscard]] const PreconditionerState& state() const { return state_; }
  /// Makes the preconditioner of a saved run again.
  void restore(const Domain& domain, const Border& border, PreconditionerState state);

 private:
  void renew(std::span<const double> conductance);
  void watch(const SolveReport& report, std::span<const double> conductance);

  LinearSolver solver_;
  PreconditionerState state_;
};

/// The matrix of the equation above.
FaceMatrix pressure_matrix(const Domain& domain,
                           const Border& border,
                           std::span<const double> conductance);

}  // namespace packbed::fluid
