// SPDX-License-Identifier: BSD-3-Clause
#include "fluid/fluid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"
#include "fluid/fluid_step.hpp"
#include "fluid/gradient.hpp"
#include "fluid/momentum.hpp"
#include "fluid/time_scheme.hpp"

namespace packbed::fluid {
namespace {

const FluidOptions& checked(const FluidOptions& options) {
  options.check();
  return options;
}

template <class T>
void fill(std::vector<T>& field, std::size_t own, const T& value) {
  if (field.empty()) field.assign(own, value);
}

/// `bed` with every field, or a ValueError.
Bed filled(const Bed& bed, std::size_t own) {
  Bed all = bed;
  fill(all.eps, own, 1.0);
  fill(all.exchange, own, 0.0);
  fill(all.u_solid, own, Vec3{});
  fill(all.source, own, 0.0);
  fill(all.force, own, Vec3{});
  for (const auto size : {all.eps.size(), all.exchange.size(), all.u_solid.size(),
                          all.source.size(), all.force.size()}) {
    if (size == own) continue;
    throw ValueError(
        fmt::format("a field of the bed has {} values; this rank owns {} cells", size, own));
  }
  return all;
}

void check_bed(const Bed& bed, const Domain& domain, double time) {
  for (std::size_t c = 0; c < domain.own(); ++c) {
    const auto& x = domain.part.center[c];
    const double eps = bed.eps[c];
    if (!(eps > 0.0 && eps <= 1.0)) {
      throw DivergenceError(fmt::format(
          "void fraction {} in cell {} at ({:.6g}, {:.6g}, {:.6g}) m, {:.6g} s; it must be above 0 "
          "and at most 1",
          eps, domain.part.cell[c], x.x, x.y, x.z, time));
    }
    if (!(bed.exchange[c] >= 0.0 && std::isfinite(bed.exchange[c]))) {
      throw DivergenceError(fmt::format(
          "exchange coefficient {} kg/(m3 s) in cell {} at ({:.6g}, {:.6g}, {:.6g}) m, {:.6g} s; "
          "drag cannot drive",
          bed.exchange[c], domain.part.cell[c], x.x, x.y, x.z, time));
    }
  }
}

std::vector<Vec3> times(const std::vector<double>& eps, const std::vector<Vec3>& u) {
  std::vector<Vec3> all(u.size());
  for (std::size_t c = 0; c < all.size(); ++c) all[c] = eps[c] * u[c];
  return all;
}

}  // namespace

Fluid::Fluid(const FluidOptions& options,
             const mesh::ColumnMesh& mesh,
             const mesh::CellPartition& partition,
             const Ranks& ranks)
    : options_(checked(options)),
      domain_(mesh, partition, ranks),
      border_(fluid::border(options.boundaries, domain_)),
      pressure_solver_(domain_, border_),
      momentum_solver_(domain_, Method::diagonal, false),
      eps_(domain_.cells(), 1.0),
      p_(domain_.cells(), 0.0),
      q_(domain_.faces(), 0.0),
      flux_(domain_.faces(), 0.0),
      mesh_speed_(domain_.faces(), 0.0),
      border_p_(border_.size(), 0.0),
      u_(domain_.cells()),
      grad_p_(domain_.cells()),
      force_(domain_.own()),
      drag_(domain_.own()) {
  start({}, std::vector<Vec3>(domain_.own()), 0.0);
}

double Fluid::pressure(std::size_t cell) const {
  return p_[cell] + options_.rho_f * dot(options_.gravity, domain_.part.center[cell]);
}

void Fluid::start(const Bed& bed, std::span<const Vec3> u, double time) {
  const auto all = filled(bed, domain_.own());
  check_bed(all, domain_, time);
  time_ = time;
  std::copy(all.eps.begin(), all.eps.end(), eps_.begin());
  domain_.halo.refresh(eps_);
  face_eps_ = viscous_eps(domain_, border_, eps_);
  std::copy(u.begin(), u.end(), u_.begin());
  domain_.halo.refresh(u_);
  std::ranges::fill(mesh_speed_, 0.0);
  update(border_, options_.boundaries, domain_, time, options_.rho_f * options_.gravity);
  const auto superficial = times(eps_, u_);
  for (std::size_t f = 0; f < domain_.faces(); ++f) {
    Vec3 at_face = superficial[domain_.owner(f)];
    if (f < domain_.inner()) {
      const double w = domain_.geometry.owner_weight(f);
      at_face = w * at_face + (1.0 - w) * superficial[domain_.neighbor(f)];
    }
    q_[f] = dot(at_face, domain_.geometry.normal[f]);
  }
  set_flux();
  double level = -std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < border_.size(); ++b) {
    if (border_.kind[b] == BorderKind::outlet) level = std::max(level, border_.pressure[b]);
  }
  level = domain_.ranks.max(level);
  std::ranges::fill(p_, border_.has_outlet ? level : 0.0);
  for (std::size_t b = 0; b < border_.size(); ++b) border_p_[b] = p_[0];
  std::ranges::fill(grad_p_, Vec3{});
  force_ = forces(domain_, border_, options_, flow(), face_eps_);
  for (std::size_t c = 0; c < domain_.own(); ++c) {
    drag_[c] = all.exchange[c] * (all.u_solid[c] - u_[c]);
  }
}

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
  return gradient(domain_, times(eps_, u_), at_border);
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
  check_bed(s.bed, domain_, time_ + s.dt);
  s.end = end_weight(options_.crank_nicolson);
  s.eps_old = eps_;
  s.volume_old = domain_.part.volume;
  s.u_old = u_;
  s.q_old = q_;
  s.pattern_old = pattern();
  s.fitted = times(eps_, u_);
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
  for (std::size_t b = 0; b < border_.size(); ++b) {
    if (border_.kind[b] != BorderKind::outlet) continue;
    const auto f = domain_.inner() + b;
    s.conductance[f] /= 1.0 + frit_slope(b) * s.conductance[f] / domain_.geometry.area[f];
  }
  s.damping = damping(domain_, s.balance);
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

