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

}  // namespace packbed::fluid
