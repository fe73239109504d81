// SPDX-License-Identifier: BSD-3-Clause
#include "dem/dem.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "dem/neighbors.hpp"

namespace packbed::dem {
namespace {

double largest_diameter(const std::vector<BeadStart>& beads) {
  double largest = 0.0;
  for (const auto& bead : beads) largest = std::max(largest, bead.properties.diameter);
  return largest;
}

std::string where(const BeadProperties& bead, const Vec3& x) {
  return fmt::format("bead {} at ({:.6g}, {:.6g}, {:.6g}) mm", bead.id, 1e3 * x.x, 1e3 * x.y,
                     1e3 * x.z);
}

bool finite(const Vec3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}  // namespace

Dem::Dem(const DemOptions& options,
         const std::vector<BeadStart>& beads,
         std::vector<Wall> walls,
         const Ranks& ranks)
    : options_(options),
      particles_(make_particles(beads, options.inertia_scale)),
      walls_(std::move(walls)),
      wall_contacts_(walls_.size()),
      ranks_(ranks),
      bead_count_(static_cast<std::int64_t>(beads.size())),
      cell_(std::max(largest_diameter(beads), 1e-12)),
      partition_(options.domain, cell_, ranks) {
  constexpr double skin_of_diameter = 0.05;
  if (options_.skin <= 0.0) options_.skin = skin_of_diameter * cell_;
  if (ranks_.size() > 1) {  // rank 0 starts with all beads; the first renewal deals them out
    particles_.rank = ranks_.rank();
    if (!ranks_.is_first()) clear(particles_);
  }
  renew();
  check_overlaps();
}

void Dem::run(std::int64_t count) {
  for (std::int64_t n = 0; n < count; ++n) step_once();
}

void Dem::step_once() {
  const double dt = options_.step;
  renew_if_needed();
  add_forces(spring_step());
  integrate(0.5 * (last_step_ + dt), dt);
  if (ranks_.size() > 1) halo_.refresh(particles_, ranks_);
  move_walls(dt);
  last_step_ = dt;
  ++steps_;
}

void Dem::add_forces(double dt) {
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    add_wall_forces(options_.model, walls_[w], wall_contacts_[w], particles_, dt);
  }
  add_contact_forces(options_.model, contacts_, particles_, dt);
}

// kick: time over which the force acts on the velocity (half a step at the start); drift: the step.
// Halo beads are moved along and then overwritten by their owners.
void Dem::integrate(double kick, double drift) {
  const double damp = 0.5 * kick * options_.background_damping;
  const double keep = (1.0 - damp) / (1.0 + damp);
  const double push = kick / (1.0 + damp);
  double largest = 0.0;     // displacement, squared
  double not_finite = 0.0;  // becomes NaN with any bead: a maximum would lose it
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    Motion& m = particles_.motion[i];
    Spin& s = particles_.spin[i];
    Load& load = particles_.load[i];
    const bool free = m.inv_mass > 0.0;
    m.v = (free ? keep : 1.0) * m.v + (push * m.inv_mass) * load.force;
    s.w = (free ? keep : 1.0) * s.w + (push * m.inv_inertia) * load.torque;
    m.x += drift * m.v;
    load = {.force = {0.0, 0.0, -particles_.properties[i].weight},
            .zero_1 = 0,
            .torque = {},
            .zero_2 = 0};
    if (!particles_.is_own(i)) continue;
    const Vec3 d = m.x - particles_.reference[i];
    largest = std::max(largest, dot(d, d));
    not_finite += 0.0 * (d.x + d.y + d.z + s.w.x + s.w.y + s.w.z);
  }
  moved_ = ranks_.max(std::sqrt(largest) + not_finite);
}

void Dem::move_walls(double drift) {
  double fastest = 0.0;
  for (auto& wall : walls_) {
    if (auto* plane = std::get_if<Plane>(&wall.surface)) plane->point += drift * wall.velocity;
    if (auto* disc = std::get_if<Disc>(&wall.surface)) disc->center += drift * wall.velocity;
    fastest = std::max(fastest, norm(wall.velocity));
  }
  walls_moved_ += drift * fastest;
}

// Two beads may each have moved by moved_, a bead and a wall by moved_ and walls_moved_. A NaN fails
// both comparisons, so it renews, and is found there.
void Dem::renew_if_needed() {
  const bool lists_hold = 2.0 * moved_ < options_.skin && moved_ + walls_moved_ < options_.skin;
  if (!lists_hold) renew();
}

void Dem::check_finite() const {
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const auto& m = particles_.motion[i];
    if (finite(m.x) && finite(m.v) && finite(particles_.spin[i].w)) continue;
    throw DivergenceError(fmt::format(
        "step {}, time {:.6g} s: {} has a position, velocity or spin that is not a number; "
        "take a smaller step",
        steps_, time(), where(particles_.properties[i], m.x)));
  }
}

// All ranks renew at the same step, since moved_ is the largest of all.
void Dem::renew() {
  check_finite();
  if (ranks_.size() > 1) {
    trade_beads_and_pairs();
  } else {
    sort_beads_and_pairs();
  }
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    particles_.reference[i] = particles_.motion[i].x;
  }
  moved_ = 0.0;
  walls_moved_ = 0.0;
  ++renewals_;
}

void Dem::sort_beads_and_pairs() {
  const auto wraps = wrap(particles_, options_.domain);
  const auto order = key_order(particles_, options_.domain, cell_);
  std::vector<std::int32_t> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    place[static_cast<std::size_t>(order[k])] = static_cast<std::int32_t>(k);
  }
  reorder(particles_, order);
  auto pairs = find_pairs(particles_, options_.domain, options_.skin);
  carry_over(pairs, contacts_.pairs(), place, wraps);
  fill_coefficients(pairs);
  contacts_ = ContactList(pairs, options_.domain, static_cast<std::int32_t>(particles_.size()));
  list_wall_contacts(place);
}

