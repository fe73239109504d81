// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Sparse linear systems over the cells of all ranks, solved by PETSc. No header of PETSc is needed to
/// use it. Making the first one starts MPI and PETSc if nobody has; both end with the program.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fluid/domain.hpp"

namespace packbed::fluid {

/// How a system is solved.
enum class Method {
  multigrid,  ///< symmetric positive (semi)definite: conjugate gradients, algebraic multigrid
  diagonal    ///< any with a strong diagonal: BiCGStab, Jacobi
};

/// Outcome of one solve. Norms are 2-norms over the cells of all ranks of b - A x, not preconditioned.
struct SolveReport {
  int iterations = 0;
  double first_residual = 0.0;
  double last_residual = 0.0;
  int rebuilt = 0;  ///< how often the preconditioner was made anew
};

/// Values of a matrix with one entry per cell and side of an inner face.
struct FaceMatrix {
  std::vector<double> diagonal;  ///< one per own cell
  std::vector<double> upper;     ///< one per inner face: row of the owner, column of the neighbor
  std::vector<double> lower;     ///< row of the neighbor, column of the owner; empty: as upper
};

/// b - A x in own cells. `x` has the halo.
std::vector<double> residual(const Domain& domain,
                             const FaceMatrix& matrix,
                             std::span<const double> x,
                             std::span<const double> b);

class LinearSolver {
 public:
  /// `constants`: whether the constants are in the null space; then x gets the mean 0.
  LinearSolver(const Domain& domain, Method method, bool constants);
  ~LinearSolver();
  LinearSolver(LinearSolver&& other) noexcept;
  LinearSolver& operator=(LinearSolver&& other) noexcept;
  LinearSolver(const LinearSolver&) = delete;
  LinearSolver& operator=(const LinearSolver&) = delete;

  void set_matrix(const FaceMatrix& matrix);
  /// Makes the preconditioner from the matrix as it is now.
  void build_preconditioner();

  /// Solves from the guess in x (own cells) until the 2-norm of the residual is at most `target`. Where that
  /// fails it starts again with a new preconditioner, then with a plain one and many iterations; then
  /// throws DivergenceError with the residuals of all attempts. `what` names the system there.
  SolveReport solve(std::span<const double> b,
                    std::span<double> x,
                    double target,
                    int most_iterations,
                    const std::string& what);

 private:
  struct Petsc;
  std::unique_ptr<Petsc> petsc_;
};

}  // namespace packbed::fluid
