// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/tipping.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace packbed::column {
namespace {

constexpr double alone = 30.0;    // speed over the median of all
constexpr double straight = 0.9;  // cosine between the two velocities

double median_speed(const dem::Snapshot& s) {
  std::vector<double> speeds;
  speeds.reserve(s.v.size());
  for (const auto& v : s.v) speeds.push_back(norm(v));
  const auto middle = speeds.begin() + static_cast<std::ptrdiff_t>(speeds.size() / 2);
  std::ranges::nth_element(speeds, middle);
  return *middle;
}

/// Force along a direction, weight included.
double drive(const dem::Snapshot& s, std::size_t i, const Vec3& direction) {
  return dot(s.force[i], direction) - s.beads[i].weight * direction.z;
}

bool tips(const dem::Snapshot& before, const dem::Snapshot& now, std::size_t i) {
  const double speed = norm(now.v[i]);
  const double speed_before = norm(before.v[i]);
  if (speed <= speed_before || dot(now.v[i], before.v[i]) < straight * speed * speed_before)
    return false;
  const Vec3 direction = (1.0 / speed) * now.v[i];
  const double force_before = drive(before, i, direction);
  return force_before > 0.0 && drive(now, i, direction) > force_before;
}

}  // namespace

std::vector<dem::NewVelocity> tipping_beads(const dem::Snapshot& before,
                                            const dem::Snapshot& now,
                                            const TippingLimits& limits) {
  std::vector<dem::NewVelocity> pushed;
  if (now.v.empty()) return pushed;
  const double slowest = std::max(limits.slowest, alone * median_speed(now));
  for (std::size_t i = 0; i < now.v.size(); ++i) {
    const double speed = norm(now.v[i]);
    if (now.beads[i].fixed || speed < slowest || speed >= limits.speed || !tips(before, now, i))
      continue;
    pushed.push_back({.id = now.beads[i].id, .v = (limits.speed / speed) * now.v[i]});
  }
  return pushed;
}

std::int64_t push_tipping_beads(const dem::Snapshot& before,
                                const dem::Snapshot& now,
                                const TippingLimits& limits,
                                dem::Dem& dem) {
  const auto pushed = tipping_beads(before, now, limits);
  dem.set_velocities(pushed);
  std::array<std::int64_t, 1> count = {static_cast<std::int64_t>(pushed.size())};
  dem.ranks().sum(count);
  return count[0];
}

}  // namespace packbed::column
