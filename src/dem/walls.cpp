// SPDX-License-Identifier: BSD-3-Clause
#include "dem/walls.hpp"

#include <algorithm>
#include <cmath>

namespace packbed::dem {
namespace {

WallDistance to(const Plane& plane, const Vec3& x) {
  return {.distance = dot(x - plane.point, plane.normal), .normal = plane.normal};
}

WallDistance to(const Disc& disc, const Vec3& x) {
  const Vec3 d = x - disc.center;
  const double height = dot(d, disc.normal);
  const Vec3 across = d - height * disc.normal;
  const double r = norm(across);
  if (r <= disc.radius) return {.distance = height, .normal = disc.normal};
  const Vec3 from_rim = d - (disc.radius / r) * across;
  const double distance = norm(from_rim);
  return {.distance = distance, .normal = (1.0 / distance) * from_rim};
}

WallDistance to(const Tube& tube, const Vec3& x) {
  const Vec3 across = x - dot(x, tube.axis) * tube.axis;
  const double r = norm(across);
  if (r == 0.0) return {.distance = tube.radius, .normal = {1.0, 0.0, 0.0}};  // far from the wall
  return {.distance = tube.radius - r, .normal = (-1.0 / r) * across};
}

}  // namespace

WallDistance distance_to(const Wall& wall, const Vec3& x) {
  return std::visit([&](const auto& surface) { return to(surface, x); }, wall.surface);
}

WallContacts find_wall_contacts(const Wall& wall,
                                const Particles& particles,
                                double skin,
                                const WallContacts& old,
                                const std::vector<std::int32_t>& place) {
  WallContacts known = old;
  for (auto& contact : known) contact.bead = place[static_cast<std::size_t>(contact.bead)];
  std::ranges::sort(known, {}, &WallContact::bead);
  WallContacts contacts;
  auto next = known.begin();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (!particles.is_own(i)) continue;
    const double gap = distance_to(wall, particles.motion[i].x).distance - particles.radius(i);
    if (gap >= skin) continue;
    WallContact contact;
    contact.bead = static_cast<std::int32_t>(i);
    contact.coefficients.a = -1.0;
    while (next != known.end() && next->bead < contact.bead) ++next;
    if (next != known.end() && next->bead == contact.bead) contact = *next;
    contacts.push_back(contact);
  }
  return contacts;
}

Kinematics wall_kinematics(const Wall& wall, const Motion& motion, const Spin& spin) {
  const double radius = 2.0 * spin.half_radius;
  const auto [distance, normal] = distance_to(wall, motion.x);
  return {.normal = normal,
          .overlap = radius - distance,
          .velocity = motion.v - wall.velocity,
          .surface = distance * spin.w,
          .spin = spin.w,
          .r_eff = radius};
}

}  // namespace packbed::dem
