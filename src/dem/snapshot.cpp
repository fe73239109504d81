// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "core/exact_sum.hpp"
#include "dem/dem.hpp"

namespace packbed::dem {

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

/// What a bead tells of itself.
struct BeadLook {
  BeadProperties bead;
  Vec3 x, v, w, force, torque, drag;
};

namespace {

void add(const BeadLook& row, Snapshot& s) {
  s.beads.push_back(row.bead);
  s.x.push_back(row.x);
  s.v.push_back(row.v);
  s.w.push_back(row.w);
  s.force.push_back(row.force);
  s.torque.push_back(row.torque);
  s.drag.push_back(row.drag);
}

void reserve(std::size_t beads, Snapshot& s) {
  s.beads.reserve(beads);
  for (auto* a : {&s.x, &s.v, &s.w, &s.force, &s.torque, &s.drag}) a->reserve(beads);
}

/// Places of the own beads, in the order of ids if that is asked for.
std::vector<std::int32_t> own_beads(const Particles& particles, bool by_id) {
  std::vector<std::int32_t> own;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.is_own(i)) own.push_back(static_cast<std::int32_t>(i));
  }
  if (!by_id) return own;
  std::ranges::sort(own, {}, [&](std::int32_t i) {
    return particles.properties[static_cast<std::size_t>(i)].id;
  });
  return own;
}

double mean(std::span<const double> terms, const Ranks& ranks) {
  std::array<std::int64_t, 1> count = {static_cast<std::int64_t>(terms.size())};
  ranks.sum(count);
  const double sum = order_independent_sum(terms, ranks);
  return count[0] > 0 ? sum / static_cast<double>(count[0]) : 0.0;
}

}  // namespace

// Forces of the walls on the beads of a copy, in the order of a step; the sums on each wall are those of
// all ranks.
void Dem::add_wall_forces_here(Particles& p,
                               std::vector<WallContacts>& near,
                               std::vector<Vec3>& wall_force) const {
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    std::vector<Load> so_far;
    for (const auto& c : near[w]) {
      so_far.push_back(std::exchange(p.load[static_cast<std::size_t>(c.bead)], Load{}));
    }
    add_wall_forces(options_.model, walls_[w], near[w], p, spring_step());
    std::array<std::vector<double>, 3> terms;
    for (std::size_t k = 0; k < near[w].size(); ++k) {
      Load& load = p.load[static_cast<std::size_t>(near[w][k].bead)];
      terms[0].push_back(-load.force.x);
      terms[1].push_back(-load.force.y);
      terms[2].push_back(-load.force.z);
      load.force = so_far[k].force + load.force;
      load.torque = so_far[k].torque + load.torque;
    }
    wall_force.push_back({order_independent_sum(terms[0], ranks_),
                          order_independent_sum(terms[1], ranks_),
                          order_independent_sum(terms[2], ranks_)});
  }
}

// Forces of the pairs on the beads of a copy. Contacts are copied in portions: a look must not take as much
// memory as the run.
ContactTerms Dem::add_pair_forces_here(Particles& p) const {
  constexpr std::size_t portion = 256;
  ContactTerms terms;
  const std::size_t blocks = contacts_.blocks.size();
  for (std::size_t first = 0; first < blocks; first += portion) {
    auto part = contacts_.part(first, std::min(first + portion, blocks));
    add_contact_forces(options_.model, part, p, spring_step());
    for (std::size_t k = 0; k < part.size(); ++k) {
      const auto c = part.pair(k);
      const auto i = static_cast<std::size_t>(c.i);
      const auto j = static_cast<std::size_t>(c.j);
      if (!particles_.is_own(i)) continue;  // it counts on the rank of its first bead
      terms.add(options_.model.contact, overlap(c),
                2.0 * std::min(particles_.radius(i), particles_.radius(j)), c.coefficients,
                c.history);
    }
  }
  return terms;
}

