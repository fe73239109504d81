// SPDX-License-Identifier: BSD-3-Clause
#include "fluid/forces.hpp"

#include "fluid/gradient.hpp"
#include "fluid/interpolation.hpp"

namespace packbed::fluid {
namespace {

/// u_f of the convective term at an inner face.
Vec3 convected(const Domain& domain,
               Convection scheme,
               const Flow& flow,
               std::span<const Tensor> grad,
               std::size_t f) {
  const auto p = domain.owner(f);
  const auto q = domain.neighbor(f);
  const double owner_weight = domain.geometry.owner_weight(f);
  const bool forward = flow.flux[f] >= 0.0;
  const auto& c = flow.u[forward ? p : q];
  if (scheme == Convection::upwind) return c;
  Vec3 shift{};
  if (!domain.geometry.orthogonal) {
    shift = (owner_weight * grad[p] + (1.0 - owner_weight) * grad[q]) * domain.geometry.skew[f];
  }
  if (scheme == Convection::central) {
    return owner_weight * flow.u[p] + (1.0 - owner_weight) * flow.u[q] + shift;
  }
  const auto& d = flow.u[forward ? q : p];
  const double weight = forward ? 1.0 - owner_weight : owner_weight;
  const Vec3 rise = (forward ? 1.0 : -1.0) * (grad[forward ? p : q] * domain.part.delta[f]);
  return shift + Vec3{limited_value(c.x, d.x, rise.x, weight),
                      limited_value(c.y, d.y, rise.y, weight),
                      limited_value(c.z, d.z, rise.z, weight)};
}

/// Viscous stress times area, over eps mu, at an inner face, along its normal: on the owner.
Vec3 stress(const Domain& domain, const Flow& flow, std::span<const Tensor> grad, std::size_t f) {
  const auto p = domain.owner(f);
  const auto q = domain.neighbor(f);
  const auto& g = domain.geometry;
  const double weight = g.owner_weight(f);
  const Tensor at_face = weight * grad[p] + (1.0 - weight) * grad[q];
  const double across = g.d_owner[f] + g.d_neighbor[f];
  const Vec3 compact = (1.0 / across) * (flow.u[q] - flow.u[p] - at_face * g.along[f]);
  const auto& n = g.normal[f];
  return g.area[f] * (compact + transposed_times(at_face, n) - (2.0 / 3.0 * trace(at_face)) * n);
}

/// The same at a border face. At a wall the normal velocity does not change across it where it is
/// impermeable (continuity), so the shear is all.
Vec3 border_stress(const Domain& domain,
                   const Border& border,
                   const Flow& flow,
                   std::span<const Vec3> at_border,
                   std::span<const Tensor> grad,
                   std::size_t b) {
  const auto f = domain.inner() + b;
  const auto& g = domain.geometry;
  const auto& n = g.normal[f];
  const auto bulk = [&] { return (-2.0 / 3.0 * g.area[f] * trace(grad[domain.owner(f)])) * n; };
  const Vec3 difference = at_border[b] - flow.u[domain.owner(f)];
  const double scale = g.area[f] / g.d_owner[f];
  const Vec3 across = dot(difference, n) * n;
  switch (border.kind[b]) {
    case BorderKind::wall:
      return scale * (difference - across);
    case BorderKind::slip:
      return (2.0 * scale) * across + bulk();
    case BorderKind::inlet:
      if (border.inward[b] > 0.0) return scale * (difference + across) + bulk();
      break;
    case BorderKind::outlet:
      break;
  }
  // Nothing changes across an open face; along it (grad u)^T n goes on as between cells.
  const Vec3 along = transposed_times(grad[domain.owner(f)], n);
  return g.area[f] * (along - dot(along, n) * n);
}

}  // namespace

std::vector<double> viscous_eps(const Domain& domain,
                                const Border& border,
                                std::span<const double> eps) {
  std::vector<double> all(domain.faces());
  const auto& g = domain.geometry;
  for (std::size_t f = 0; f < domain.inner(); ++f) {
    all[f] = (g.d_owner[f] + g.d_neighbor[f]) /
             (g.d_owner[f] / eps[domain.owner(f)] + g.d_neighbor[f] / eps[domain.neighbor(f)]);
  }
  for (std::size_t b = 0; b < border.size(); ++b) {
    const auto f = domain.inner() + b;
    all[f] = border.wall_eps[b] > 0.0 ? border.wall_eps[b] : eps[domain.owner(f)];
  }
  return all;
}

std::vector<Vec3> border_velocities(const Domain& domain, const Border& border, const Flow& flow) {
  std::vector<Vec3> all(border.size());
  for (std::size_t b = 0; b < all.size(); ++b) {
    const auto f = domain.inner() + b;
    const auto p = domain.owner(f);
    all[b] =
        border_velocity(border, b, domain.geometry.normal[f], flow.u[p], flow.q[f] / flow.eps[p]);
  }
  return all;
}

std::vector<Vec3> forces(Domain& domain,
                         const Border& border,
                         const FluidOptions& options,
                         const Flow& flow,
                         std::span<const double> face_eps) {
  const auto at_border = border_velocities(domain, border, flow);
  const auto grad = gradient(domain, flow.u, at_border);
  std::vector<Vec3> force(domain.cells());
  const bool convects = options.convection != Convection::none;
  for (std::size_t f = 0; f < domain.inner(); ++f) {
    const auto p = domain.owner(f);
    const auto q = domain.neighbor(f);
    const Vec3 pull = (options.mu_f * face_eps[f]) * stress(domain, flow, grad, f);
    force[p] += pull;
    force[q] -= pull;
    if (!convects) continue;
    const Vec3 carried = convected(domain, options.convection, flow, grad, f);
    const double mass_flux = options.rho_f * flow.flux[f];
    force[p] -= mass_flux * (carried - flow.u[p]);
    force[q] += mass_flux * (carried - flow.u[q]);
  }
  for (std::size_t b = 0; b < border.size(); ++b) {
    const auto f = domain.inner() + b;
    const auto p = domain.owner(f);
    force[p] +=
        (options.mu_f * face_eps[f]) * border_stress(domain, border, flow, at_border, grad, b);
    if (convects && flow.flux[f] < 0.0) {
      force[p] -= (options.rho_f * flow.flux[f]) * (at_border[b] - flow.u[p]);
    }
  }
  force.resize(domain.own());
  for (std::size_t c = 0; c < force.size(); ++c) force[c] *= 1.0 / domain.part.volume[c];
  return force;
}

Vec3 wall_shear(const Domain& domain,
                const Border& border,
                const FluidOptions& options,
                const Flow& flow,
                std::span<const double> face_eps,
                std::size_t b) {
  const auto f = domain.inner() + b;
  if (border.kind[b] != BorderKind::wall) return {};
  const auto& n = domain.geometry.normal[f];
  Vec3 slip = flow.u[domain.owner(f)] - border.wall_velocity[b];
  slip -= dot(slip, n) * n;
  return (options.mu_f * face_eps[f] * domain.geometry.area[f] / domain.geometry.d_owner[f]) * slip;
}

}  // namespace packbed::fluid
