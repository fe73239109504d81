// SPDX-License-Identifier: BSD-3-Clause
#include "fluid/pressure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/exact_sum.hpp"

namespace packbed::fluid {
namespace {

/// Mean over the own cells of all ranks.
double mean(const Domain& domain, std::span<const double> values) {
  return order_independent_sum(values, domain.ranks) /
         static_cast<double>(domain.mesh.cell_count());
}

/// Without outlet: takes rounding out of the sum, refuses what is more.
void close(const Domain& domain, std::vector<double>& rhs, double size) {
  const double excess = mean(domain, rhs);
  const auto cells = static_cast<double>(domain.mesh.cell_count());
  // 1e-9: fluxes of a million cells add up to 1e-10 of their size.
  if (std::abs(excess) * std::sqrt(cells) > 1e-9 * size) {
    throw DivergenceError(fmt::format(
        "the liquid has no outlet and does not fit: {:.6g} m3/s too much flows in or is displaced; "
        "give a patch a pressure",
        excess * cells));
  }
  for (double& r : rhs) r -= excess;
}

}  // namespace

FaceMatrix pressure_matrix(const Domain& domain,
                           const Border& border,
                           std::span<const double> conductance) {
  FaceMatrix m;
  m.diagonal.assign(domain.cells(), 0.0);
  m.upper.resize(domain.inner());
  for (std::size_t f = 0; f < domain.inner(); ++f) {
    m.upper[f] = -conductance[f];
    m.diagonal[domain.owner(f)] += conductance[f];
    m.diagonal[domain.neighbor(f)] += conductance[f];
  }
  for (std::size_t b = 0; b < border.size(); ++b) {
    const auto f = domain.inner() + b;
    if (border.kind[b] == BorderKind::outlet) m.diagonal[domain.owner(f)] += conductance[f];
  }
  m.diagonal.resize(domain.own());
  return m;
}

PressureSolver::PressureSolver(const Domain& domain, const Border& border)
    : solver_(domain, Method::multigrid, !border.has_outlet) {}

void PressureSolver::renew(std::span<const double> conductance) {
  solver_.build_preconditioner();
  state_ = {.conductance = {conductance.begin(), conductance.end()}, .per_decade = 0.0};
}

void PressureSolver::restore(const Domain& domain,
                             const Border& border,
                             PreconditionerState state) {
  if (!state.conductance.empty()) {
    solver_.set_matrix(pressure_matrix(domain, border, state.conductance));
    solver_.build_preconditioner();
  }
  state_ = std::move(state);
}

// The preconditioner is kept until a solve needs half as many iterations more per decade, and 5 or more.
void PressureSolver::watch(const SolveReport& report, std::span<const double> conductance) {
  if (report.rebuilt > 0) {
    state_ = {.conductance = {conductance.begin(), conductance.end()}, .per_decade = 0.0};
    if (report.rebuilt > 1) state_.conductance.clear();
    return;
  }
  if (!(report.first_residual > 10.0 * report.last_residual) || report.last_residual <= 0.0) return;
  const double per_decade =
      report.iterations / std::log10(report.first_residual / report.last_residual);
  if (state_.per_decade == 0.0) {
    state_.per_decade = per_decade;
  } else if (report.iterations > 5 && per_decade > 1.5 * state_.per_decade) {
    state_.conductance.clear();
  }
}

SolveReport PressureSolver::solve(Domain& domain,
                                  const Border& border,
                                  std::span<const double> conductance,
                                  std::vector<double>& rhs,
                                  double size,
                                  const FluidOptions& options,
                                  std::vector<double>& p) {
  if (!border.has_outlet) close(domain, rhs, size);
  const auto matrix = pressure_matrix(domain, border, conductance);
  solver_.set_matrix(matrix);
  if (state_.conductance.empty()) renew(conductance);
  const std::span<double> own(p.data(), domain.own());
  const auto report = solver_.solve(rhs, own, options.pressure_tolerance * size,
                                    options.most_iterations, "the pressure");
  watch(report, conductance);
  if (!border.has_outlet) {
    const double level = mean(domain, own);
    for (double& value : own) value -= level;
  }
  domain.halo.refresh(p);
  return report;
}

}  // namespace packbed::fluid
