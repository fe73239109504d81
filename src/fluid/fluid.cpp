// SPDX-License-Identifier: BSD-3-Clause
// The stages of a step of the liquid.
#include "fluid/fluid.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "fluid/fluid_step.hpp"
#include "fluid/gradient.hpp"
#include "fluid/momentum.hpp"
#include "fluid/time_scheme.hpp"

namespace packbed::fluid {

/// Border faces with a known flux get it; then all fluxes follow from the velocities of faces.
void Fluid::set_flux() {
  const auto inner = domain_.inner();
  const auto& g = domain_.geometry;
  for (std::size_t f = 0; f < domain_.faces(); ++f) {
    const auto p = domain_.owner(f);
    if (f < inner) {
      const double w = g.owner_weight(f);
      const double eps = w * eps_[p] + (1.0 - w) * eps_[domain_.neighbor(f)];
      flux_[f] = g.area[f] * (q_[f] - eps * mesh_speed_[f]);
      continue;
    }
    const auto b = f - inner;
    const double carried = eps_[p] * mesh_speed_[f];
    if (border_.kind[b] != BorderKind::outlet) q_[f] = carried - border_.inward[b];
    flux_[f] = border_.kind[b] == BorderKind::outlet ? g.area[f] * (q_[f] - carried)
                                                     : -g.area[f] * border_.inward[b];
  }
}

/// Gradient of eps u, where cells lean; else empty.
std::vector<Tensor> Fluid::superficial_gradient() {
  if (domain_.geometry.orthogonal) return {};
  auto at_border = border_velocities(domain_, border_, flow());
  for (std::size_t b = 0; b < at_border.size(); ++b) {
    at_border[b] *= eps_[domain_.owner(domain_.inner() + b)];
  }
  return gradient(domain_, superficial(eps_, u_), at_border);
}

/// Velocities of cells from those of faces. Where cells lean, first by the change since the last time, for the
/// gradient that the final ones need.
void Fluid::set_velocity(Step& s) {
  if (!domain_.geometry.orthogonal) {
    std::vector<double> change(q_.size());
    for (std::size_t f = 0; f < change.size(); ++f) change[f] = q_[f] - s.fitted_q[f];
    const auto more = reconstruct(domain_, change, {});
    for (std::size_t c = 0; c < domain_.own(); ++c) {
      u_[c] = (1.0 / eps_[c]) * (s.fitted[c] + more[c]);
    }
    domain_.halo.refresh(u_);
  }
  s.fitted = reconstruct(domain_, q_, superficial_gradient());
  s.fitted_q = q_;
  for (std::size_t c = 0; c < domain_.own(); ++c) u_[c] = (1.0 / eps_[c]) * s.fitted[c];
  domain_.halo.refresh(u_);
}

StepReport Fluid::step(double dt, const Bed& bed, std::optional<double> top) {
  if (!(dt > 0.0)) throw ValueError(fmt::format("a time step of {} s is not above 0", dt));
  Step s;
  s.dt = dt;
  begin(s, bed, top);
  auto force_now = force_;
  for (int k = 0; k < options_.correctors; ++k) {
    if (k > 0) force_now = forces(domain_, border_, options_, flow(), face_eps_);
    correct(s, force_now);
  }
  finish(s);
  return s.report;
}

void Fluid::begin(Step& s, const Bed& bed, std::optional<double> top) {
  s.bed = filled(bed, domain_.own());
  check(s.bed, domain_, time_ + s.dt);
  s.end = end_weight(options_.crank_nicolson);
  s.eps_old = eps_;
  s.volume_old = domain_.part.volume;
  s.u_old = u_;
  s.q_old = q_;
  s.pattern_old = pattern();
  s.fitted = superficial(eps_, u_);
  s.fitted_q = q_;
  mesh_speed_ = domain_.move_top(top.value_or(domain_.mesh.top()), s.dt);
  update(border_, options_.boundaries, domain_, time_ + s.dt, options_.rho_f * options_.gravity);
  std::copy(s.bed.eps.begin(), s.bed.eps.end(), eps_.begin());
  domain_.halo.refresh(eps_);
  face_eps_ = viscous_eps(domain_, border_, eps_);
  set_flux();
  set_balance(s);
}

void Fluid::set_balance(Step& s) {
  const auto own = domain_.own();
  const double rho = options_.rho_f;
  s.matrix = transport_matrix(domain_, border_, options_, flow(), face_eps_, s.end);
  const auto viscous = viscous_exchange(domain_, options_, face_eps_, s.end);
  s.balance.resize(domain_.cells());
  s.inertia.resize(own);
  s.implicit_drag.resize(own);
  s.fixed_force.resize(own);
  for (std::size_t c = 0; c < own; ++c) {
    const double volume = domain_.part.volume[c];
    const double held = s.end * s.eps_old[c] * s.volume_old[c] / volume + (1.0 - s.end) * eps_[c];
    const double exchange = s.bed.exchange[c];
    const double inflow = rho * std::max(s.bed.source[c], 0.0);
    const double inertia = rho * held / s.dt;
    const double w = drag_weight(exchange / inertia, s.end);
    s.inertia[c] = inertia;
    s.implicit_drag[c] = w * exchange + inflow;
    s.fixed_force[c] = (1.0 - s.end) * force_[c] + (1.0 - w) * drag_[c] +
                       s.implicit_drag[c] * s.bed.u_solid[c] + s.bed.force[c];
    s.matrix.diagonal[c] += volume * (inertia + s.implicit_drag[c]);
    s.balance[c] = {.resistance = (inertia + s.implicit_drag[c]) / (eps_[c] * eps_[c]),
                    .inertia = inertia / (eps_[c] * s.eps_old[c]),
                    .viscous = viscous[c] / (volume * eps_[c] * eps_[c])};
  }
  domain_.halo.refresh(s.balance);
  s.conductance = conductances(domain_, s.balance);
  put_frits_in_series(s.conductance);
  s.damping = damping(domain_, s.balance);
}

/// Outlets: 1/k of the half cell and that of the frit behind it.
void Fluid::put_frits_in_series(std::vector<double>& conductance) const {
  for (std::size_t b = 0; b < border_.size(); ++b) {
    if (border_.kind[b] != BorderKind::outlet) continue;
    const auto f = domain_.inner() + b;
    conductance[f] /= 1.0 + frit_slope(b) * conductance[f] / domain_.geometry.area[f];
  }
}

/// Velocity of own cells that balances momentum with the present pressure, convection and viscous forces
/// linear about the present iterate, where they are `force`.
std::vector<Vec3> Fluid::predicted(Step& s, const std::vector<Vec3>& force) {
  const auto own = domain_.own();
  std::vector<Vec3> rhs(own);
  std::vector<double> momentum(own);
  for (std::size_t c = 0; c < own; ++c) {
    rhs[c] =
        domain_.part.volume[c] * (s.end * force[c] + s.fixed_force[c] - s.implicit_drag[c] * u_[c] -
                                  s.inertia[c] * (u_[c] - s.u_old[c]) - eps_[c] * grad_p_[c]);
    momentum[c] = s.matrix.diagonal[c] * norm(u_[c]);
  }
  auto u = solve_momentum(domain_, momentum_solver_, s.matrix, rhs, options_,
                          norm_of(domain_.ranks, momentum), s.report.momentum);
  for (std::size_t c = 0; c < own; ++c) u[c] += u_[c];
  return u;
}

/// Velocities of faces, relative fluxes and all, as the present pressure has them.
void Fluid::set_face_velocity(const Step& s) {
  const auto inner = domain_.inner();
  for (std::size_t f = 0; f < domain_.faces(); ++f) {
    if (f >= inner && border_.kind[f - inner] != BorderKind::outlet) continue;
    const double other = f < inner ? p_[domain_.neighbor(f)] : border_.pressure[f - inner];
    q_[f] =
        s.conductance[f] / domain_.geometry.area[f] * (p_[domain_.owner(f)] - other + s.push[f]);
  }
  set_flux();
}

/// Changes the pressure by what closes all cells. The change is what is solved for: where the present
/// pressure is right, nothing moves, to the last bit.
void Fluid::solve_pressure(Step& s) {
  set_face_velocity(s);
  auto rhs = continuity_errors(s);
  const auto through = throughflow(domain_, flux_);
  const double size = norm_of(domain_.ranks, through);
  std::vector<double> change(domain_.cells(), 0.0);
  s.report.pressure.push_back(
      pressure_solver_.solve(domain_, border_, s.conductance, rhs, size, options_, change));
  for (std::size_t c = 0; c < domain_.cells(); ++c) p_[c] += change[c];
  set_face_velocity(s);
}

/// Part of the present q that no velocity of a cell shows, one per inner face.
std::vector<double> Fluid::pattern() {
  const auto lean = superficial_gradient();
  auto v = reconstruct(domain_, q_, lean);
  domain_.halo.refresh(v);
  return unseen(domain_, q_, v, lean);
}

/// Takes from the pushes what damps patterns of cells: a viscosity that acts on velocities of cells does not.
void Fluid::damp(Step& s, const std::vector<double>& pattern_now) {
  const auto take = [&](double weight, const std::vector<double>& from) {
    for (std::size_t f = 0; f < domain_.inner(); ++f) {
      s.push[f] -= std::min(1.0, weight * s.damping[f]) * from[f] * domain_.geometry.area[f] /
                   s.conductance[f];
    }
  };
  if (s.end < 1.0) take((1.0 - s.end) / s.end, s.pattern_old);
  take(1.0, pattern_now);
}

/// Predicts velocities, takes the pressure out again, and lets a new one close all cells.
void Fluid::correct(Step& s, const std::vector<Vec3>& force) {
  const auto own = domain_.own();
  auto drive = predicted(s, force);
  for (std::size_t c = 0; c < own; ++c) {
    const auto& m = s.balance[c];
    drive[c] =
        (m.resistance * eps_[c]) * drive[c] - (m.inertia * s.eps_old[c]) * s.u_old[c] + grad_p_[c];
  }
  drive.resize(domain_.cells());
  domain_.halo.refresh(drive);
  s.push = pushes(domain_, s.balance, drive, s.q_old, grad_p_);
  damp(s, s.report.pressure.empty() ? s.pattern_old : pattern());
  solve_pressure(s);
  set_velocity(s);
  for (std::size_t c = 0; c < own; ++c) {
    const auto& m = s.balance[c];
    grad_p_[c] =
        drive[c] + (m.inertia * s.eps_old[c]) * s.u_old[c] - (m.resistance * eps_[c]) * u_[c];
  }
  domain_.halo.refresh(grad_p_);
  s.report.residual.push_back(norm_of(domain_.ranks, continuity_errors(s)));
}

void Fluid::finish(Step& s) {
  const auto& g = domain_.geometry;
  time_ += s.dt;
  force_ = forces(domain_, border_, options_, flow(), face_eps_);
  for (std::size_t c = 0; c < domain_.own(); ++c) {
    drag_[c] = s.bed.exchange[c] * (s.bed.u_solid[c] - u_[c]);
  }
  for (std::size_t b = 0; b < border_.size(); ++b) {
    const auto f = domain_.inner() + b;
    border_p_[b] = border_.kind[b] == BorderKind::outlet
                       ? border_.pressure[b] + frit_slope(b) * q_[f]
                       : p_[domain_.owner(f)] + s.push[f] - q_[f] * g.area[f] / s.conductance[f];
  }
  report(s);
}

}  // namespace packbed::fluid
