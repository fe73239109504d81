// SPDX-License-Identifier: BSD-3-Clause
#include "fluid/linear_solver.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <petscksp.h>

#include "core/error.hpp"
#include "fluid/petsc_session.hpp"

namespace packbed::fluid {
namespace {

// PETSc's own message stands before ours on stderr only if its handler prints; ours returns the code.
void check(PetscErrorCode code) {
  if (code == 0) return;
  const char* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  throw DivergenceError(fmt::format("PETSc failed with code {}: {}", static_cast<int>(code),
                                    text != nullptr ? text : "no message"));
}

/// Rows and columns of the entries of a FaceMatrix in own rows: diagonal, then per inner face those of
/// owner and neighbor.
struct Pattern {
  std::vector<PetscInt> rows, columns;
};

Pattern pattern(const Domain& domain) {
  Pattern entries;
  const auto& cell = domain.part.cell;
  const auto add = [&](std::size_t row, std::size_t column) {
    entries.rows.push_back(static_cast<PetscInt>(cell[row]));
    entries.columns.push_back(static_cast<PetscInt>(cell[column]));
  };
  for (std::size_t c = 0; c < domain.own(); ++c) add(c, c);
  for (std::size_t f = 0; f < domain.inner(); ++f) {
    const auto p = domain.owner(f);
    const auto q = domain.neighbor(f);
    if (domain.is_own(p)) add(p, q);
    if (domain.is_own(q)) add(q, p);
  }
  return entries;
}

/// One attempt.
struct Attempt {
  bool good = false;
  int iterations = 0;
  double first = 0.0, last = 0.0;
  int reason = 0;
};

std::string told(const char* with, const Attempt& a) {
  return fmt::format("{}: {} iterations from {:.3e} to {:.3e} (PETSc reason {})", with,
                     a.iterations, a.first, a.last, a.reason);
}

}  // namespace

struct LinearSolver::Petsc {
  Method method;
  bool constants;
  MPI_Comm comm = MPI_COMM_NULL;
  Mat matrix = nullptr;
  Vec x = nullptr, b = nullptr, r = nullptr;
  KSP solver = nullptr;
  std::size_t own = 0;
  std::size_t inner = 0;
  std::vector<std::pair<bool, bool>> own_sides;  ///< per inner face: owner, neighbor
  Pattern entries;
  std::vector<double> values;
  bool built = false;
  bool has_served = false;  ///< the matrix, for a preconditioner

  ~Petsc() { destroy(); }

