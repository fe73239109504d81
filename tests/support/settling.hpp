// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Small clouds of soft beads that settle in a second.

#include "column/protocol/settle.hpp"
#include "core/random.hpp"
#include "dem/cloud.hpp"
#include "dem/step_choice.hpp"
#include "tests/support/beads.hpp"

namespace packbed::test {

/// A thousandth of the modulus of a resin: thirty times the step. Enough for the weight of a small bed.
inline constexpr dem::Material soft{.youngs_modulus = 0.03e6, .poisson_ratio = 0.2};
/// A hundredth, for beds that bear a flow or a force.
inline constexpr dem::Material firm{.youngs_modulus = 0.3e6, .poisson_ratio = 0.2};

/// Grains of 200 to 320 um.
inline dem::BeadProperties grain(std::int64_t id, const dem::Material& material = soft) {
  const double u = uniform(5, Stream::bead_size, static_cast<std::uint64_t>(id));
  const double diameter = 200e-6 + 120e-6 * u;
  return {.id = id,
          .diameter = diameter,
          .density = density_s,
          .mass = mass_of(diameter, density_s),
          .weight = 0.0,
          .material = material,
          .fixed = false};
}

struct Settling {
  dem::Dem dem;
  column::SettleOptions options;
  column::SettleState start;
};

/// `count` grains as a cloud in a slice of 2 mm x 0.7 mm, with a floor, walls and a lid out of the way.
inline Settling cloud_of(std::int64_t count,
                         double friction = 0.1,
                         const Ranks& ranks = Ranks::alone(),
                         const dem::Material& material = soft) {
  const mesh::Slice slice{.inner_diameter = 2e-3, .depth = 0.7e-3, .height = 0.1};
  std::vector<dem::BeadStart> beads;
  std::vector<double> diameters;
  std::vector<dem::BeadProperties> properties;
  for (std::int64_t id = 0; id < count; ++id) {
    properties.push_back(grain(id, material));
    diameters.push_back(properties.back().diameter);
  }
  const auto cloud = dem::make_cloud({.shape = slice, .seed = 1}, diameters);
  for (std::size_t k = 0; k < cloud.x.size(); ++k) {
    beads.push_back({.properties = properties[k], .x = cloud.x[k], .v = {}, .w = {}});
  }
  const auto law = hooke(0.5, false);
  auto o = options(law, 1e-6, friction, dem::ElasticPlastic{0.35});
  o.domain = {
      .low = {-1e-3, -0.35e-3, 0.0}, .size = {2e-3, 0.7e-3, 0.1}, .periodic = {false, true, false}};
  const auto wall = [&](const char* name, const Vec3& point, const Vec3& normal) {
    return dem::Wall{.name = name,
                     .surface = dem::Plane{.point = point, .normal = normal},
                     .material = plate,
                     .velocity = {},
                     .friction = 0.1};
  };
  const std::vector<dem::Wall> walls = {floor_at(0.0, 0.1), wall("x_low", {-1e-3, 0, 0}, {1, 0, 0}),
                                        wall("x_high", {1e-3, 0, 0}, {-1, 0, 0}),
                                        wall("lid", {0, 0, column::lid_away}, {0, 0, -1})};
  const auto choice = dem::choose_step(law, properties, {plate}, 1.0);
  o.step = choice.step;

  column::SettleOptions settle;
  settle.shape = slice;
  settle.liquid_density = 998.0;
  settle.resin_friction = friction;
  settle.resin_rolling_friction = 0.35;
  settle.bead = [material](std::int64_t id) { return grain(id, material); };
  settle.stepping.longest_step = choice.contact_time / dem::fewest_steps_per_contact;
  settle.slice = 200;
  column::SettleState start;
  start.next_id = count;
  return {dem::Dem(o, beads, walls, ranks), settle, start};
}

}  // namespace packbed::test
