// SPDX-License-Identifier: BSD-3-Clause
#include "study/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <gsl/gsl_blas.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_multifit.h>
#include <gsl/gsl_multifit_nlinear.h>

#include "core/error.hpp"

namespace packbed::study {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
// Singular values below this share of the largest belong to combinations that the data do not determine.
constexpr double rank_tolerance = 1e-6;
// Components of such a combination that count, its largest being near 1.
constexpr double confounded_share = 0.05;

struct VectorDeleter {
  void operator()(gsl_vector* v) const noexcept { gsl_vector_free(v); }
};
struct MatrixDeleter {
  void operator()(gsl_matrix* m) const noexcept { gsl_matrix_free(m); }
};
struct SolverDeleter {
  void operator()(gsl_multifit_nlinear_workspace* w) const noexcept {
    gsl_multifit_nlinear_free(w);
  }
};
struct LinearDeleter {
  void operator()(gsl_multifit_linear_workspace* w) const noexcept { gsl_multifit_linear_free(w); }
};
using Vector = std::unique_ptr<gsl_vector, VectorDeleter>;
using Matrix = std::unique_ptr<gsl_matrix, MatrixDeleter>;

// GSL would end the program at the first error; we look at its return values.
class QuietGsl {
 public:
  QuietGsl() : before_(gsl_set_error_handler_off()) {}
  ~QuietGsl() { gsl_set_error_handler(before_); }
  QuietGsl(const QuietGsl&) = delete;
  QuietGsl& operator=(const QuietGsl&) = delete;
  QuietGsl(QuietGsl&&) = delete;
  QuietGsl& operator=(QuietGsl&&) = delete;

