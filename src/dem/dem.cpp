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

constexpr std::int64_t steps_to_look = 100;  // after which the near list may be found too wide

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
      largest_diameter_(largest_diameter(beads)),
      cell_(std::max(largest_diameter_, 1e-12)),
      partition_(options.domain, cell_, ranks, options.mesh) {
  constexpr double skin_of_diameter = 0.05;
  if (options_.skin <= 0.0) options_.skin = skin_of_diameter * cell_;
  near_skin_ = options_.skin / 16.0;
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
  add_forces_of_walls();
  add_contact_forces_and_move(
      {.kick = 0.5 * (last_step_ + dt), .drift = dt, .damping = options_.background_damping});
  if (ranks_.size() > 1) {
    halo_.refresh(particles_, ranks_);
    moved_ = displacement_of_own();
  }
  move_walls(dt);
  last_step_ = dt;
  ++steps_;
}

void Dem::add_forces_of_walls() {
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    add_wall_forces(options_.model, walls_[w], wall_contacts_[w], particles_, spring_step());
  }
}

// Contacts are sorted by i, and j > i: once all contacts of lower beads are done, a bead occurs in no
// other, and is moved while it is still in the cache. Halo beads are moved along, and then overwritten
// by their owners.
void Dem::add_contact_forces_and_move(const Leapfrog& step) {
  constexpr std::size_t chunk = 32;
  const std::size_t blocks = contacts_.blocks.size();
  std::size_t moved = 0;
  Vec3 largest;
  double spoiled = 0.0;  // a number that is none spoils it
  for (std::size_t first = 0; moved < particles_.size(); first += chunk) {
    const std::size_t last = std::min(first + chunk, blocks);
    add_contact_forces(options_.model, contacts_, first, last, particles_, spring_step());
    const std::size_t done =
        last < blocks ? static_cast<std::size_t>(contacts_.blocks[last].i[0]) : particles_.size();
    const Vec3 far = move_beads(particles_, moved, done, step);
    largest = {std::max(far.x, largest.x), std::max(far.y, largest.y), std::max(far.z, largest.z)};
    spoiled += 0.0 * (far.x + far.y + far.z);
    moved = done;
  }
  // The norm of the largest components bounds the largest displacement.
  moved_ = norm(largest) + spoiled;
}

// The same bound where some beads are not ours: over the own beads of all ranks.
double Dem::displacement_of_own() const {
  Vec3 largest;
  double spoiled = 0.0;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    if (!particles_.is_own(i)) continue;
    const Vec3 d = particles_.motion[i].x - particles_.reference[i];
    largest = {std::max(largest.x, std::abs(d.x)), std::max(largest.y, std::abs(d.y)),
               std::max(largest.z, std::abs(d.z))};
    spoiled += 0.0 * (d.x + d.y + d.z);
  }
  return norm({ranks_.max(largest.x + spoiled), ranks_.max(largest.y), ranks_.max(largest.z)});
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

// Two beads may each have moved by moved_, a bead and a wall by all that they moved since the
// renewal. NaN renews too, and is found there.
void Dem::renew_if_needed() {
  const bool walls_hold = far_moved_ + moved_ + walls_moved_ < options_.skin;
  const bool lists_hold = 2.0 * moved_ < near_skin_ && walls_hold;
  const double skin = adapted_near_skin();
  const std::int64_t lasted = steps_ - near_listed_;
  const bool too_wide = lasted > 0 && lasted % steps_to_look == 0 && skin < 0.6 * near_skin_;
  if (lists_hold && !too_wide) return;
  near_skin_ = skin;
  far_moved_ = far_displacement();
  const bool far_list_holds =
      2.0 * far_moved_ + near_skin_ < options_.skin && far_moved_ + walls_moved_ < options_.skin;
  if (far_list_holds) {
    list_near_pairs();
  } else {
    renew();
  }
}

// What would last for some steps at the present pace. By counts of steps, never by time: a run must
// not depend on the machine.
double Dem::adapted_near_skin() const {
  constexpr double steps_to_last = 200.0;
  const auto lasted = static_cast<double>(std::max<std::int64_t>(steps_ - near_listed_, 1));
  const double wanted = 2.0 * moved_ * steps_to_last / lasted;
  const double near = std::clamp(wanted, 0.25 * near_skin_, 2.0 * near_skin_);
  return std::clamp(near, options_.skin / 64.0, options_.skin);
}

double Dem::far_displacement() const {
  double largest = 0.0;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    if (!particles_.is_own(i)) continue;
    const Vec3 d = particles_.motion[i].x - far_reference_[i];
    const double square = dot(d, d);
    if (!(square <= largest)) largest = square;
    if (std::isnan(largest)) break;
  }
  return ranks_.max(std::sqrt(largest));
}

