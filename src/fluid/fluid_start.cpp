// SPDX-License-Identifier: BSD-3-Clause
// How the liquid begins.
#include <algorithm>
#include <limits>

#include "fluid/fluid.hpp"
#include "fluid/gradient.hpp"

namespace packbed::fluid {
namespace {

const FluidOptions& checked(const FluidOptions& options) {
  options.check();
  return options;
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
  check(all, domain_, time);
  time_ = time;
  std::copy(all.eps.begin(), all.eps.end(), eps_.begin());
  domain_.halo.refresh(eps_);
  face_eps_ = viscous_eps(domain_, border_, eps_);
  std::copy(u.begin(), u.end(), u_.begin());
  domain_.halo.refresh(u_);
  std::ranges::fill(mesh_speed_, 0.0);
  update(border_, options_.boundaries, domain_, time, options_.rho_f * options_.gravity);
  const auto passing = superficial(eps_, u_);
  for (std::size_t f = 0; f < domain_.faces(); ++f) {
    Vec3 at_face = passing[domain_.owner(f)];
    if (f < domain_.inner()) {
      const double w = domain_.geometry.owner_weight(f);
      at_face = w * at_face + (1.0 - w) * passing[domain_.neighbor(f)];
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

}  // namespace packbed::fluid
