// SPDX-License-Identifier: BSD-3-Clause
#include "dem/exchange.hpp"

#include <array>
#include <set>
#include <unordered_map>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::dem {
namespace {

/// What an owner tells of a bead after each step.
struct State {
  Vec3 x, v, w;
};

template <class T>
std::vector<std::vector<T>> one_per(const Ranks& ranks) {
  return std::vector<std::vector<T>>(static_cast<std::size_t>(ranks.size()));
}

template <class T>
void append(std::vector<T>& all, const std::vector<std::vector<T>>& parts) {
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
}

std::int64_t count_all(std::size_t own, const Ranks& ranks) {
  std::array<std::int64_t, 1> count = {static_cast<std::int64_t>(own)};
  ranks.sum(count);
  return count[0];
}

}  // namespace

Luggage pack(const Particles& particles,
             const std::vector<PairContact>& pairs,
             const std::vector<WallContacts>& walls,
             const std::vector<Image>& wraps) {
  Luggage luggage;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (!particles.is_own(i)) continue;
    luggage.beads.push_back(
        {particles.motion[i], particles.spin[i], particles.properties[i], particles.owner[i]});
  }
  for (const auto& p : pairs) {
    const auto i = static_cast<std::size_t>(p.i);
    const auto j = static_cast<std::size_t>(p.j);
    Image image = p.image;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      image[axis] = static_cast<std::int8_t>(image[axis] + wraps[i][axis] - wraps[j][axis]);
    }
    luggage.contacts.push_back(
        {particles.properties[i].id, particles.properties[j].id, image, p.coefficients, p.history});
  }
  for (std::size_t w = 0; w < walls.size(); ++w) {
    for (const auto& c : walls[w]) {
      luggage.wall_contacts.push_back({particles.properties[static_cast<std::size_t>(c.bead)].id,
                                       static_cast<std::int32_t>(w), c.coefficients, c.history});
    }
  }
  return luggage;
}

Luggage migrate(const Luggage& luggage, const Partition& partition, const Ranks& ranks) {
  const auto before = count_all(luggage.beads.size(), ranks);
  auto beads = one_per<NamedBead>(ranks);
  std::unordered_map<std::int64_t, int> home;  // of the beads that were here
  for (auto bead : luggage.beads) {
    bead.owner = partition.owner(bead.motion.x);
    home[bead.properties.id] = bead.owner;
    beads[static_cast<std::size_t>(bead.owner)].push_back(bead);
  }
  // A contact goes wherever one of its beads goes; each rank drops what it has twice.
  auto contacts = one_per<NamedContact>(ranks);
  for (const auto& c : luggage.contacts) {
    std::set<int> goals;
    for (const auto id : {c.id_i, c.id_j}) {
      if (const auto found = home.find(id); found != home.end()) goals.insert(found->second);
    }
    for (const int goal : goals) contacts[static_cast<std::size_t>(goal)].push_back(c);
  }
  auto wall_contacts = one_per<NamedWallContact>(ranks);
  for (const auto& c : luggage.wall_contacts) {
    wall_contacts[static_cast<std::size_t>(home.at(c.id))].push_back(c);
  }
  Luggage arrived;
  append(arrived.beads, ranks.exchange(beads));
  append(arrived.contacts, ranks.exchange(contacts));
  append(arrived.wall_contacts, ranks.exchange(wall_contacts));
  if (const auto after = count_all(arrived.beads.size(), ranks); after != before) {
    throw DivergenceError(
        fmt::format("migration between ranks changed the number of beads from {} to {}; this is a "
                    "mistake in packbed, please report it",
                    before, after));
  }
  return arrived;
}

std::vector<NamedBead> halo(const std::vector<NamedBead>& own,
                            const Partition& partition,
                            double reach,
                            const Ranks& ranks) {
  auto copies = one_per<NamedBead>(ranks);
  for (const auto& bead : own) {
    for (const int rank : partition.owners_within(bead.motion.x, reach)) {
      if (rank != ranks.rank()) copies[static_cast<std::size_t>(rank)].push_back(bead);
    }
  }
  std::vector<NamedBead> foreign;
  append(foreign, ranks.exchange(copies));
  return foreign;
}

void place_beads(const std::vector<NamedBead>& own,
                 const std::vector<NamedBead>& foreign,
                 Particles& particles) {
  clear(particles);
  for (const auto* beads : {&own, &foreign}) {
    for (const auto& b : *beads) add(particles, b.motion, b.spin, b.properties, b.owner);
  }
}

PlacedContacts place_contacts(const Luggage& luggage,
                              const Particles& particles,
                              std::size_t wall_count) {
  std::unordered_map<std::int64_t, std::int32_t> place;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    place[particles.properties[i].id] = static_cast<std::int32_t>(i);
  }
  PlacedContacts placed;
  for (const auto& c : luggage.contacts) {
    const auto i = place.find(c.id_i);
    const auto j = place.find(c.id_j);
    if (i == place.end() || j == place.end()) continue;
    placed.pairs.push_back(
        {{.i = i->second, .j = j->second, .image = c.image}, c.coefficients, c.history});
  }
  placed.walls.resize(wall_count);
  for (const auto& c : luggage.wall_contacts) {
    placed.walls[static_cast<std::size_t>(c.wall)].push_back(
        {place.at(c.id), c.coefficients, c.history});
  }
  return placed;
}

HaloExchange::HaloExchange(const Particles& particles,
                           const std::vector<PairKey>& pairs,
                           const Ranks& ranks)
    : send_(one_per<std::int32_t>(ranks)), receive_(one_per<std::int32_t>(ranks)) {
  std::set<std::int32_t> used;
  for (const auto& p : pairs) {
    for (const auto k : {p.i, p.j}) {
      if (!particles.is_own(static_cast<std::size_t>(k))) used.insert(k);
    }
  }
  auto wanted = one_per<std::int64_t>(ranks);
  for (const auto k : used) {
    const auto owner = static_cast<std::size_t>(particles.owner[static_cast<std::size_t>(k)]);
    receive_[owner].push_back(k);
    wanted[owner].push_back(particles.properties[static_cast<std::size_t>(k)].id);
  }
  std::unordered_map<std::int64_t, std::int32_t> place;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.is_own(i)) place[particles.properties[i].id] = static_cast<std::int32_t>(i);
  }
  const auto asked = ranks.exchange(wanted);
  for (std::size_t r = 0; r < asked.size(); ++r) {
    for (const auto id : asked[r]) send_[r].push_back(place.at(id));
  }
}

void HaloExchange::refresh(Particles& particles, const Ranks& ranks) const {
  auto out = one_per<State>(ranks);
  for (std::size_t r = 0; r < send_.size(); ++r) {
    for (const auto k : send_[r]) {
      const auto i = static_cast<std::size_t>(k);
      out[r].push_back({particles.motion[i].x, particles.motion[i].v, particles.spin[i].w});
    }
  }
  const auto in = ranks.exchange(out);
  for (std::size_t r = 0; r < receive_.size(); ++r) {
    for (std::size_t n = 0; n < receive_[r].size(); ++n) {
      const auto i = static_cast<std::size_t>(receive_[r][n]);
      particles.motion[i].x = in[r][n].x;
      particles.motion[i].v = in[r][n].v;
      particles.spin[i].w = in[r][n].w;
    }
  }
}

}  // namespace packbed::dem
