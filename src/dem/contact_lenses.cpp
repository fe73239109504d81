// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "dem/dem.hpp"

namespace packbed::dem {
namespace {

/// Part of a bead beyond a plane.
struct Cap {
  std::size_t bead = 0;     ///< place
  Vec3 direction;           ///< unit vector from the center to the plane
  double half_angle = 0.0;  ///< as seen from the center
};

double volume(double radius, double height) {
  return std::numbers::pi / 3.0 * height * height * (3.0 * radius - height);
}

/// Calls visit(bead, direction, height) for the cap that each contact cuts off each own bead.
template <class Visit>
void for_each_cap(const Dem& dem, Visit visit) {
  const auto& p = dem.particles();
  const auto& contacts = dem.contacts();
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto c = contacts.key(k);
    const auto i = static_cast<std::size_t>(c.i);
    const auto j = static_cast<std::size_t>(c.j);
    const Vec3 d = p.motion[j].x + offset(dem.options().domain, c.image) - p.motion[i].x;
    const double r = norm(d);
    const double r_i = p.radius(i);
    const double r_j = p.radius(j);
    if (r >= r_i + r_j) continue;
    // The plane in which the surfaces meet, from the center of i.
    const double plane = 0.5 * (r + (r_i - r_j) * (r_i + r_j) / r);
    const Vec3 n = (1.0 / r) * d;
    if (p.is_own(i)) visit(i, n, r_i - plane);
    if (p.is_own(j)) visit(j, -n, r_j - (r - plane));
  }
  for (std::size_t w = 0; w < dem.walls().size(); ++w) {
    for (const auto& c : dem.wall_contacts()[w]) {
      const auto i = static_cast<std::size_t>(c.bead);
      const auto contact = wall_kinematics(dem.walls()[w], p.motion[i], p.spin[i]);
      if (contact.overlap > 0.0 && p.is_own(i)) visit(i, -contact.normal, contact.overlap);
    }
  }
}

}  // namespace

std::vector<double> Dem::lens_volumes() const {
  std::vector<double> lost(particles_.size());
  for_each_cap(*this, [&](std::size_t i, const Vec3&, double height) {
    lost[i] += volume(particles_.radius(i), height);
  });
  return lost;
}

std::int64_t Dem::meeting_lenses() const {
  std::vector<Cap> caps;
  for_each_cap(*this, [&](std::size_t i, const Vec3& direction, double height) {
    caps.push_back({i, direction, std::acos(1.0 - height / particles_.radius(i))});
  });
  std::ranges::stable_sort(caps, {}, &Cap::bead);
  std::array<std::int64_t, 1> meeting = {0};
  for (auto a = caps.begin(); a != caps.end(); ++a) {
    for (auto b = a + 1; b != caps.end() && b->bead == a->bead; ++b) {
      const double between = std::acos(std::clamp(dot(a->direction, b->direction), -1.0, 1.0));
      if (between < a->half_angle + b->half_angle) ++meeting[0];
    }
  }
  ranks_.sum(meeting);
  return meeting[0];
}

}  // namespace packbed::dem
