// SPDX-License-Identifier: BSD-3-Clause
#include "fluid/balance.hpp"

#include <algorithm>

namespace packbed::fluid {

std::vector<double> conductances(const Domain& domain, std::span<const CellBalance> cells) {
  std::vector<double> all(domain.faces());
  const auto& g = domain.geometry;
  for (std::size_t f = 0; f < all.size(); ++f) {
    double resistance = cells[domain.owner(f)].resistance * g.d_owner[f];
    if (f < domain.inner()) resistance += cells[domain.neighbor(f)].resistance * g.d_neighbor[f];
    all[f] = g.area[f] / resistance;
  }
  return all;
}

std::vector<double> pushes(const Domain& domain,
                           std::span<const CellBalance> cells,
                           std::span<const Vec3> drive,
                           std::span<const double> q_old,
                           std::span<const Vec3> grad_p) {
  std::vector<double> all(domain.faces());
  const auto& g = domain.geometry;
  for (std::size_t f = 0; f < all.size(); ++f) {
    const auto half = [&](std::size_t c) {
      return dot(drive[c], g.normal[f]) + cells[c].inertia * q_old[f];
    };
    const auto p = domain.owner(f);
    double push = half(p) * g.d_owner[f];
    if (f < domain.inner()) push += half(domain.neighbor(f)) * g.d_neighbor[f];
    if (!g.orthogonal) {
      Vec3 gradient = grad_p[p];
      if (f < domain.inner()) {
        const double w = g.owner_weight(f);
        gradient = w * gradient + (1.0 - w) * grad_p[domain.neighbor(f)];
      }
      push += dot(gradient, g.along[f]);
    }
    all[f] = push;
  }
  return all;
}

// Up to 1 it is the same force for any step, so that a steady flow does not depend on the step.
std::vector<double> damping(const Domain& domain, std::span<const CellBalance> cells) {
  std::vector<double> all(domain.inner());
  const auto& g = domain.geometry;
  for (std::size_t f = 0; f < all.size(); ++f) {
    const auto& p = cells[domain.owner(f)];
    const auto& q = cells[domain.neighbor(f)];
    const double viscous = p.viscous * g.d_owner[f] + q.viscous * g.d_neighbor[f];
    const double resistance = p.resistance * g.d_owner[f] + q.resistance * g.d_neighbor[f];
    all[f] = std::min(1.0, viscous / resistance);
  }
  return all;
}

}  // namespace packbed::fluid
