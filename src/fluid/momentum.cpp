// SPDX-License-Identifier: BSD-3-Clause
#include "fluid/momentum.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/exact_sum.hpp"

namespace packbed::fluid {

namespace {

/// Of an inner face [kg/s].
double diffusion(const Domain& domain,
                 const FluidOptions& options,
                 std::span<const double> face_eps,
                 double weight,
                 std::size_t f) {
  const auto& g = domain.geometry;
  return weight * options.mu_f * face_eps[f] * g.area[f] / (g.d_owner[f] + g.d_neighbor[f]);
}

}  // namespace

FaceMatrix transport_matrix(const Domain& domain,
                            const Border& border,
                            const FluidOptions& options,
                            const Flow& flow,
                            std::span<const double> face_eps,
                            double weight) {
  FaceMatrix m;
  m.diagonal.assign(domain.cells(), 0.0);
  m.upper.resize(domain.inner());
  m.lower.resize(domain.inner());
  const auto& g = domain.geometry;
  const double rho = options.convection == Convection::none ? 0.0 : weight * options.rho_f;
  for (std::size_t f = 0; f < domain.inner(); ++f) {
    const double exchange = diffusion(domain, options, face_eps, weight, f);
    const double carried = rho * flow.flux[f];
    m.upper[f] = -exchange + std::min(carried, 0.0);
    m.lower[f] = -exchange - std::max(carried, 0.0);
    m.diagonal[domain.owner(f)] -= m.upper[f];
    m.diagonal[domain.neighbor(f)] -= m.lower[f];
  }
  for (std::size_t b = 0; b < border.size(); ++b) {
    const auto f = domain.inner() + b;
    double from_border = rho * std::max(-flow.flux[f], 0.0);
    if (border.kind[b] == BorderKind::wall ||
        (border.kind[b] == BorderKind::inlet && border.inward[b] > 0.0)) {
      from_border += weight * options.mu_f * face_eps[f] * g.area[f] / g.d_owner[f];
    }
    m.diagonal[domain.owner(f)] += from_border;
  }
  m.diagonal.resize(domain.own());
  return m;
}

std::vector<double> viscous_exchange(const Domain& domain,
                                     const FluidOptions& options,
                                     std::span<const double> face_eps,
                                     double weight) {
  std::vector<double> all(domain.cells(), 0.0);
  for (std::size_t f = 0; f < domain.inner(); ++f) {
    const double exchange = diffusion(domain, options, face_eps, weight, f);
    all[domain.owner(f)] += exchange;
    all[domain.neighbor(f)] += exchange;
  }
  all.resize(domain.own());
  return all;
}

double norm_of(const Ranks& ranks, std::span<const double> values) {
  double largest = 0.0;
  for (const double v : values) largest = std::max(largest, std::abs(v));
  largest = ranks.max(largest);
  if (!(largest > 0.0) || !std::isfinite(largest)) return largest;
  std::vector<double> squares;
  squares.reserve(values.size());
  for (const double v : values) squares.push_back((v / largest) * (v / largest));
  return largest * std::sqrt(order_independent_sum(squares, ranks));
}

std::vector<Vec3> solve_momentum(const Domain& domain,
                                 LinearSolver& solver,
                                 const FaceMatrix& matrix,
                                 std::span<const Vec3> rhs,
                                 const FluidOptions& options,
                                 double momentum,
                                 SolveReport& report) {
  solver.set_matrix(matrix);
  std::vector<Vec3> du(domain.own());
  constexpr std::array<double Vec3::*, 3> components = {&Vec3::x, &Vec3::y, &Vec3::z};
  for (const auto component : components) {
    std::vector<double> b;
    b.reserve(domain.own());
    for (const auto& r : rhs) b.push_back(r.*component);
    const double size = norm_of(domain.ranks, b);
    if (size == 0.0) continue;
    std::vector<double> x(domain.own(), 0.0);
    const double target = options.momentum_tolerance * (momentum + size);
    const auto one = solver.solve(b, x, target, options.most_iterations, "the velocity");
    for (std::size_t c = 0; c < du.size(); ++c) du[c].*component = x[c];
    report.iterations += one.iterations;
    report.first_residual = std::max(report.first_residual, one.first_residual);
    report.last_residual = std::max(report.last_residual, one.last_residual);
  }
  return du;
}

}  // namespace packbed::fluid
