// SPDX-License-Identifier: BSD-3-Clause
#include "dem/state.hpp"

#include <algorithm>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "core/sorted_shares.hpp"
#include "dem/dem.hpp"
#include "dem/neighbors.hpp"

namespace packbed::dem {
namespace {

using Places = std::unordered_map<std::int64_t, std::int32_t>;

Places places_of(const Particles& particles) {
  Places places;
  places.reserve(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    places[particles.properties[i].id] = static_cast<std::int32_t>(i);
  }
  return places;
}

template <class T>
std::vector<T> gather_everywhere(const std::vector<T>& values, const Ranks& ranks) {
  const std::vector<std::vector<T>> to_each(static_cast<std::size_t>(ranks.size()), values);
  std::vector<T> all;
  for (const auto& part : ranks.exchange(to_each)) all.insert(all.end(), part.begin(), part.end());
  return all;
}

bool is_zero(const Vec3& a) { return a.x == 0.0 && a.y == 0.0 && a.z == 0.0; }

double rolling_friction_of(const RollingLaw& law) {
  if (const auto* constant = std::get_if<ConstantTorque>(&law)) return constant->mu_r;
  if (const auto* spring = std::get_if<ElasticPlastic>(&law)) return spring->mu_r;
  return 0.0;
}

/// Springs of the saved contacts whose beads are both here; coefficients are not filled in.
std::vector<PairContact> placed(const std::vector<ContactState>& contacts, const Places& places) {
  std::vector<PairContact> pairs;
  for (const auto& c : contacts) {
    const auto i = places.find(c.id_i);
    const auto j = places.find(c.id_j);
    if (i == places.end() || j == places.end()) continue;
    pairs.push_back({{.i = i->second, .j = j->second, .image = c.image}, {}, c.history});
  }
  return pairs;
}

std::vector<WallContacts> placed(const std::vector<WallContactState>& contacts,
                                 const Places& places,
                                 const Particles& particles,
                                 std::size_t walls) {
  std::vector<WallContacts> near(walls);
  for (const auto& c : contacts) {
    const auto i = places.find(c.id);
    if (i == places.end() || !particles.is_own(static_cast<std::size_t>(i->second))) continue;
    near[static_cast<std::size_t>(c.wall)].push_back({i->second, {.a = -1.0}, c.history});
  }
  for (auto& list : near) std::ranges::sort(list, {}, &WallContact::bead);
  return near;
}

}  // namespace

DemState whole(const DemState& share, const Ranks& ranks) {
  DemState all = share;
  if (ranks.size() == 1) return all;
  all.beads = gather_everywhere(share.beads, ranks);
  all.contacts = gather_everywhere(share.contacts, ranks);
  all.wall_contacts = gather_everywhere(share.wall_contacts, ranks);
  return all;
}

DemState in_order_of_ids(DemState share, const Ranks& ranks) {
  share.beads = sorted_shares(
      std::move(share.beads), [](const BeadState& b) { return std::tuple(b.properties.id); },
      ranks);
  share.contacts = sorted_shares(
      std::move(share.contacts),
      [](const ContactState& c) {
        return std::tuple(c.id_i, c.id_j, c.image[0], c.image[1], c.image[2]);
      },
      ranks);
  share.wall_contacts = sorted_shares(
      std::move(share.wall_contacts),
      [](const WallContactState& c) { return std::tuple(c.id, c.wall); }, ranks);
  return share;
}

// A contact between two ranks is in the share of its first bead's.
DemState Dem::state() const {
  DemState s;
  const auto& p = particles_;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!p.is_own(i)) continue;
    s.beads.push_back({p.properties[i], p.motion[i].x, p.motion[i].v, p.spin[i].w, p.reference[i],
                       far_reference_[i], p.in_liquid ? p.drag[i] : Drag{},
                       p.in_liquid ? p.coupled_at[i] : CouplingMark{}});
  }
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const auto c = contacts_.pair(k);
    const auto i = static_cast<std::size_t>(c.i);
    if (!p.is_own(i) || (is_zero(c.history.spring) && is_zero(c.history.angle))) continue;
    s.contacts.push_back(
        {p.properties[i].id, p.properties[static_cast<std::size_t>(c.j)].id, c.image, c.history});
  }
  for (std::size_t w = 0; w < wall_contacts_.size(); ++w) {
    for (const auto& c : wall_contacts_[w]) {
      s.wall_contacts.push_back({p.properties[static_cast<std::size_t>(c.bead)].id,
                                 static_cast<std::int32_t>(w), c.history});
    }
  }
  s.walls = walls_;
  s.progress = {.steps = steps_,
                .steps_before = steps_before_,
                .near_listed = near_listed_,
                .renewals = renewals_,
                .repartitions = repartitions_,
                .time_before = time_before_,
                .step = options_.step,
                .last_step = last_step_,
                .skin = options_.skin,
                .near_skin = near_skin_,
                .moved = moved_,
                .far_moved = far_moved_,
                .walls_moved = walls_moved_,
                .cell = cell_,
                .inertia_scale = options_.inertia_scale,
                .inertia_diameter = options_.inertia_diameter,
                .background_damping = options_.background_damping,
                .friction = options_.model.friction,
                .rolling_friction = rolling_friction_of(options_.model.rolling),
                .in_liquid = particles_.in_liquid ? 1 : 0};
  return s;
}