// Springs are kept; pairs left out do not touch and have none.
void Dem::list_near_pairs() {
  ContactList list(options_.domain, static_cast<std::int32_t>(particles_.size()));
  list.blocks.reserve(contacts_.blocks.size() + contacts_.blocks.size() / 8 + 1);
  std::size_t k = 0;
  for (const auto& key : far_pairs_) {
    if (-overlap(key) >= near_skin_) continue;
    while (k < contacts_.size() && contacts_.key(k) < key) ++k;
    PairContact p{key, {}, {}};
    if (k < contacts_.size() && contacts_.key(k) == key) {
      p = contacts_.pair(k);
    } else {
      p.coefficients = coefficients_of(key);
    }
    list.push_back(p);
  }
  contacts_ = std::move(list);
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    particles_.reference[i] = particles_.motion[i].x;
  }
  moved_ = 0.0;
  near_listed_ = steps_;
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

// All ranks renew at the same step.
void Dem::renew() {
  check_finite();
  if (ranks_.size() > 1) {
    trade_beads_and_contacts();
  } else {
    sort_beads_and_contacts();
  }
  far_reference_.assign(particles_.reference.begin(), particles_.reference.end());
  far_moved_ = 0.0;
  walls_moved_ = 0.0;
  ++renewals_;
}

void Dem::sort_beads_and_contacts() {
  const auto wraps = wrap(particles_, options_.domain);
  const auto order = key_order(particles_, options_.domain, cell_);
  std::vector<std::int32_t> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    place[static_cast<std::size_t>(order[k])] = static_cast<std::int32_t>(k);
  }
  reorder(particles_, order);
  far_pairs_ = find_pairs(particles_, options_.domain, options_.skin);
  contacts_ = ContactList(carry_over(contacts_.pairs(), place, wraps), options_.domain,
                          static_cast<std::int32_t>(particles_.size()));
  list_near_pairs();
  list_wall_contacts(place);
}

// The same on several ranks: beads and contacts travel by name, and get their places anew.
void Dem::trade_beads_and_contacts() {
  const auto wraps = wrap(particles_, options_.domain);
  auto luggage = pack(particles_, contacts_.pairs(), wall_contacts_, wraps);
  std::vector<Vec3> own;
  for (const auto& bead : luggage.beads) own.push_back(bead.motion.x);
  if (partition_.balance(own, options_.load_tolerance, renewals_ == 0) > options_.load_tolerance) {
    ++repartitions_;
  }
  luggage = migrate(luggage, partition_, ranks_);
  const auto foreign = halo(luggage.beads, partition_, largest_diameter_ + options_.skin, ranks_);
  place_beads(luggage.beads, foreign, particles_);
  reorder(particles_, key_order(particles_, options_.domain, cell_));

  const auto named = place_contacts(luggage, particles_, walls_.size());
  std::vector<std::int32_t> same(particles_.size());
  std::iota(same.begin(), same.end(), 0);
  const std::vector<Image> unmoved(particles_.size());
  far_pairs_ = find_pairs(particles_, options_.domain, options_.skin);
  contacts_ = ContactList(carry_over(named.pairs, same, unmoved), options_.domain,
                          static_cast<std::int32_t>(particles_.size()));
  list_near_pairs();
  wall_contacts_ = named.walls;
  list_wall_contacts(same);
  halo_ = HaloExchange(particles_, far_pairs_, ranks_);
}

void Dem::list_wall_contacts(const std::vector<std::int32_t>& place) {
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    wall_contacts_[w] =
        find_wall_contacts(walls_[w], particles_, options_.skin, wall_contacts_[w], place);
    fill_coefficients(walls_[w], wall_contacts_[w]);
  }
}

Coefficients Dem::coefficients_of(const PairKey& p) const {
  const auto& i = particles_.properties[static_cast<std::size_t>(p.i)];
  const auto& j = particles_.properties[static_cast<std::size_t>(p.j)];
  // A fixed bead is as heavy as a wall.
  const double m_eff = i.fixed ? j.mass : (j.fixed ? i.mass : effective(i.mass, j.mass));
  const Pair pair{.i = i.material,
                  .j = j.material,
                  .r_eff = effective(0.5 * i.diameter, 0.5 * j.diameter),
                  .m_eff = m_eff,
                  .m_scaled = options_.inertia_scale * m_eff};
  return std::visit([&](const auto& law) { return law.coefficients(pair); },
                    options_.model.contact);
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

double Dem::overlap(const PairKey& p) const {
  const auto i = static_cast<std::size_t>(p.i);
  const auto j = static_cast<std::size_t>(p.j);
  const Vec3 d = particles_.motion[i].x - particles_.motion[j].x - offset(options_.domain, p.image);
  return particles_.radius(i) + particles_.radius(j) - norm(d);
}

void Dem::check_overlaps() const {
  check_finite();
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
  const auto here = stable_step(options_.model, particles_, contacts_, walls_, wall_contacts_);
  const auto count = static_cast<std::size_t>(ranks_.size());
  StableStep limit = here;
  for (const auto& part : ranks_.exchange(std::vector<std::vector<StableStep>>(count, {here}))) {
    const auto& other = part[0];
    if (std::pair(other.step, other.bead) < std::pair(limit.step, limit.bead)) limit = other;
  }
  return limit;
}

}  // namespace packbed::dem
