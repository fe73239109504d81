// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/exact_sum.hpp"
#include "dem/dem.hpp"

namespace packbed::dem {
namespace {

/// What a bead tells of itself.
struct Row {
  BeadProperties bead;
  Vec3 x, v, w, force, torque;
};

/// One term per touching contact, for sums that must not depend on the order.
struct ContactTerms {
  std::vector<double> energy, force, overlap;
  double max_overlap_ratio = 0.0;

  void add(const ContactLaw& law,
           double depth,
           double diameter,
           const Coefficients& k,
           const History& history) {
    if (depth <= 0.0) return;
    std::visit(
        [&](const auto& l) {
          const Response r = l(depth, 0.0, k);
          const double spring = norm(history.spring);
          energy.push_back(l.energy(depth, k) + 0.5 * r.k_t * spring * spring);
          force.push_back(std::hypot(r.f_n, r.k_t * spring));
        },
        law);
    overlap.push_back(depth);
    max_overlap_ratio = std::max(max_overlap_ratio, depth / diameter);
  }
};

double mean(const std::vector<double>& terms, const Ranks& ranks) {
  std::array<std::int64_t, 1> count = {static_cast<std::int64_t>(terms.size())};
  ranks.sum(count);
  const double sum = order_independent_sum(terms, ranks);
  return count[0] > 0 ? sum / static_cast<double>(count[0]) : 0.0;
}

}  // namespace

// Forces of walls and pairs on the beads of a copy, in the order of a step; the sums on each wall are
// those of all ranks.
void Dem::add_forces_here(Particles& p,
                          ContactList& contacts,
                          std::vector<WallContacts>& near,
                          std::vector<Vec3>& wall_force) const {
  std::vector<Load> so_far(p.size());
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    for (std::size_t i = 0; i < p.size(); ++i) p.load[i] = {};
    add_wall_forces(options_.model, walls_[w], near[w], p, spring_step());
    std::array<std::vector<double>, 3> terms;
    for (const auto& c : near[w]) {
      const auto i = static_cast<std::size_t>(c.bead);
      const Vec3 force = -p.load[i].force;
      terms[0].push_back(force.x);
      terms[1].push_back(force.y);
      terms[2].push_back(force.z);
      so_far[i].force += p.load[i].force;
      so_far[i].torque += p.load[i].torque;
    }
    wall_force.push_back({order_independent_sum(terms[0], ranks_),
                          order_independent_sum(terms[1], ranks_),
                          order_independent_sum(terms[2], ranks_)});
  }
  std::ranges::copy(so_far, p.load.begin());
  add_contact_forces(options_.model, contacts, p, spring_step());
}

// The springs of a copy are moved on to the present time, as the next step would do, so that
// forces are those at the present positions; velocities are taken half a step further.
Snapshot Dem::snapshot() const {
  Particles p = particles_;
  ContactList contacts = contacts_;
  auto wall_contacts = wall_contacts_;
  Snapshot s{};
  s.time = time();
  add_forces_here(p, contacts, wall_contacts, s.wall_force);

  std::vector<Row> rows;
  std::vector<double> kinetic;
  std::vector<double> unbalanced;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!p.is_own(i)) continue;
    const auto& m = p.motion[i];
    const Vec3 weight{0.0, 0.0, -p.properties[i].weight};
    const bool free = m.inv_mass > 0.0;
    const double keep = free ? 1.0 - 0.5 * last_step_ * options_.background_damping : 1.0;
    const Vec3 v = keep * m.v + (0.5 * last_step_ * m.inv_mass) * (p.load[i].force + weight);
    const Vec3 w = keep * p.spin[i].w + (0.5 * last_step_ * m.inv_inertia) * p.load[i].torque;
    rows.push_back({p.properties[i], m.x, v, w, p.load[i].force, p.load[i].torque});
    if (!free) continue;
    kinetic.push_back(0.5 * dot(v, v) / m.inv_mass + 0.5 * dot(w, w) / m.inv_inertia);
    unbalanced.push_back(norm(p.load[i].force + weight));
  }
  rows = ranks_.gather(std::move(rows));
  std::ranges::sort(rows, {}, [](const Row& row) { return row.bead.id; });
  for (const auto& row : rows) {
    s.beads.push_back(row.bead);
    s.x.push_back(row.x);
    s.v.push_back(row.v);
    s.w.push_back(row.w);
    s.force.push_back(row.force);
    s.torque.push_back(row.torque);
  }

  // A contact between two ranks counts on the rank of its first bead.
  ContactTerms pairs;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto c = contacts.pair(k);
    const auto i = static_cast<std::size_t>(c.i);
    const auto j = static_cast<std::size_t>(c.j);
    if (!p.is_own(i)) continue;
    pairs.add(options_.model.contact, overlap(c), 2.0 * std::min(p.radius(i), p.radius(j)),
              c.coefficients, c.history);
  }
  ContactTerms all = pairs;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    for (const auto& c : wall_contacts[w]) {
      const auto i = static_cast<std::size_t>(c.bead);
      const double depth = p.radius(i) - distance_to(walls_[w], p.motion[i].x).distance;
      all.add(options_.model.contact, depth, 2.0 * p.radius(i), c.coefficients, c.history);
    }
  }
  std::array<std::int64_t, 1> touching = {static_cast<std::int64_t>(pairs.overlap.size())};
  ranks_.sum(touching);
  s.kinetic_energy = order_independent_sum(kinetic, ranks_);
  s.elastic_energy = order_independent_sum(all.energy, ranks_);
  s.mean_contact_force = mean(all.force, ranks_);
  s.mean_unbalanced_force = mean(unbalanced, ranks_);
  s.mean_overlap = mean(pairs.overlap, ranks_);
  s.max_overlap_ratio = ranks_.max(all.max_overlap_ratio);
  s.coordination_number =
      bead_count_ > 0 ? 2.0 * static_cast<double>(touching[0]) / static_cast<double>(bead_count_)
                      : 0.0;
  return s;
}

}  // namespace packbed::dem