  void destroy();
  void take_pattern(const Domain& domain);
  void make_matrix();
  void make_solver(bool plain);
  [[nodiscard]] double rounding_floor() const;
  PetscErrorCode solve_once(double target, int most, Attempt& all);
  Attempt attempt(std::span<const double> rhs, std::span<double> guess, double target, int most);
};

void LinearSolver::Petsc::destroy() {
  KSPDestroy(&solver);
  VecDestroy(&x);
  VecDestroy(&b);
  VecDestroy(&r);
  MatDestroy(&matrix);
}

void LinearSolver::Petsc::take_pattern(const Domain& domain) {
  own = domain.own();
  inner = domain.inner();
  for (std::size_t f = 0; f < inner; ++f) {
    own_sides.emplace_back(domain.is_own(domain.owner(f)), domain.is_own(domain.neighbor(f)));
  }
  comm = domain.ranks.size() > 1 ? PETSC_COMM_WORLD : PETSC_COMM_SELF;
  entries = pattern(domain);
  values.resize(entries.rows.size());
}

void LinearSolver::Petsc::make_matrix() {
  const auto rows = static_cast<PetscInt>(own);
  check(MatCreate(comm, &matrix));
  check(MatSetSizes(matrix, rows, rows, PETSC_DETERMINE, PETSC_DETERMINE));
  check(MatSetType(matrix, MATAIJ));
  auto taken = entries;  // PETSc writes into what it is given
  check(MatSetPreallocationCOO(matrix, static_cast<PetscCount>(taken.rows.size()),
                               taken.rows.data(), taken.columns.data()));
  if (method == Method::multigrid) check(MatSetOption(matrix, MAT_SPD, PETSC_TRUE));
  if (constants) {
    MatNullSpace space = nullptr;
    check(MatNullSpaceCreate(comm, PETSC_TRUE, 0, nullptr, &space));
    check(MatSetNullSpace(matrix, space));
    check(MatNullSpaceDestroy(&space));
  }
  check(MatCreateVecs(matrix, &x, &b));
  check(VecDuplicate(b, &r));
}

/// Plain: no multigrid, for systems on which that fails.
void LinearSolver::Petsc::make_solver(bool plain) {
  check(KSPDestroy(&solver));
  check(KSPCreate(comm, &solver));
  const bool symmetric = method == Method::multigrid;
  check(KSPSetType(solver, symmetric ? KSPCG : KSPBCGS));
  check(KSPSetNormType(solver, symmetric ? KSP_NORM_UNPRECONDITIONED : KSP_NORM_PRECONDITIONED));
  PC pc = nullptr;
  check(KSPGetPC(solver, &pc));
  if (symmetric && !plain) {
    check(PCSetType(pc, PCGAMG));
    check(PCGAMGSetReuseInterpolation(pc, PETSC_FALSE));
    // Weak couplings of flat cells are left out, and two levels are coarsened twice as far: more iterations,
    // cheaper ones, and hardly more on finer meshes (docs/performance.md).
    PetscReal threshold = 0.01;
    check(PCGAMGSetThreshold(pc, &threshold, 1));
    check(PCGAMGSetAggressiveLevels(pc, 2));
  } else {
    check(PCSetType(pc, PCJACOBI));
    if (!symmetric) {
      check(KSPSetNormType(solver, KSP_NORM_UNPRECONDITIONED));
      check(KSPSetPCSide(solver, PC_RIGHT));
    }
  }
  check(KSPSetInitialGuessNonzero(solver, PETSC_TRUE));
  check(KSPSetOperators(solver, matrix, matrix));
  check(KSPSetReusePreconditioner(solver, PETSC_FALSE));
}

/// Iterates; the residual that the method carries along drifts from the true one, which alone counts: where that is
/// still too large, it goes on from there, as far as rounding lets any go.
Attempt LinearSolver::Petsc::attempt(std::span<const double> rhs,
                                     std::span<double> guess,
                                     double target,
                                     int most) {
  constexpr double slack = 1.01;  // of rounding between the two residuals
  constexpr int most_rounds = 3;
  Attempt all;
  check(VecPlaceArray(b, rhs.data()));
  check(VecPlaceArray(x, guess.data()));
  PetscErrorCode code = 0;
  for (int round = 0; code == 0 && round < most_rounds && !all.good; ++round) {
    code = solve_once(target, most, all);
    if (all.reason < 0) break;
    all.good = all.last <= slack * std::max(target, rounding_floor());
  }
  check(VecResetArray(x));
  check(VecResetArray(b));
  check(code);
  return all;
}

/// Rounding of b - A x: some units in the last place of the diagonal times x, as a 2-norm.
double LinearSolver::Petsc::rounding_floor() const {
  double size = 0.0;
  check(MatGetDiagonal(matrix, r));
  check(VecPointwiseMult(r, r, x));
  check(VecNorm(r, NORM_2, &size));
  return 4.0 * std::numeric_limits<double>::epsilon() * size;
}

PetscErrorCode LinearSolver::Petsc::solve_once(double target, int most, Attempt& all) {
  double first = 0.0;
  check(MatResidual(matrix, b, x, r));
  check(VecNorm(r, NORM_2, &first));
  if (all.iterations == 0) all.first = first;
  check(KSPSetTolerances(solver, 0.0, target, 1e30, most));
  if (const auto code = KSPSolve(solver, b, x); code != 0) return code;
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  PetscInt iterations = 0;
  check(KSPGetConvergedReason(solver, &reason));
  check(KSPGetIterationNumber(solver, &iterations));
  check(MatResidual(matrix, b, x, r));
  check(VecNorm(r, NORM_2, &all.last));
  all.iterations += static_cast<int>(iterations);
  all.reason = reason;
  return 0;
}

LinearSolver::LinearSolver(const Domain& domain, Method method, bool constants) {
  start_petsc();
  petsc_ = std::make_unique<Petsc>();
  petsc_->method = method;
  petsc_->constants = constants;
  petsc_->take_pattern(domain);
  petsc_->make_matrix();
}

LinearSolver::~LinearSolver() = default;
LinearSolver::LinearSolver(LinearSolver&& other) noexcept = default;
LinearSolver& LinearSolver::operator=(LinearSolver&& other) noexcept = default;

void LinearSolver::set_matrix(const FaceMatrix& matrix) {
  auto& values = petsc_->values;
  std::size_t k = 0;
  for (const double d : matrix.diagonal) values[k++] = d;
  const auto& lower = matrix.lower.empty() ? matrix.upper : matrix.lower;
  for (std::size_t f = 0; f < petsc_->inner; ++f) {
    if (petsc_->own_sides[f].first) values[k++] = matrix.upper[f];
    if (petsc_->own_sides[f].second) values[k++] = lower[f];
  }
  check(MatSetValuesCOO(petsc_->matrix, values.data(), INSERT_VALUES));
}

// How PETSc makes the coarse matrices of the multigrid on several ranks: by default it adds what comes from other
// ranks in the order of arrival, and so gives other bits from run to run on three ranks and more. On one rank
// it knows no such choice, and refuses the option.
// It is made from a new matrix, too: what a multigrid comes to depends on whether its matrix has served before, and a
// run that is resumed must go on with the same bits.
void LinearSolver::build_preconditioner() {
  if (std::exchange(petsc_->has_served, true) && petsc_->method == Method::multigrid) {
    petsc_->destroy();
    petsc_->make_matrix();
    check(MatSetValuesCOO(petsc_->matrix, petsc_->values.data(), INSERT_VALUES));
  }
  petsc_->make_solver(false);
  const bool shared = petsc_->comm != PETSC_COMM_SELF;
  if (shared) check(PetscOptionsSetValue(nullptr, "-matptap_via", "allatonce"));
  const auto code = KSPSetUp(petsc_->solver);
  if (shared) check(PetscOptionsClearValue(nullptr, "-matptap_via"));
  check(code);
  if (petsc_->method == Method::multigrid) {
    check(KSPSetReusePreconditioner(petsc_->solver, PETSC_TRUE));
  }
  petsc_->built = true;
}

SolveReport LinearSolver::solve(std::span<const double> b,
                                std::span<double> x,
                                double target,
                                int most_iterations,
                                const std::string& what) {
  SolveReport report;
  if (!petsc_->built) build_preconditioner();
  const std::vector<double> guess(x.begin(), x.end());
  std::string history;
  for (int trial = 0; trial < 3; ++trial) {
    if (trial == 1) build_preconditioner();
    if (trial == 2) {
      petsc_->make_solver(true);
      petsc_->built = false;
    }
    const auto a =
        petsc_->attempt(b, x, target, trial < 2 ? most_iterations : 20 * most_iterations);
    if (trial == 0) report.first_residual = a.first;
    report.iterations += a.iterations;
    report.last_residual = a.last;
    if (a.good) {
      report.rebuilt = trial;
      return report;
    }
    constexpr std::array names = {"preconditioner kept", "preconditioner made anew", "plain"};
    history += told(names[static_cast<std::size_t>(trial)], a) + (trial < 2 ? "; " : "");
    std::copy(guess.begin(), guess.end(), x.begin());
  }
  throw DivergenceError(fmt::format("the solve for {} does not reach a residual of {:.3e}; {}",
                                    what, target, history));
}

std::vector<double> residual(const Domain& domain,
                             const FaceMatrix& matrix,
                             std::span<const double> x,
                             std::span<const double> b) {
  std::vector<double> r(domain.cells(), 0.0);
  for (std::size_t c = 0; c < domain.own(); ++c) r[c] = b[c] - matrix.diagonal[c] * x[c];
  const auto& lower = matrix.lower.empty() ? matrix.upper : matrix.lower;
  for (std::size_t f = 0; f < domain.inner(); ++f) {
    const auto p = domain.owner(f);
    const auto q = domain.neighbor(f);
    r[p] -= matrix.upper[f] * x[q];
    r[q] -= lower[f] * x[p];
  }
  r.resize(domain.own());
  return r;
}

}  // namespace packbed::fluid
