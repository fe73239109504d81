// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/rearrangement.hpp"

#include <cassert>
#include <cmath>
#include <iterator>
#include <utility>

#include "analysis/by_id.hpp"

namespace packbed::analysis {
namespace {

double shortest(double distance, double period) {
  return period > 0.0 ? distance - period * std::round(distance / period) : distance;
}

/// A height and how far the bed moved there.
struct Knot {
  double z = 0.0;
  double moved = 0.0;
  double count = 0.0;
};

/// Means of slabs of equal thickness, from below; those without beads left out.
std::vector<Knot> slab_means(std::span<const MovedBead> beads, int slabs) {
  const auto [low, high] = std::ranges::minmax(beads, {}, [](const MovedBead& b) { return b.x.z; });
  const double thickness = (high.x.z - low.x.z) / slabs;
  std::vector<Knot> knots(static_cast<std::size_t>(slabs));
  for (const auto& bead : beads) {
    const double slab = thickness > 0.0 ? (bead.x.z - low.x.z) / thickness : 0.0;
    auto& knot = knots[std::min(static_cast<std::size_t>(slab), knots.size() - 1)];
    knot.z += bead.x.z;
    knot.moved += bead.moved.z;
    knot.count += 1.0;
  }
  std::erase_if(knots, [](const Knot& k) { return k.count == 0.0; });
  for (auto& knot : knots) {
    knot.z /= knot.count;
    knot.moved /= knot.count;
  }
  return knots;
}

/// Straight between two knots; the first and the last piece go on outwards.
double moved_at(std::span<const Knot> knots, double z) {
  if (knots.size() == 1) return knots.front().moved;
  const auto above = std::ranges::upper_bound(knots, z, {}, &Knot::z) - knots.begin();
  const auto k =
      static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above, 1, std::ssize(knots) - 1));
  const auto& a = knots[k - 1];
  const auto& b = knots[k];
  return a.moved + (b.moved - a.moved) * (z - a.z) / (b.z - a.z);
}

using Ids = std::pair<std::int64_t, std::int64_t>;

std::vector<Ids> sorted_pairs(std::span<const TouchingPair> pairs) {
  std::vector<Ids> ids;
  for (const auto& p : pairs) {
    if (p.j != wall_id) ids.emplace_back(std::minmax(p.i, p.j));
  }
  std::ranges::sort(ids);
  return ids;
}

}  // namespace

Displacements displacements(std::span<const Bead> before,
                            std::span<const Bead> after,
                            const Vec3& period) {
  const auto first = sorted_by_id(before);
  const auto second = sorted_by_id(after);
  Displacements d;
  for (const auto& bead : first) {
    const auto place = place_of<Bead>(second, bead.id);
    if (place == second.size()) {
      ++d.gone;
      continue;
    }
    const Vec3 moved = second[place].x - bead.x;
    d.beads.push_back({.id = bead.id,
                       .x = bead.x,
                       .moved = {shortest(moved.x, period.x), shortest(moved.y, period.y),
                                 shortest(moved.z, period.z)}});
  }
  d.come = std::ssize(second) - std::ssize(d.beads);
  return d;
}

Wandering wandering(const Displacements& displacements, int slabs) {
  assert(slabs >= 1);
  Wandering w{.beads = displacements.beads};
  if (w.beads.empty()) return w;
  const auto knots = slab_means(displacements.beads, slabs);
  for (auto& bead : w.beads) {
    bead.moved.z -= moved_at(knots, bead.x.z);
    w.lateral += bead.moved.x * bead.moved.x + bead.moved.y * bead.moved.y;
    w.vertical += bead.moved.z * bead.moved.z;
  }
  const auto n = static_cast<double>(w.beads.size());
  w.lateral = std::sqrt(w.lateral / n);
  w.vertical = std::sqrt(w.vertical / n);
  return w;
}

ContactChanges contact_changes(std::span<const TouchingPair> before,
                               std::span<const TouchingPair> after) {
  const auto first = sorted_pairs(before);
  const auto second = sorted_pairs(after);
  std::vector<Ids> lost;
  std::ranges::set_difference(first, second, std::back_inserter(lost));
  ContactChanges c{
      .before = std::ssize(first), .after = std::ssize(second), .lost = std::ssize(lost)};
  c.made = c.after - (c.before - c.lost);
  const auto share = [](std::int64_t part, std::int64_t of) {
    return of > 0 ? static_cast<double>(part) / static_cast<double>(of) : 0.0;
  };
  c.lost_share = share(c.lost, c.before);
  c.made_share = share(c.made, c.after);
  return c;
}

}  // namespace packbed::analysis