Dem::Dem(const DemOptions& options, const DemState& all, Lists lists, const Ranks& ranks)
    : options_(options),
      walls_(all.walls),
      wall_contacts_(all.walls.size()),
      ranks_(ranks),
      bead_count_(static_cast<std::int64_t>(all.beads.size())),
      partition_(options.domain, all.progress.cell, ranks, options.mesh) {
  take_over(all.progress);
  for (const auto& bead : all.beads) {
    largest_diameter_ = std::max(largest_diameter_, bead.properties.diameter);
  }
  particles_.rank = ranks_.rank();
  if (lists == Lists::as_saved) {
    restore_lists(all);
  } else {
    start_anew(all);
  }
}

void Dem::take_over(const DemProgress& progress) {
  options_.step = progress.step;
  options_.skin = progress.skin;
  options_.inertia_scale = progress.inertia_scale;
  options_.inertia_diameter = progress.inertia_diameter;
  options_.background_damping = progress.background_damping;
  options_.model.friction = progress.friction;
  set_rolling_friction(progress.rolling_friction);
  cell_ = progress.cell;
  near_skin_ = progress.near_skin;
  last_step_ = progress.last_step;
  time_before_ = progress.time_before;
  steps_before_ = progress.steps_before;
  steps_ = progress.steps;
  renewals_ = progress.renewals;
  repartitions_ = progress.repartitions;
}

// The lists are found once more, at the centers at which the saved run had found them.
void Dem::restore_lists(const DemState& all) {
  std::vector<Vec3> share;  // a part of the beads, so that every bead counts once
  for (auto k = static_cast<std::size_t>(ranks_.rank()); k < all.beads.size();
       k += static_cast<std::size_t>(ranks_.size())) {
    share.push_back(all.beads[k].far_reference);
  }
  partition_.balance(share, std::vector<std::int64_t>(share.size(), 1), options_.load_tolerance,
                     true);
  particles_ = make_particles({}, {});
  particles_.rank = ranks_.rank();
  particles_.in_liquid = all.progress.in_liquid != 0;
  std::vector<const BeadState*> here;
  for (const auto& bead : all.beads) {
    const int owner = partition_.owner(bead.far_reference);
    const auto near =
        partition_.owners_within(bead.far_reference, largest_diameter_ + options_.skin);
    if (owner != ranks_.rank() && std::ranges::find(near, ranks_.rank()) == near.end()) continue;
    const auto motion = motion_of(bead.properties, bead.far_reference, bead.v);
    add(particles_, motion, {.w = bead.w, .half_radius = 0.25 * bead.properties.diameter},
        bead.properties, owner, bead.drag, bead.coupled_at);
    here.push_back(&bead);
  }
  const auto order = key_order(particles_, options_.domain, cell_);
  reorder(particles_, order);
  far_pairs_ = find_pairs(particles_, options_.domain, options_.skin);

  const auto bead_at = [&](std::size_t i) { return here[static_cast<std::size_t>(order[i])]; };
  for (std::size_t i = 0; i < order.size(); ++i) particles_.motion[i].x = bead_at(i)->reference;
  const auto places = places_of(particles_);
  auto pairs = placed(all.contacts, places);
  for (auto& p : pairs) p.coefficients = coefficients_of(p);
  std::ranges::sort(pairs, {}, [](const PairKey& p) -> const PairKey& { return p; });
  contacts_ = ContactList(pairs, options_.domain, static_cast<std::int32_t>(particles_.size()));
  list_near_pairs(OldContacts(contacts_));
  wall_contacts_ = placed(all.wall_contacts, places, particles_, walls_.size());
  for (std::size_t w = 0; w < walls_.size(); ++w) fill_coefficients(walls_[w], wall_contacts_[w]);
  if (ranks_.size() > 1) {
    own_runs_ = own_runs(particles_);
    halo_ = HaloExchange(particles_, far_pairs_, ranks_);
  }

  far_reference_.resize(particles_.size() + 2);
  for (std::size_t i = 0; i < order.size(); ++i) {
    particles_.motion[i].x = bead_at(i)->x;
    far_reference_[i] = bead_at(i)->far_reference;
  }
  near_listed_ = all.progress.near_listed;
  moved_ = all.progress.moved;
  far_moved_ = all.progress.far_moved;
  walls_moved_ = all.progress.walls_moved;
}