// The springs of a copy are moved on to the present time, as the next step would do, so that
// forces are those at the present positions; velocities are taken half a step further.
Sums Dem::look(const std::function<void(const BeadLook&)>& take) const {
  Sums s{};
  s.time = time();
  Particles p;
  p.motion = particles_.motion;
  p.spin = particles_.spin;
  p.load.resize(p.motion.size());
  auto wall_contacts = wall_contacts_;
  add_wall_forces_here(p, wall_contacts, s.wall_force);
  auto terms = add_pair_forces_here(p);
  sum_contacts(terms, wall_contacts, s);

  std::vector<double> kinetic;
  std::vector<double> unbalanced;
  std::vector<double> weights;
  for (const auto place : own_beads(particles_, static_cast<bool>(take))) {
    const auto i = static_cast<std::size_t>(place);
    const auto& m = p.motion[i];
    const auto& bead = particles_.properties[i];
    const Vec3 weight{0.0, 0.0, -bead.weight};
    const bool free = m.inv_mass > 0.0;
    const double keep = free ? 1.0 - 0.5 * last_step_ * options_.background_damping : 1.0;
    const Vec3 force = p.load[i].force + weight;
    const Drag drag = particles_.in_liquid ? particles_.drag[i] : Drag{};
    const double moved_by = 0.5 * last_step_ * m.inv_mass;  // half a step, drag implicit
    const Vec3 v = (1.0 / (1.0 + moved_by * drag.rate)) *
                   (keep * m.v + moved_by * (force + drag.rate * drag.target));
    const Vec3 pull = drag.rate * (drag.target - v);
    const Vec3 w = keep * p.spin[i].w + (0.5 * last_step_ * m.inv_inertia) * p.load[i].torque;
    weights.push_back(bead.weight);
    if (free) {
      kinetic.push_back(0.5 * dot(v, v) / m.inv_mass + 0.5 * dot(w, w) / m.inv_inertia);
      unbalanced.push_back(norm(force + pull));
    }
    if (take) take({bead, m.x, v, w, p.load[i].force, p.load[i].torque, pull});
  }
  s.weight = order_independent_sum(weights, ranks_);
  s.kinetic_energy = order_independent_sum(kinetic, ranks_);
  s.mean_unbalanced_force = mean(unbalanced, ranks_);
  return s;
}

Sums Dem::sums() const { return look({}); }

// One rank needs no list of rows, which would take as much memory as the snapshot.
Snapshot Dem::snapshot() const {
  Snapshot s{};
  if (ranks_.is_first()) reserve(static_cast<std::size_t>(bead_count_), s);
  if (ranks_.size() == 1) {
    static_cast<Sums&>(s) = look([&](const BeadLook& bead) { add(bead, s); });
    return s;
  }
  std::vector<BeadLook> beads;
  static_cast<Sums&>(s) = look([&](const BeadLook& bead) { beads.push_back(bead); });
  beads = ranks_.gather(std::move(beads));
  std::ranges::sort(beads, {}, [](const BeadLook& look) { return look.bead.id; });
  for (const auto& look : beads) add(look, s);
  return s;
}

std::vector<Vec3> Dem::wall_forces() const {
  Particles p;
  p.motion = particles_.motion;
  p.spin = particles_.spin;
  p.load.resize(p.motion.size());
  auto near = wall_contacts_;
  std::vector<Vec3> forces;
  add_wall_forces_here(p, near, forces);
  return forces;
}

/// Adds the wall contacts to the terms of the pairs, and sums them up.
void Dem::sum_contacts(ContactTerms& terms,
                       const std::vector<WallContacts>& wall_contacts,
                       Sums& s) const {
  std::array<std::int64_t, 1> touching = {static_cast<std::int64_t>(terms.overlap.size())};
  s.mean_overlap = mean(terms.overlap, ranks_);
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    for (const auto& c : wall_contacts[w]) {
      const auto i = static_cast<std::size_t>(c.bead);
      const double radius = particles_.radius(i);
      const double depth = radius - distance_to(walls_[w], particles_.motion[i].x).distance;
      terms.add(options_.model.contact, depth, 2.0 * radius, c.coefficients, c.history);
    }
  }
  ranks_.sum(touching);
  s.elastic_energy = order_independent_sum(terms.energy, ranks_);
  s.mean_contact_force = mean(terms.force, ranks_);
  s.max_overlap_ratio = ranks_.max(terms.max_overlap_ratio);
  s.coordination_number =
      bead_count_ > 0 ? 2.0 * static_cast<double>(touching[0]) / static_cast<double>(bead_count_)
                      : 0.0;
}

}  // namespace packbed::dem
