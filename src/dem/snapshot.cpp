// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "dem/dem.hpp"

namespace packbed::dem {
namespace {

/// Sums over touching contacts.
struct ContactSums {
  double elastic_energy = 0.0;
  double force = 0.0;
  double overlap = 0.0;
  double max_overlap_ratio = 0.0;
  std::size_t touching = 0;
};

// `spring_energy` is that of the tangential spring, which the law's stiffness gives.
void add(const ContactLaw& law,
         double overlap,
         double diameter,
         const Coefficients& k,
         const History& history,
         ContactSums& sums) {
  if (overlap <= 0.0) return;
  std::visit(
      [&](const auto& l) {
        const Response r = l(overlap, 0.0, k);
        const double spring = norm(history.spring);
        sums.elastic_energy += l.energy(overlap, k) + 0.5 * r.k_t * spring * spring;
        sums.force += std::hypot(r.f_n, r.k_t * spring);
      },
      law);
  sums.overlap += overlap;
  sums.max_overlap_ratio = std::max(sums.max_overlap_ratio, overlap / diameter);
  ++sums.touching;
}

}  // namespace

// The springs of a copy are moved on to the present time, as the next step would do, so that
// forces are those at the present positions; velocities are taken half a step further.
Snapshot Dem::snapshot() const {
  Particles p = particles_;
  ContactList contacts = contacts_;
  auto wall_contacts = wall_contacts_;
  Snapshot s{};
  s.time = time();
  for (std::size_t i = 0; i < p.size(); ++i) p.load[i] = {};
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    s.wall_force.push_back(
        add_wall_forces(options_.model, walls_[w], wall_contacts[w], p, last_step_));
  }
  add_contact_forces(options_.model, contacts, p, last_step_);

  const std::size_t n = p.size();
  std::vector<std::size_t> by_id(n);
  for (std::size_t i = 0; i < n; ++i) by_id[i] = i;
  std::ranges::sort(by_id, {}, [&](std::size_t i) { return p.properties[i].id; });
  double unbalanced = 0.0;
  std::size_t free_beads = 0;
  for (const std::size_t i : by_id) {
    const auto& m = p.motion[i];
    const Vec3 weight{0.0, 0.0, -p.properties[i].weight};
    const bool free = m.inv_mass > 0.0;
    const double keep = free ? 1.0 - 0.5 * last_step_ * options_.background_damping : 1.0;
    const Vec3 v = keep * m.v + (0.5 * last_step_ * m.inv_mass) * (p.load[i].force + weight);
    const Vec3 w = keep * p.spin[i].w + (0.5 * last_step_ * m.inv_inertia) * p.load[i].torque;
    s.x.push_back(m.x);
    s.v.push_back(v);
    s.w.push_back(w);
    s.force.push_back(p.load[i].force);
    s.torque.push_back(p.load[i].torque);
    if (!free) continue;
    s.kinetic_energy += 0.5 * dot(v, v) / m.inv_mass + 0.5 * dot(w, w) / m.inv_inertia;
    unbalanced += norm(p.load[i].force + weight);
    ++free_beads;
  }
  ContactSums sums;
  for (const auto& c : contacts.pairs()) {
    const auto i = static_cast<std::size_t>(c.i);
    const auto j = static_cast<std::size_t>(c.j);
    add(options_.model.contact, overlap(c), 2.0 * std::min(p.radius(i), p.radius(j)),
        c.coefficients, c.history, sums);
  }
  s.mean_overlap = sums.touching > 0 ? sums.overlap / static_cast<double>(sums.touching) : 0.0;
  s.coordination_number =
      n > 0 ? 2.0 * static_cast<double>(sums.touching) / static_cast<double>(n) : 0.0;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    for (const auto& c : wall_contacts[w]) {
      const auto i = static_cast<std::size_t>(c.bead);
      const double depth = p.radius(i) - distance_to(walls_[w], p.motion[i].x).distance;
      add(options_.model.contact, depth, 2.0 * p.radius(i), c.coefficients, c.history, sums);
    }
  }
  s.elastic_energy = sums.elastic_energy;
  s.max_overlap_ratio = sums.max_overlap_ratio;
  s.mean_contact_force = sums.touching > 0 ? sums.force / static_cast<double>(sums.touching) : 0.0;
  s.mean_unbalanced_force = free_beads > 0 ? unbalanced / static_cast<double>(free_beads) : 0.0;
  return s;
}

}  // namespace packbed::dem
