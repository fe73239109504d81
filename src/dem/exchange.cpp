// SPDX-License-Identifier: BSD-3-Clause
#include "dem/exchange.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace packbed::dem {
namespace {

template <class T>
std::vector<std::vector<T>> one_per(const Ranks& ranks) {
  return std::vector<std::vector<T>>(static_cast<std::size_t>(ranks.size()));
}

template <class T>
std::vector<T> joined(const std::vector<std::vector<T>>& parts) {
  std::vector<T> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

NamedBead named(const Particles& p, std::size_t i, std::int32_t owner) {
  return {.motion = p.motion[i],
          .spin = p.spin[i],
          .properties = p.properties[i],
          .owner = owner,
          .drag = p.in_liquid ? p.drag[i] : Drag{},
          .coupled_at = p.in_liquid ? p.coupled_at[i] : CouplingMark{}};
}

}  // namespace

std::vector<Vec3> own_centers(const Particles& particles) {
  std::vector<Vec3> centers;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.is_own(i)) centers.push_back(particles.motion[i].x);
  }
  return centers;
}

std::vector<std::int64_t> own_work(const Particles& particles, const ContactList& contacts) {
  std::vector<std::int64_t> work(particles.size(), 1);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto key = contacts.key(k);
    ++work[static_cast<std::size_t>(key.i)];
    ++work[static_cast<std::size_t>(key.j)];
  }
  std::size_t own = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.is_own(i)) work[own++] = work[i];
  }
  work.resize(own);
  return work;
}

std::vector<std::int32_t> new_owners(const Particles& particles, const Partition& partition) {
  std::vector<std::int32_t> owners(particles.size(), -1);
  for (std::size_t i = 0; i < owners.size(); ++i) {
    if (particles.is_own(i)) owners[i] = partition.owner(particles.motion[i].x);
  }
  return owners;
}

Luggage migrate(const Particles& particles,
                const ContactList& contacts,
                const std::vector<WallContacts>& walls,
                const std::vector<Image>& wraps,
                const std::vector<std::int32_t>& owners,
                const Ranks& ranks) {
  const auto leaves = [&](std::size_t i) { return owners[i] >= 0 && owners[i] != ranks.rank(); };
  auto beads = one_per<NamedBead>(ranks);
  for (std::size_t i = 0; i < owners.size(); ++i) {
    if (!leaves(i)) continue;
    beads[static_cast<std::size_t>(owners[i])].push_back(named(particles, i, owners[i]));
  }
  auto named_contacts = one_per<NamedContact>(ranks);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto key = contacts.key(k);
    const auto i = static_cast<std::size_t>(key.i);
    const auto j = static_cast<std::size_t>(key.j);
    if (!leaves(i) && !leaves(j)) continue;
    const auto c = contacts.pair(k);
    NamedContact contact{particles.properties[i].id, particles.properties[j].id, c.image,
                         c.coefficients, c.history};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      contact.image[axis] =
          static_cast<std::int8_t>(c.image[axis] + wraps[i][axis] - wraps[j][axis]);
    }
    if (leaves(i)) named_contacts[static_cast<std::size_t>(owners[i])].push_back(contact);
    if (leaves(j) && !(leaves(i) && owners[i] == owners[j])) {
      named_contacts[static_cast<std::size_t>(owners[j])].push_back(contact);
    }
  }
  auto wall_contacts = one_per<NamedWallContact>(ranks);
  for (std::size_t w = 0; w < walls.size(); ++w) {
    for (const auto& c : walls[w]) {
      const auto i = static_cast<std::size_t>(c.bead);
      if (!leaves(i)) continue;
      wall_contacts[static_cast<std::size_t>(owners[i])].push_back(
          {particles.properties[i].id, static_cast<std::int32_t>(w), c.coefficients, c.history});
    }
  }
  return {joined(ranks.exchange(beads)), joined(ranks.exchange(named_contacts)),
          joined(ranks.exchange(wall_contacts))};
}

std::vector<NamedBead> halo(const Particles& own,
                            const Partition& partition,
                            double reach,
                            const Ranks& ranks) {
  auto copies = one_per<NamedBead>(ranks);
  for (std::size_t i = 0; i < own.size(); ++i) {
    for (const int rank : partition.owners_within(own.motion[i].x, reach)) {
      if (rank == ranks.rank()) continue;
      copies[static_cast<std::size_t>(rank)].push_back(named(own, i, own.owner[i]));
    }
  }
  return joined(ranks.exchange(copies));
}

void add(Particles& particles, const std::vector<NamedBead>& beads) {
  for (const auto& b : beads)
    add(particles, b.motion, b.spin, b.properties, b.owner, b.drag, b.coupled_at);
}

std::vector<Run> own_runs(const Particles& particles) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (!particles.is_own(i)) continue;
    if (runs.empty() || runs.back().last != i) runs.push_back({i, i});
    ++runs.back().last;
  }
  return runs;
}

HaloExchange::HaloExchange(const Particles& particles,
                           const std::vector<PairKey>& pairs,
                           const Ranks& ranks) {
  std::vector<bool> used(particles.size());
  for (const auto& p : pairs) {
    for (const auto k : {p.i, p.j}) {
      const auto i = static_cast<std::size_t>(k);
      if (!particles.is_own(i)) used[i] = true;
    }
  }
  auto receive = one_per<std::int32_t>(ranks);
  auto wanted = one_per<std::int64_t>(ranks);
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    const auto owner = static_cast<std::size_t>(particles.owner[i]);
    receive[owner].push_back(static_cast<std::int32_t>(i));
    wanted[owner].push_back(particles.properties[i].id);
  }
  const auto asked = ranks.exchange(wanted);
  PlaceOfId place;  // of the beads that others ask for
  for (const auto& ids : asked) {
    for (const auto id : ids) place[id] = -1;
  }
  for (const auto& run : own_runs(particles)) {
    for (std::size_t i = run.first; i < run.last; ++i) {
      const auto found = place.find(particles.properties[i].id);
      if (found != place.end()) found->second = static_cast<std::int32_t>(i);
    }
  }
  for (std::size_t r = 0; r < asked.size(); ++r) {
    if (asked[r].empty() && receive[r].empty()) continue;
    Neighbor n{.rank = static_cast<int>(r), .send = {}, .receive = receive[r], .out = {}, .in = {}};
    for (const auto id : asked[r]) n.send.push_back(place.at(id));
    n.out.resize(n.send.size());
    n.in.resize(n.receive.size());
    neighbors_.push_back(std::move(n));
  }
  for (auto& n : neighbors_) {
    mails_.push_back({.rank = n.rank,
                      .out = std::as_bytes(std::span(n.out)),
                      .in = std::as_writable_bytes(std::span(n.in))});
  }
}

void HaloExchange::refresh(Particles& particles, const Ranks& ranks) {
  for (auto& n : neighbors_) {
    for (std::size_t k = 0; k < n.send.size(); ++k) {
      const auto i = static_cast<std::size_t>(n.send[k]);
      n.out[k] = {particles.motion[i].x, particles.motion[i].v, particles.spin[i].w};
    }
  }
  ranks.trade(mails_);
  for (const auto& n : neighbors_) {
    for (std::size_t k = 0; k < n.receive.size(); ++k) {
      const auto i = static_cast<std::size_t>(n.receive[k]);
      particles.motion[i].x = n.in[k].x;
      particles.motion[i].v = n.in[k].v;
      particles.spin[i].w = n.in[k].w;
    }
  }
}

}  // namespace packbed::dem
