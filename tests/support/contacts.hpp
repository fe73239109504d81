// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Contacts made by hand.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "analysis/contact_force.hpp"
#include "tests/support/spheres.hpp"

namespace packbed::test {

/// Two beads that push with a force.
inline analysis::ContactForce contact(
    std::int64_t i, std::int64_t j, const Vec3& branch, double force, const Vec3& x = {}) {
  return {.i = i, .j = j, .x = x, .branch = branch, .normal = force};
}

/// Of all pairs that overlap: F = stiffness times overlap.
inline std::vector<analysis::ContactForce> contacts_of(const std::vector<analysis::Bead>& beads,
                                                       double stiffness = 1.0) {
  std::vector<analysis::ContactForce> all;
  for (std::size_t i = 0; i < beads.size(); ++i) {
    for (std::size_t j = i + 1; j < beads.size(); ++j) {
      const Vec3 branch = beads[j].x - beads[i].x;
      const double overlap = beads[i].radius + beads[j].radius - norm(branch);
      if (overlap <= 0.0) continue;
      auto c = contact(beads[i].id, beads[j].id, branch, stiffness * overlap, beads[i].x);
      c.overlap = overlap;
      all.push_back(c);
    }
  }
  return all;
}

/// The same contact told from its other bead.
inline analysis::ContactForce turned(const analysis::ContactForce& c) {
  auto t = c;
  std::swap(t.i, t.j);
  t.x = c.x + c.branch;
  t.branch = -c.branch;
  return t;
}

/// The same contacts in another order, every second one told from its other bead (walls have none).
inline std::vector<analysis::ContactForce> shuffled(std::vector<analysis::ContactForce> contacts) {
  std::ranges::reverse(contacts);
  std::rotate(contacts.begin(), contacts.begin() + std::ssize(contacts) / 3, contacts.end());
  for (std::size_t k = 0; k < contacts.size(); k += 2) {
    if (!contacts[k].with_wall()) contacts[k] = turned(contacts[k]);
  }
  return contacts;
}

/// `count` contacts with directions spread evenly over the sphere and the forces F(u) for even u in (0, 1).
template <class Force>
std::vector<analysis::ContactForce> even_contacts(int count, const Force& force) {
  std::vector<analysis::ContactForce> all;
  for (int k = 0; k < count; ++k) {
    const double z = 2.0 * (k + 0.5) / count - 1.0;
    const double angle = 2.0 * std::numbers::pi * std::numbers::phi * k;
    const double r = std::sqrt(1.0 - z * z);
    const double u = std::fmod(0.5 / count + std::numbers::sqrt2 * k, 1.0);
    all.push_back(contact(k, k + 1, {r * std::cos(angle), r * std::sin(angle), z}, force(u)));
  }
  return all;
}

}  // namespace packbed::test