 private:
  gsl_error_handler_t* before_;
};

bool is_bounded(const FitParameter& p) { return std::isfinite(p.low); }

// The free variable q of the solver: p, or ln p, between its bounds by a logistic curve.
double to_free(const FitParameter& p, double value) {
  const auto scaled = [&](double v) { return p.logarithmic ? std::log(v) : v; };
  if (!is_bounded(p)) return scaled(value);
  const double low = scaled(p.low);
  const double high = scaled(p.high);
  const double share = std::clamp((scaled(value) - low) / (high - low), 1e-4, 1.0 - 1e-4);
  return std::log(share / (1.0 - share));
}

double from_free(const FitParameter& p, double q) {
  if (!is_bounded(p)) return p.logarithmic ? std::exp(q) : q;
  const auto scaled = [&](double v) { return p.logarithmic ? std::log(v) : v; };
  const double v = scaled(p.low) + (scaled(p.high) - scaled(p.low)) / (1.0 + std::exp(-q));
  return std::clamp(p.logarithmic ? std::exp(v) : v, p.low,
                    p.high);  // but for round-off it is there
}

std::vector<double> from_free(const std::vector<FitParameter>& parameters, const gsl_vector& q) {
  std::vector<double> values(parameters.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = from_free(parameters[i], gsl_vector_get(&q, i));
  }
  return values;
}

int evaluate(const gsl_vector* q, void* context, gsl_vector* f) {
  const auto& problem = *static_cast<const FitProblem*>(context);
  const auto values = from_free(problem.parameters, *q);
  // f may be a column of GSL's Jacobian, whose elements do not stand side by side.
  std::vector<double> residuals(problem.rows);
  problem.residuals(values, residuals);
  for (std::size_t i = 0; i < problem.rows; ++i) gsl_vector_set(f, i, residuals[i]);
  return GSL_SUCCESS;
}

// d(residual)/d(p or ln p) at the solution, by central differences.
Matrix jacobian(const FitProblem& problem, const std::vector<double>& at) {
  const std::size_t n = at.size();
  Matrix j(gsl_matrix_alloc(problem.rows, n));
  std::vector<double> up(problem.rows);
  std::vector<double> down(problem.rows);
  for (std::size_t k = 0; k < n; ++k) {
    const auto& p = problem.parameters[k];
    const double scale = p.logarithmic   ? 1.0
                         : is_bounded(p) ? std::max(std::abs(at[k]), 1e-3 * (p.high - p.low))
                                         : std::max(std::abs(at[k]), 1e-12);
    const double step = 1e-5 * scale;
    auto values = at;
    const auto moved = [&](double by) { return p.logarithmic ? at[k] * std::exp(by) : at[k] + by; };
    values[k] = moved(step);
    problem.residuals(values, up);
    values[k] = moved(-step);
    problem.residuals(values, down);
    for (std::size_t i = 0; i < problem.rows; ++i) {
      gsl_matrix_set(j.get(), i, k, (up[i] - down[i]) / (2.0 * step));
    }
  }
  return j;
}

// Covariance (J^T J)^-1 s^2 by singular values of J with its columns scaled to length 1; combinations that are
// not determined go to `confounded`, and their parameters get an infinite error.
void add_covariance(const FitProblem& problem, double variance, Fit& fit) {
  const std::size_t n = fit.size();
  auto j = jacobian(problem, fit.values());
  std::vector<double> length(n, 0.0);
  for (std::size_t k = 0; k < n; ++k) {
    auto column = gsl_matrix_column(j.get(), k);
    for (std::size_t i = 0; i < problem.rows; ++i) {
      length[k] = std::hypot(length[k], gsl_vector_get(&column.vector, i));
    }
    if (length[k] > 0.0) gsl_vector_scale(&column.vector, 1.0 / length[k]);
  }
  const Matrix v(gsl_matrix_alloc(n, n));
  const Vector s(gsl_vector_alloc(n));
  const Vector work(gsl_vector_alloc(n));
  gsl_linalg_SV_decomp(j.get(), v.get(), s.get(), work.get());
  fit.covariance.assign(n * n, 0.0);
  std::vector<bool> undetermined(n, false);
  for (std::size_t m = 0; m < n; ++m) {
    const double value = gsl_vector_get(s.get(), m);
    if (value > rank_tolerance * gsl_vector_get(s.get(), 0)) {
      for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = 0; b < n; ++b) {
          fit.covariance[a * n + b] += variance * gsl_matrix_get(v.get(), a, m) *
                                       gsl_matrix_get(v.get(), b, m) /
                                       (value * value * length[a] * length[b]);
        }
      }
      continue;
    }
    Confounded group;
    for (std::size_t a = 0; a < n; ++a) {
      if (std::abs(gsl_matrix_get(v.get(), a, m)) < confounded_share && length[a] > 0.0) continue;
      undetermined[a] = true;
      group.names.push_back(fit.parameters[a].name);
    }
    fit.confounded.push_back(std::move(group));
  }
  for (std::size_t a = 0; a < n; ++a) {
    if (undetermined[a]) fit.covariance[a * n + a] = infinity;
  }
}

void add_estimates(Fit& fit) {
  const std::size_t n = fit.size();
  fit.correlation.assign(n * n, nothing);
  for (std::size_t a = 0; a < n; ++a) {
    auto& e = fit.estimates[a];
    const auto& p = fit.parameters[a];
    const double sd = std::sqrt(fit.covariance[a * n + a]);
    e.error = p.logarithmic ? sd * e.value : sd;
    e.low = p.logarithmic ? e.value * std::exp(-fit.quantile * sd) : e.value - fit.quantile * sd;
    e.high = p.logarithmic ? e.value * std::exp(fit.quantile * sd) : e.value + fit.quantile * sd;
    if (is_bounded(p)) {
      const double share = p.logarithmic ? std::log(e.value / p.low) / std::log(p.high / p.low)
                                         : (e.value - p.low) / (p.high - p.low);
      e.at_bound = share < 1e-3 || share > 1.0 - 1e-3;
      e.low = std::max(e.low, p.low);
      e.high = std::min(e.high, p.high);
    }
    for (std::size_t b = 0; b < n; ++b) {
      const double other = std::sqrt(fit.covariance[b * n + b]);
      if (std::isfinite(sd * other))
        fit.correlation[a * n + b] = fit.covariance[a * n + b] / (sd * other);
    }
  }
}

constexpr std::size_t most_iterations = 200;