/// Volume per time that must leave each own cell through its faces [m3/s].
std::vector<double> Fluid::displaced(const Step& s) const {
  std::vector<double> all(domain_.own());
  for (std::size_t c = 0; c < all.size(); ++c) {
    const double volume = domain_.part.volume[c];
    // eps V less its old value, in a form that is 0 to the last bit where nothing has changed.
    const double gained =
        (eps_[c] - s.eps_old[c]) * volume + s.eps_old[c] * (volume - s.volume_old[c]);
    all[c] = s.bed.source[c] * volume - gained / s.dt;
  }
  return all;
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

/// What passes each own cell: half the sum of the sizes of its fluxes [m3/s].
std::vector<double> Fluid::throughflow() const {
  std::vector<double> all(domain_.cells(), 0.0);
  for (std::size_t f = 0; f < domain_.faces(); ++f) {
    const double half = 0.5 * std::abs(flux_[f]);
    all[domain_.owner(f)] += half;
    if (f < domain_.inner()) all[domain_.neighbor(f)] += half;
  }
  all.resize(domain_.own());
  return all;
}

/// Changes the pressure by what closes all cells. The change is what is solved for: where the present
/// pressure is right, nothing moves, to the last bit.
void Fluid::solve_pressure(Step& s) {
  set_face_velocity(s);
  auto rhs = continuity_errors(s);
  const auto through = throughflow();
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

/// What each own cell lacks to be closed, from the fluxes alone [m3/s].
std::vector<double> Fluid::continuity_errors(const Step& s) const {
  auto all = displaced(s);
  all.resize(domain_.cells(), 0.0);
  for (std::size_t f = 0; f < domain_.faces(); ++f) {
    all[domain_.owner(f)] -= flux_[f];
    if (f < domain_.inner()) all[domain_.neighbor(f)] += flux_[f];
  }
  all.resize(domain_.own());
  return all;
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

void Fluid::report(Step& s) const {
  const auto errors = continuity_errors(s);
  const auto through = throughflow();
  std::array<double, 3> largest{};
  for (std::size_t c = 0; c < domain_.own(); ++c) {
    largest[0] = std::max(largest[0], std::abs(errors[c]));
    largest[1] = std::max(largest[1], through[c]);
    largest[2] = std::max(largest[2], s.dt * through[c] / (eps_[c] * domain_.part.volume[c]));
    if (!std::isfinite(errors[c])) largest[0] = errors[c];
  }
  domain_.ranks.max(largest);
  const double size = norm_of(domain_.ranks, through);
  const auto over = [](double a, double b) { return b > 0.0 ? a / b : a; };
  s.report.continuity_error = over(norm_of(domain_.ranks, errors), size);
  s.report.largest_error = over(largest[0], largest[1]);
  s.report.courant = largest[2];
  if (!std::isfinite(largest[0]) || !std::isfinite(largest[2])) {
    throw DivergenceError(
        fmt::format("the liquid has velocities that are not finite after the step of {} s to {} s",
                    s.dt, time_));
  }
}

}  // namespace packbed::fluid
