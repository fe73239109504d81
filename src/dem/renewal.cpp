// SPDX-License-Identifier: BSD-3-Clause
// When lists are renewed, and how beads, pairs and springs come into their new order.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/exact_sum.hpp"
#include "dem/dem.hpp"
#include "dem/neighbors.hpp"

namespace packbed::dem {
namespace {

constexpr std::int64_t steps_to_look = 100;  // after which the near list may be found too wide

void find_places(const Particles& particles, PlaceOfId& place_of) {
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const auto found = place_of.find(particles.properties[i].id);
    if (found != place_of.end()) found->second = static_cast<std::int32_t>(i);
  }
}

/// Of the own beads of all ranks, to the same bits wherever they are [kg m/s].
std::array<double, 3> momentum(const Particles& particles, const Ranks& ranks) {
  std::array<std::vector<double>, 3> terms;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (!particles.is_own(i)) continue;
    const Vec3 p = particles.properties[i].mass * particles.motion[i].v;
    terms[0].push_back(p.x);
    terms[1].push_back(p.y);
    terms[2].push_back(p.z);
  }
  return {order_independent_sum(terms[0], ranks), order_independent_sum(terms[1], ranks),
          order_independent_sum(terms[2], ranks)};
}

}  // namespace

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
    list_near_pairs(OldContacts(contacts_));
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
void Dem::list_near_pairs(OldContacts old) {
  ContactList list(options_.domain, static_cast<std::int32_t>(particles_.size()));
  list.reserve(far_pairs_.size());
  for (const auto& key : far_pairs_) {
    if (-overlap(key) >= near_skin_) continue;
    PairContact p{key, {}, {}};
    if (!old.take(key, p)) p.coefficients = coefficients_of(key);
    list.push_back(p);
  }
  contacts_ = std::move(list);
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    particles_.reference[i] = particles_.motion[i].x;
  }
  moved_ = 0.0;
  near_listed_ = steps_;
}

// All ranks renew at the same step.
void Dem::renew() {
  check_finite();
  far_pairs_ = {};
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
  std::vector<std::int32_t> place;
  {
    const auto order = key_order(particles_, options_.domain, cell_);
    place = places(order, particles_.size());
    reorder(particles_, order);
  }
  list_wall_contacts(place);
  far_pairs_ = find_pairs(particles_, options_.domain, options_.skin);
  auto known = carry_over(contacts_, place, wraps);
  sort_pairs(known, particles_.size());
  list_near_pairs({contacts_, std::move(known), {}});
}