// To the last digit: the parameters matter.
int drive(gsl_multifit_nlinear_workspace* solver) {
  int why = 0;
  const int status = gsl_multifit_nlinear_driver(most_iterations, 1e-11, 1e-11, 1e-14, nullptr,
                                                 nullptr, &why, solver);
  // From a start that no step makes better the driver says that its iterations are used up.
  return why == GSL_ENOPROG ? GSL_ENOPROG : status;
}

// Until four steps in a row gain less than `least_gain`: the sum of squares matters, and along a flat valley the
// parameters may go on for ever.
int drive_down(gsl_multifit_nlinear_workspace* solver, double least_gain) {
  const auto sum = [&] {
    const double norm = gsl_blas_dnrm2(gsl_multifit_nlinear_residual(solver));
    return norm * norm;
  };
  double before = sum();
  int small = 0;
  for (std::size_t i = 0; i < most_iterations && small < 4; ++i) {
    const int status = gsl_multifit_nlinear_iterate(solver);
    if (status != GSL_SUCCESS) return status;
    const double now = sum();
    small = before - now < least_gain ? small + 1 : 0;
    before = now;
  }
  return GSL_SUCCESS;
}

// least_gain 0: to the last digit.
Fit solve(const FitProblem& problem, double least_gain = 0.0) {
  const std::size_t n = problem.parameters.size();
  auto settings = gsl_multifit_nlinear_default_parameters();
  settings.fdtype = GSL_MULTIFIT_NLINEAR_CTRDIFF;
  if (least_gain > 0.0) settings.trs = gsl_multifit_nlinear_trs_lmaccel;  // for curved valleys
  settings.solver = gsl_multifit_nlinear_solver_svd;  // bears columns that depend on each other
  const std::unique_ptr<gsl_multifit_nlinear_workspace, SolverDeleter> solver(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, problem.rows, n));
  const Vector start(gsl_vector_alloc(n));
  for (std::size_t i = 0; i < n; ++i) {
    gsl_vector_set(start.get(), i, to_free(problem.parameters[i], problem.parameters[i].start));
  }
  gsl_multifit_nlinear_fdf system{};
  system.f = evaluate;
  system.n = problem.rows;
  system.p = n;
  system.params = const_cast<FitProblem*>(&problem);
  gsl_multifit_nlinear_init(start.get(), &system, solver.get());
  const int status = least_gain > 0.0 ? drive_down(solver.get(), least_gain) : drive(solver.get());
  Fit fit;
  fit.parameters = problem.parameters;
  fit.rows = problem.rows;
  fit.iterations = static_cast<int>(gsl_multifit_nlinear_niter(solver.get()));
  // GSL_ENOPROG: no step makes it better, which is an end at round-off, too.
  fit.converged = status == GSL_SUCCESS || status == GSL_ENOPROG;
  const auto values = from_free(problem.parameters, *gsl_multifit_nlinear_position(solver.get()));
  for (std::size_t i = 0; i < n; ++i) {
    fit.estimates.push_back({.name = problem.parameters[i].name, .value = values[i]});
  }
  const auto* residual = gsl_multifit_nlinear_residual(solver.get());
  for (std::size_t i = 0; i < problem.rows; ++i) {
    fit.sum_of_squares += gsl_vector_get(residual, i) * gsl_vector_get(residual, i);
  }
  return fit;
}

// Errors, intervals and correlations of a solution.
void judge(const FitProblem& problem, Fit& fit) {
  const auto freedom = static_cast<double>(problem.rows - fit.size());
  fit.quantile =
      problem.known_errors ? gsl_cdf_ugaussian_Pinv(0.975) : gsl_cdf_tdist_Pinv(0.975, freedom);
  add_covariance(problem, problem.known_errors ? 1.0 : fit.sum_of_squares / freedom, fit);
  add_estimates(fit);
}

void check_rows(const FitProblem& problem) {
  if (problem.rows > problem.parameters.size()) return;
  throw ValueError(
      fmt::format("{} rows of data for {} parameters; at least {} rows are needed, or a model with "
                  "fewer parameters",
                  problem.rows, problem.parameters.size(), problem.parameters.size() + 1));
}

}  // namespace

std::vector<double> Fit::values() const {
  std::vector<double> all;
  for (const auto& e : estimates) all.push_back(e.value);
  return all;
}

