// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Beads of the verification cases, and small set-ups of them.

#include <numbers>

#include "dem/dem.hpp"

namespace packbed::test {

/// Standard bead "S" of the verification cases: thesis tables 6.1, 8.4, B.1, B.2.
inline constexpr double diameter_s = 86.9e-6;
inline constexpr double density_s = 1140.0;
inline constexpr dem::Material material_s{.youngs_modulus = 30e6, .poisson_ratio = 0.2};
inline constexpr dem::Material plate{.youngs_modulus = 1e10, .poisson_ratio = 0.5};
inline constexpr double speed_s = 0.1;  ///< characteristic velocity

inline double mass_of(double diameter, double density) {
  return density * std::numbers::pi / 6.0 * diameter * diameter * diameter;
}

inline dem::BeadStart bead(std::int64_t id,
                           Vec3 x,
                           Vec3 v = {},
                           double diameter = diameter_s,
                           double density = density_s,
                           dem::Material material = material_s) {
  dem::BeadStart start;
  start.properties.id = id;
  start.properties.diameter = diameter;
  start.properties.mass = mass_of(diameter, density);
  start.properties.material = material;
  start.x = x;
  start.v = v;
  return start;
}

inline dem::BeadStart with_weight(dem::BeadStart start, double g) {
  start.properties.weight = start.properties.mass * g;
  return start;
}

inline dem::Hooke hooke(double restitution, bool tension = true) {
  return {.characteristic_velocity = speed_s, .restitution = restitution, .tension = tension};
}

inline dem::DemOptions options(dem::ContactLaw law,
                               double step,
                               double friction = 0.0,
                               dem::RollingLaw rolling = dem::NoRolling{}) {
  dem::DemOptions o;
  o.model = {.contact = law, .rolling = rolling, .friction = friction};
  o.step = step;
  return o;
}

inline dem::Wall floor_at(double z, double friction = 0.0, dem::Material material = plate) {
  return {.name = "floor",
          .surface = dem::Plane{.point = {0, 0, z}, .normal = {0, 0, 1}},
          .material = material,
          .velocity = {},
          .friction = friction};
}

/// Two beads on a line, about to touch, i coming with `speed` towards j which comes with the same.
inline std::vector<dem::BeadStart> head_on(double closing_speed,
                                           double d_i = diameter_s,
                                           double d_j = diameter_s) {
  const double apart = 0.5 * (d_i + d_j);
  return {bead(0, {apart, 0, 0}, {-0.5 * closing_speed, 0, 0}, d_i),
          bead(1, {0, 0, 0}, {0.5 * closing_speed, 0, 0}, d_j)};
}

/// Runs until two beads have touched and parted; returns separation speed / closing speed.
inline double restitution_of(dem::Dem& dem, std::int64_t most_steps = 10000000) {
  const auto start = dem.snapshot();
  bool touched = false;
  for (std::int64_t n = 0; n < most_steps; ++n) {
    dem.run(1);
    const bool touches = dem.snapshot().mean_overlap > 0.0;
    if (touched && !touches) break;
    touched = touched || touches;
  }
  const auto end = dem.snapshot();
  return norm(end.v[0] - end.v[1]) / norm(start.v[0] - start.v[1]);
}

}  // namespace packbed::test
