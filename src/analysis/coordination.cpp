// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/coordination.hpp"

#include <algorithm>
#include <cassert>

namespace packbed::analysis {
namespace {

/// Beads that have contacts, numbered in the order of their ids, with their neighbors: those of bead k are
/// neighbor[first[k]] to neighbor[first[k + 1] - 1].
struct Graph {
  std::vector<std::int64_t> ids;
  std::vector<std::size_t> first, neighbor;
  std::vector<int> contacts;  ///< of each bead, walls included

  [[nodiscard]] std::size_t number(std::int64_t id) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(ids, id) - ids.begin());
  }
};

Graph make_graph(std::span<const TouchingPair> pairs) {
  Graph g;
  for (const auto& p : pairs) {
    g.ids.push_back(p.i);
    if (p.j != wall_id) g.ids.push_back(p.j);
  }
  std::ranges::sort(g.ids);
  g.ids.erase(std::unique(g.ids.begin(), g.ids.end()), g.ids.end());
  g.contacts.assign(g.ids.size(), 0);
  g.first.assign(g.ids.size() + 1, 0);
  for (const auto& p : pairs) {
    ++g.contacts[g.number(p.i)];
    if (p.j == wall_id) continue;
    ++g.contacts[g.number(p.j)];
    ++g.first[g.number(p.i) + 1];
    ++g.first[g.number(p.j) + 1];
  }
  for (std::size_t k = 1; k < g.first.size(); ++k) g.first[k] += g.first[k - 1];
  g.neighbor.resize(g.first.back());
  auto next = g.first;
  for (const auto& p : pairs) {
    if (p.j == wall_id) continue;
    g.neighbor[next[g.number(p.i)]++] = g.number(p.j);
    g.neighbor[next[g.number(p.j)]++] = g.number(p.i);
  }
  return g;
}

/// Which beads are rattlers.
std::vector<bool> rattlers(const Graph& g, int holding) {
  std::vector<bool> loose(g.ids.size(), false);
  auto contacts = g.contacts;
  std::vector<std::size_t> waiting;
  const auto look_at = [&](std::size_t k) {
    if (loose[k] || contacts[k] >= holding) return;
    loose[k] = true;
    waiting.push_back(k);
  };
  for (std::size_t k = 0; k < loose.size(); ++k) look_at(k);
  while (!waiting.empty()) {
    const std::size_t k = waiting.back();
    waiting.pop_back();
    for (std::size_t n = g.first[k]; n < g.first[k + 1]; ++n) {
      --contacts[g.neighbor[n]];
      look_at(g.neighbor[n]);
    }
  }
  return loose;
}

}  // namespace

std::vector<TouchingPair> touching_pairs(const dem::Dem& dem) {
  const auto& p = dem.particles();
  const auto id = [&](std::size_t k) { return p.properties[k].id; };
  std::vector<TouchingPair> pairs;
  for (std::size_t k = 0; k < dem.contacts().size(); ++k) {
    const auto key = dem.contacts().key(k);
    const auto i = static_cast<std::size_t>(key.i);
    const auto j = static_cast<std::size_t>(key.j);
    if (!p.is_own(i)) continue;  // a contact between two ranks is listed on both
    const Vec3& box = dem.contacts().box();
    const Vec3 shift{box.x * key.image[0], box.y * key.image[1], box.z * key.image[2]};
    const double distance = norm(p.motion[i].x - p.motion[j].x - shift);
    if (distance < p.radius(i) + p.radius(j)) pairs.push_back({id(i), id(j)});
  }
  for (std::size_t w = 0; w < dem.walls().size(); ++w) {
    for (const auto& contact : dem.wall_contacts()[w]) {
      const auto i = static_cast<std::size_t>(contact.bead);
      if (!p.is_own(i)) continue;
      if (dem::distance_to(dem.walls()[w], p.motion[i].x).distance < p.radius(i)) {
        pairs.push_back({id(i), wall_id});
      }
    }
  }
  return pairs;
}

Coordination coordination(std::span<const TouchingPair> pairs, std::int64_t beads, int holding) {
  const Graph g = make_graph(pairs);
  assert(beads >= static_cast<std::int64_t>(g.ids.size()));
  const auto loose = rattlers(g, holding);
  std::int64_t left = 0;
  std::int64_t contacts_left = 0;
  for (std::size_t k = 0; k < g.ids.size(); ++k) {
    if (loose[k]) continue;
    ++left;
    for (std::size_t n = g.first[k]; n < g.first[k + 1]; ++n) {
      contacts_left += loose[g.neighbor[n]] ? 0 : 1;
    }
  }
  Coordination c;
  c.rattlers = beads - left;
  if (beads > 0) c.mean = static_cast<double>(g.neighbor.size()) / static_cast<double>(beads);
  if (left > 0) {
    c.mean_without_rattlers = static_cast<double>(contacts_left) / static_cast<double>(left);
  }
  return c;
}

}  // namespace packbed::analysis