double Fit::bic() const {
  const auto n = static_cast<double>(rows);
  return n * std::log(sum_of_squares / n) + static_cast<double>(size()) * std::log(n);
}

Fit least_squares(const FitProblem& problem) {
  check_rows(problem);
  const QuietGsl quiet;
  auto fit = solve(problem);
  judge(problem, fit);
  return fit;
}

Fit least_squares_values(const FitProblem& problem, double least_gain) {
  const QuietGsl quiet;
  return solve(problem, least_gain);
}

StartedFit least_squares(const FitProblem& problem,
                         const std::vector<std::vector<double>>& starts) {
  check_rows(problem);
  const QuietGsl quiet;
  StartedFit best;
  std::vector<double> sums;
  for (const auto& start : starts) {
    auto started = problem;
    for (std::size_t i = 0; i < start.size(); ++i) started.parameters[i].start = start[i];
    auto fit = solve(started);
    sums.push_back(fit.sum_of_squares);
    if (best.starts == 0 || fit.sum_of_squares < best.fit.sum_of_squares) best.fit = std::move(fit);
    ++best.starts;
  }
  for (const double sum : sums) {
    if (sum <= best.fit.sum_of_squares * (1.0 + 1e-4) + 1e-24) ++best.agreeing;
  }
  judge(problem, best.fit);
  return best;
}

Estimate derived(const Fit& fit,
                 const std::string& name,
                 const std::function<double(std::span<const double>)>& figure) {
  const std::size_t n = fit.size();
  const auto at = fit.values();
  std::vector<double> gradient(n);
  for (std::size_t k = 0; k < n; ++k) {
    const auto& p = fit.parameters[k];
    const double step = p.logarithmic ? 1e-5 : 1e-5 * std::max(std::abs(at[k]), 1e-12);
    auto values = at;
    values[k] = p.logarithmic ? at[k] * std::exp(step) : at[k] + step;
    const double up = figure(values);
    values[k] = p.logarithmic ? at[k] * std::exp(-step) : at[k] - step;
    gradient[k] = (up - figure(values)) / (2.0 * step);
  }
  double variance = 0.0;
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      if (gradient[a] != 0.0 && gradient[b] != 0.0) {
        variance += gradient[a] * fit.covariance[a * n + b] * gradient[b];
      }
    }
  }
  Estimate e{.name = name, .value = figure(at), .error = std::sqrt(std::max(variance, 0.0))};
  e.low = e.value - fit.quantile * e.error;
  e.high = e.value + fit.quantile * e.error;
  for (const auto& parameter : fit.estimates) e.at_bound = e.at_bound || parameter.at_bound;
  return e;
}

Amplitudes amplitudes(const std::vector<std::vector<double>>& basis, std::span<const double> data) {
  const QuietGsl quiet;
  const std::size_t n = data.size();
  const std::size_t k = basis.size();
  const Matrix x(gsl_matrix_alloc(n, k));
  const Matrix covariance(gsl_matrix_alloc(k, k));
  const Vector c(gsl_vector_alloc(k));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t m = 0; m < k; ++m) gsl_matrix_set(x.get(), i, m, basis[m][i]);
  }
  const auto y = gsl_vector_const_view_array(data.data(), n);
  const std::unique_ptr<gsl_multifit_linear_workspace, LinearDeleter> work(
      gsl_multifit_linear_alloc(n, k));
  Amplitudes a;
  gsl_multifit_linear(x.get(), &y.vector, c.get(), covariance.get(), &a.sum_of_squares, work.get());
  for (std::size_t m = 0; m < k; ++m) a.values.push_back(gsl_vector_get(c.get(), m));
  return a;
}

double r_squared(std::span<const double> data, std::span<const double> model) {
  double mean = 0.0;
  for (const double d : data) mean += d / static_cast<double>(data.size());
  double about_mean = 0.0;
  double about_model = 0.0;
  for (std::size_t i = 0; i < data.size(); ++i) {
    about_mean += (data[i] - mean) * (data[i] - mean);
    about_model += (data[i] - model[i]) * (data[i] - model[i]);
  }
  return 1.0 - about_model / about_mean;
}

}  // namespace packbed::study