// As at the start of a run, but with springs: rank 0 has all beads, and the renewal deals them out.
void Dem::start_anew(const DemState& all) {
  cell_ = std::max(cell_, largest_diameter_);
  partition_ = Partition(options_.domain, cell_, ranks_, options_.mesh);
  particles_ = make_particles({}, {});
  particles_.rank = ranks_.rank();
  particles_.in_liquid = all.progress.in_liquid != 0;
  renewals_ = 0;  // cuts the rows in any case
  if (ranks_.is_first()) {
    for (const auto& bead : all.beads) {
      add(particles_, motion_of(bead.properties, bead.x, bead.v),
          {.w = bead.w, .half_radius = 0.25 * bead.properties.diameter}, bead.properties, 0,
          bead.drag, bead.coupled_at);
    }
    const auto places = places_of(particles_);
    auto pairs = placed(all.contacts, places);
    for (auto& p : pairs) p.coefficients = coefficients_of(p);
    contacts_ = ContactList(pairs, options_.domain, static_cast<std::int32_t>(particles_.size()));
    wall_contacts_ = placed(all.wall_contacts, places, particles_, walls_.size());
  }
  renew();
  renewals_ += all.progress.renewals;
  check_overlaps();
}

Motion Dem::motion_of(const BeadProperties& bead, const Vec3& x, const Vec3& v) const {
  const double mass = options_.inertia().of(bead.diameter) * bead.mass;
  return {.x = x,
          .v = v,
          .inv_mass = bead.fixed ? 0.0 : 1.0 / mass,
          .inv_inertia = bead.fixed ? 0.0 : 1.0 / (0.1 * mass * bead.diameter * bead.diameter)};
}

void Dem::set_rolling_friction(double mu_r) {
  if (auto* constant = std::get_if<ConstantTorque>(&options_.model.rolling)) constant->mu_r = mu_r;
  if (auto* spring = std::get_if<ElasticPlastic>(&options_.model.rolling)) spring->mu_r = mu_r;
}

void Dem::set_weights(const std::function<double(const BeadProperties&)>& weight) {
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    auto& bead = particles_.properties[i];
    bead.weight = weight(bead);
    particles_.load[i].weight = bead.weight;
    particles_.load[i].force = {0.0, 0.0, -bead.weight};
  }
}

void Dem::set_velocities(const std::vector<NewVelocity>& velocities) {
  const auto size = static_cast<std::size_t>(ranks_.size());
  std::vector<std::vector<NewVelocity>> to_each(size);
  if (ranks_.is_first()) std::ranges::fill(to_each, velocities);
  std::unordered_map<std::int64_t, Vec3> by_id;
  const auto from_each = ranks_.exchange(to_each);
  for (const auto& n : from_each.front()) by_id[n.id] = n.v;
  if (by_id.empty()) return;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const auto found = by_id.find(particles_.properties[i].id);
    if (found != by_id.end()) particles_.motion[i].v = found->second;  // halo beads too
  }
}

void Dem::set_inertia(const InertiaScale& inertia) {
  options_.inertia_scale = inertia.scale;
  options_.inertia_diameter = inertia.diameter;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    auto& m = particles_.motion[i];
    m = motion_of(particles_.properties[i], m.x, m.v);
  }
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    contacts_.set_coefficients(k, coefficients_of(contacts_.key(k)));
  }
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    for (auto& contact : wall_contacts_[w]) contact.coefficients.a = -1.0;
    fill_coefficients(walls_[w], wall_contacts_[w]);
  }
}

}  // namespace packbed::dem