// The same on several ranks: beads and contacts travel by name, and get their places anew.
void Dem::trade_beads_and_pairs() {
  const auto wraps = wrap(particles_, options_.domain);
  auto luggage = pack(particles_, contacts_.pairs(), wall_contacts_, wraps);
  std::vector<Vec3> own;
  for (const auto& bead : luggage.beads) own.push_back(bead.motion.x);
  if (partition_.balance(own, options_.load_tolerance, renewals_ == 0) > options_.load_tolerance) {
    ++repartitions_;
  }
  luggage = migrate(luggage, partition_, ranks_);
  const auto foreign = halo(luggage.beads, partition_, cell_ + options_.skin, ranks_);
  place_beads(luggage.beads, foreign, particles_);
  reorder(particles_, key_order(particles_, options_.domain, cell_));

  const auto named = place_contacts(luggage, particles_, walls_.size());
  std::vector<std::int32_t> same(particles_.size());
  std::iota(same.begin(), same.end(), 0);
  auto pairs = find_pairs(particles_, options_.domain, options_.skin);
  carry_over(pairs, named.pairs, same, std::vector<Image>(particles_.size()));
  fill_coefficients(pairs);
  contacts_ = ContactList(pairs, options_.domain, static_cast<std::int32_t>(particles_.size()));
  wall_contacts_ = named.walls;
  list_wall_contacts(same);
  halo_ = HaloExchange(particles_, pairs, ranks_);
}

void Dem::list_wall_contacts(const std::vector<std::int32_t>& place) {
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    wall_contacts_[w] =
        find_wall_contacts(walls_[w], particles_, options_.skin, wall_contacts_[w], place);
    fill_coefficients(walls_[w], wall_contacts_[w]);
  }
}

void Dem::fill_coefficients(std::vector<PairContact>& pairs) const {
  for (auto& p : pairs) {
    if (p.coefficients.a >= 0.0) continue;
    const auto& i = particles_.properties[static_cast<std::size_t>(p.i)];
    const auto& j = particles_.properties[static_cast<std::size_t>(p.j)];
    // A fixed bead is as heavy as a wall.
    const double m_eff = i.fixed ? j.mass : (j.fixed ? i.mass : effective(i.mass, j.mass));
    const Pair pair{.i = i.material,
                    .j = j.material,
                    .r_eff = effective(0.5 * i.diameter, 0.5 * j.diameter),
                    .m_eff = m_eff,
                    .m_scaled = options_.inertia_scale * m_eff};
    p.coefficients =
        std::visit([&](const auto& law) { return law.coefficients(pair); }, options_.model.contact);
  }
}

void Dem::fill_coefficients(const Wall& wall, WallContacts& contacts) const {
  for (auto& contact : contacts) {
    if (contact.coefficients.a >= 0.0) continue;
    const auto& bead = particles_.properties[static_cast<std::size_t>(contact.bead)];
    const Pair pair{.i = bead.material,
                    .j = wall.material,
                    .r_eff = 0.5 * bead.diameter,
                    .m_eff = bead.mass,
                    .m_scaled = options_.inertia_scale * bead.mass};
    contact.coefficients =
        std::visit([&](const auto& law) { return law.coefficients(pair); }, options_.model.contact);
  }
}

double Dem::overlap(const PairContact& p) const {
  const auto i = static_cast<std::size_t>(p.i);
  const auto j = static_cast<std::size_t>(p.j);
  const Vec3 d = particles_.motion[i].x - particles_.motion[j].x - offset(options_.domain, p.image);
  return particles_.radius(i) + particles_.radius(j) - norm(d);
}

void Dem::check_overlaps() const {
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    for (const auto& contact : wall_contacts_[w]) {
      const auto i = static_cast<std::size_t>(contact.bead);
      const double diameter = 2.0 * particles_.radius(i);
      const double depth = 0.5 * diameter - distance_to(walls_[w], particles_.motion[i].x).distance;
      if (depth <= options_.overlap_limit * diameter) continue;
      throw DivergenceError(fmt::format(
          "step {}, time {:.6g} s: {} is {:.3g} um, {:.3g} of its diameter, inside the wall "
          "\"{}\"; the "
          "limit is {:.3g}. Take a smaller step or softer loads, or start with beads away from it",
          steps_, time(), where(particles_.properties[i], particles_.motion[i].x), 1e6 * depth,
          depth / diameter, walls_[w].name, options_.overlap_limit));
    }
  }
  for (const auto& p : contacts_.pairs()) {
    const auto i = static_cast<std::size_t>(p.i);
    const auto j = static_cast<std::size_t>(p.j);
    const double smaller = 2.0 * std::min(particles_.radius(i), particles_.radius(j));
    const double depth = overlap(p);
    if (depth <= options_.overlap_limit * smaller) continue;
    throw DivergenceError(fmt::format(
        "step {}, time {:.6g} s: {} overlaps bead {} by {:.3g} um, {:.3g} of the smaller diameter; "
        "the limit is {:.3g}. Take a smaller step, softer loads or stiffer beads, or start with "
        "beads "
        "apart",
        steps_, time(), where(particles_.properties[i], particles_.motion[i].x),
        particles_.properties[j].id, 1e6 * depth, depth / smaller, options_.overlap_limit));
  }
}

StableStep Dem::stable() const {
  return stable_step(options_.model, particles_, contacts_, walls_, wall_contacts_);
}

}  // namespace packbed::dem