// The same on several ranks. Beads that stay are found by their place, all others by their ids.
void Dem::trade_beads_and_contacts() {
  const auto wraps = wrap(particles_, options_.domain);
  const double fullest =
      partition_.balance(own_centers(particles_), own_work(particles_, contacts_),
                         options_.load_tolerance, renewals_ == 0);
  if (fullest > options_.load_tolerance) ++repartitions_;
  const auto owners = new_owners(particles_, partition_);
  const auto momentum_before = momentum(particles_, ranks_);
  const auto arrived = migrate(particles_, contacts_, wall_contacts_, wraps, owners, ranks_);

  PlaceOfId place_of;
  std::vector<std::int32_t> staying;
  std::vector<std::pair<std::size_t, std::int64_t>> others;
  for (std::size_t i = 0; i < owners.size(); ++i) {
    if (owners[i] == ranks_.rank()) {
      staying.push_back(static_cast<std::int32_t>(i));
    } else {
      others.emplace_back(i, particles_.properties[i].id);
      place_of[others.back().second] = -1;
    }
  }
  for (const auto& c : arrived.contacts) place_of[c.id_i] = place_of[c.id_j] = -1;
  for (const auto& c : arrived.wall_contacts) place_of[c.id] = -1;

  reorder(particles_, staying);
  add(particles_, arrived.beads);
  check_migration(momentum_before);
  add(particles_, halo(particles_, partition_, largest_diameter_ + options_.skin, ranks_));
  const auto order = key_order(particles_, options_.domain, cell_);
  reorder(particles_, order);
  own_runs_ = own_runs(particles_);
  find_places(particles_, place_of);

  const auto new_place = places(order, order.size());
  std::vector<std::int32_t> place(owners.size());
  for (std::size_t k = 0; k < staying.size(); ++k) {
    place[static_cast<std::size_t>(staying[k])] = new_place[k];
  }
  for (const auto& [i, id] : others) place[i] = place_of.at(id);

  far_pairs_ = find_pairs(particles_, options_.domain, options_.skin);
  auto known = carry_over(contacts_, place, wraps);
  std::vector<PairContact> contacts;
  for (const auto& c : arrived.contacts) {
    const auto i = place_of.at(c.id_i);
    const auto j = place_of.at(c.id_j);
    if (i < 0 || j < 0) continue;
    known.push_back(
        renamed(i, j, c.image, static_cast<std::int32_t>(contacts_.size() + contacts.size())));
    contacts.push_back({{.i = i, .j = j, .image = c.image}, c.coefficients, c.history});
  }
  sort_pairs(known, particles_.size());
  list_near_pairs({contacts_, std::move(known), std::move(contacts)});
  take_over_wall_contacts(arrived.wall_contacts, place, place_of);
  halo_ = HaloExchange(particles_, far_pairs_, ranks_);
}

void Dem::check_migration(const std::array<double, 3>& momentum_before) const {
  std::array<std::int64_t, 1> count = {static_cast<std::int64_t>(particles_.size())};
  ranks_.sum(count);
  if (count[0] != bead_count_) {
    throw DivergenceError(
        fmt::format("migration between ranks changed the number of beads from {} to {}; this is a "
                    "mistake in packbed, please report it",
                    bead_count_, count[0]));
  }
  const auto momentum_now = momentum(particles_, ranks_);
  if (momentum_now == momentum_before) return;
  throw DivergenceError(
      fmt::format("step {}: migration between ranks changed the momentum of the beads from "
                  "({:.17g}) to ({:.17g}) kg m/s; this is a mistake in packbed, please report it",
                  steps_, fmt::join(momentum_before, ", "), fmt::join(momentum_now, ", ")));
}

/// Those of beads that are own beads now, by their new places.
void Dem::take_over_wall_contacts(const std::vector<NamedWallContact>& arrived,
                                  const std::vector<std::int32_t>& place,
                                  const PlaceOfId& place_of) {
  for (auto& contacts : wall_contacts_) {
    for (auto& c : contacts) c.bead = place[static_cast<std::size_t>(c.bead)];
    std::erase_if(contacts, [](const WallContact& c) { return c.bead < 0; });
  }
  for (const auto& c : arrived) {
    wall_contacts_[static_cast<std::size_t>(c.wall)].push_back(
        {place_of.at(c.id), c.coefficients, c.history});
  }
  std::vector<std::int32_t> same(particles_.size());
  std::iota(same.begin(), same.end(), 0);
  list_wall_contacts(same);
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
  const auto together = [&](double m_i, double m_j) {
    return i.fixed ? m_j : (j.fixed ? m_i : effective(m_i, m_j));
  };
  const auto inertia = options_.inertia();
  const Pair pair{
      .i = i.material,
      .j = j.material,
      .r_eff = effective(0.5 * i.diameter, 0.5 * j.diameter),
      .m_eff = together(i.mass, j.mass),
      .m_scaled = together(inertia.of(i.diameter) * i.mass, inertia.of(j.diameter) * j.mass)};
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
                    .m_scaled = options_.inertia().of(bead.diameter) * bead.mass};
    contact.coefficients =
        std::visit([&](const auto& law) { return law.coefficients(pair); }, options_.model.contact);
  }
}

}  // namespace packbed::dem
