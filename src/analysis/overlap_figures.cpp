// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/overlap_figures.hpp"

#include <cmath>
#include <tuple>

#include "analysis/by_id.hpp"
#include "analysis/overlap.hpp"

namespace packbed::analysis {
namespace {

/// The part of a bead beyond a plane across a contact: outward normal, height of the plane over the center.
struct Cap {
  Vec3 normal;
  double height = 0.0;  ///< [m]; < 0 where the cap is more than half of the bead
};

double half_angle(const Cap& cap, double radius) {
  return std::acos(std::clamp(cap.height / radius, -1.0, 1.0));
}

bool meet(const Cap& a, const Cap& b, double radius) {
  const double angle = std::atan2(norm(cross(a.normal, b.normal)), dot(a.normal, b.normal));
  return angle < half_angle(a, radius) + half_angle(b, radius);
}

bool any_meet(std::span<const Cap> caps, double radius) {
  for (std::size_t a = 0; a < caps.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (meet(caps[a], caps[b], radius)) return true;
    }
  }
  return false;
}

/// Height of the plane of the common circle over the center of the sphere of radius r.
double plane_height(double r, double other, double distance) {
  return distance > 0.0 ? 0.5 * (distance + (r - other) * (r + other) / distance) : 0.0;
}

std::size_t place_or_throw(std::span<const Bead> beads, std::int64_t id) {
  const auto place = place_of(beads, id);
  if (place == beads.size()) {
    throw ValueError(fmt::format(
        "a contact names bead {}, which is not there; give beads and contacts of the same time",
        id));
  }
  return place;
}

using Caps = std::vector<std::vector<Cap>>;

/// Of each bead.
Caps caps_of(std::span<const Bead> beads, std::span<const ContactForce> contacts) {
  Caps caps(beads.size());
  for (const auto& c : contacts) {
    const Vec3 n = contact_normal(c);
    const double distance = norm(c.branch);
    const auto i = place_or_throw(beads, c.i);
    if (c.with_wall()) {
      caps[i].push_back({n, distance});
      continue;
    }
    const auto j = place_or_throw(beads, c.j);
    const double r_i = beads[i].radius;
    const double r_j = beads[j].radius;
    caps[i].push_back({n, plane_height(r_i, r_j, distance)});
    caps[j].push_back({-n, plane_height(r_j, r_i, distance)});
  }
  return caps;
}

void add_contact(BeadOverlap& bead, double overlap) {
  const double part = overlap / bead.diameter;
  ++bead.contacts;
  bead.sum += part;
  bead.largest = std::max(bead.largest, part);
}

}  // namespace

std::vector<BeadOverlap> bead_overlaps(std::span<const Bead> beads,
                                       std::span<const ContactForce> contacts) {
  const auto sorted = sorted_by_id(beads);
  const auto caps = caps_of(sorted, contacts);
  std::vector<BeadOverlap> all;
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const auto& bead = sorted[k];
    BeadOverlap o{.id = bead.id, .x = bead.x, .diameter = 2.0 * bead.radius};
    for (const auto& cap : caps[k]) {
      o.capped += volume_below(bead.radius, -cap.height) / sphere_volume(bead.radius);
    }
    o.caps_meet = any_meet(caps[k], bead.radius);
    all.push_back(o);
  }
  for (const auto& c : contacts) {
    add_contact(all[place_of<Bead>(sorted, c.i)], c.overlap);
    if (!c.with_wall()) add_contact(all[place_of<Bead>(sorted, c.j)], c.overlap);
  }
  return all;
}

std::vector<BeadOverlap> most_overlapped(std::span<const BeadOverlap> beads, std::size_t count) {
  std::vector<BeadOverlap> sorted(beads.begin(), beads.end());
  std::ranges::sort(sorted, {}, [](const BeadOverlap& b) { return std::tuple(-b.largest, b.id); });
  sorted.resize(std::min(count, sorted.size()));
  return sorted;
}

OverlapFigures overlap_figures(std::span<const Bead> beads,
                               std::span<const ContactForce> contacts,
                               double capped_limit) {
  const auto each = bead_overlaps(beads, contacts);
  OverlapFigures f{.contacts = std::ssize(contacts)};
  for (const auto& c : contacts) {
    double diameter = each[place_of<BeadOverlap>(each, c.i)].diameter;
    if (!c.with_wall()) {
      diameter = std::min(diameter, each[place_of<BeadOverlap>(each, c.j)].diameter);
    }
    const double part = c.overlap / diameter;
    f.mean += part;
    f.largest = std::max(f.largest, part);
    f.large_share += part > large_overlap ? 1.0 : 0.0;
    f.very_large_share += part > very_large_overlap ? 1.0 : 0.0;
  }
  for (const auto& bead : each) {
    f.caps_meet += bead.caps_meet ? 1 : 0;
    f.capped_share += bead.capped > capped_limit ? 1.0 : 0.0;
  }
  if (!contacts.empty()) {
    const auto n = static_cast<double>(contacts.size());
    f.mean /= n;
    f.large_share /= n;
    f.very_large_share /= n;
  }
  if (!each.empty()) f.capped_share /= static_cast<double>(each.size());
  return f;
}

}  // namespace packbed::analysis
