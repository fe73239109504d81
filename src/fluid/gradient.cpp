// SPDX-License-Identifier: BSD-3-Clause
#include "fluid/gradient.hpp"

namespace packbed::fluid {
namespace {

void add_outer(Tensor& t, const Vec3& difference, const Vec3& d) {
  t.x += difference.x * d;
  t.y += difference.y * d;
  t.z += difference.z * d;
}

}  // namespace

std::vector<Tensor> gradient(Domain& domain,
                             std::span<const Vec3> u,
                             std::span<const Vec3> at_border) {
  std::vector<Tensor> all(domain.cells());
  const auto& delta = domain.part.delta;
  const auto inner = domain.inner();
  for (std::size_t f = 0; f < domain.faces(); ++f) {
    const auto p = domain.owner(f);
    const Vec3 d = (1.0 / dot(delta[f], delta[f])) * delta[f];
    if (f < inner) {
      // The same term for both cells: the difference and d change sign together.
      const auto q = domain.neighbor(f);
      const Vec3 difference = u[q] - u[p];
      add_outer(all[p], difference, d);
      add_outer(all[q], difference, d);
    } else {
      add_outer(all[p], at_border[f - inner] - u[p], d);
    }
  }
  for (std::size_t c = 0; c < domain.own(); ++c) {
    const auto& m = domain.geometry.least_squares[c];
    all[c] = {m * all[c].x, m * all[c].y, m * all[c].z};
  }
  domain.halo.refresh(all);
  return all;
}

std::vector<Vec3> reconstruct(const Domain& domain,
                              std::span<const double> q,
                              std::span<const Tensor> lean) {
  std::vector<Vec3> v(domain.cells());
  const auto& g = domain.geometry;
  for (std::size_t f = 0; f < domain.faces(); ++f) {
    const Vec3 part = g.area[f] * g.normal[f];
    const auto add = [&](std::size_t c, const Vec3& arm) {
      const double shift = lean.empty() ? 0.0 : dot(g.normal[f], lean[c] * arm);
      v[c] += (q[f] - shift) * part;
    };
    const auto p = domain.owner(f);
    add(p, g.from_owner[f]);
    if (f < domain.inner()) add(domain.neighbor(f), g.from_owner[f] - domain.part.delta[f]);
  }
  for (std::size_t c = 0; c < domain.own(); ++c) v[c] = g.reconstruct[c] * v[c];
  return v;
}

std::vector<double> unseen(Domain& domain,
                           std::span<const double> q,
                           std::span<const Vec3> v,
                           std::span<const Tensor> grad_v) {
  const auto& g = domain.geometry;
  const auto lacks = [&](std::size_t f, double value, std::span<const Vec3> cells) {
    const double w = g.owner_weight(f);
    return value -
           dot(g.normal[f], w * cells[domain.owner(f)] + (1.0 - w) * cells[domain.neighbor(f)]);
  };
  std::vector<double> once(domain.inner());
  std::vector<Vec3> fit(domain.cells());
  for (std::size_t f = 0; f < once.size(); ++f) {
    once[f] = lacks(f, q[f], v);
    if (!grad_v.empty()) {
      const double w = g.owner_weight(f);
      const Tensor at_face = w * grad_v[domain.owner(f)] + (1.0 - w) * grad_v[domain.neighbor(f)];
      once[f] -= dot(g.normal[f], at_face * g.skew[f]);
    }
    const Vec3 part = (once[f] * g.area[f]) * g.normal[f];
    fit[domain.owner(f)] += part;
    fit[domain.neighbor(f)] += part;
  }
  for (std::size_t c = 0; c < domain.own(); ++c) fit[c] = g.reconstruct_inner[c] * fit[c];
  domain.halo.refresh(fit);
  std::vector<double> twice(domain.inner());
  for (std::size_t f = 0; f < twice.size(); ++f) twice[f] = lacks(f, once[f], fit);
  return twice;
}

}  // namespace packbed::fluid
