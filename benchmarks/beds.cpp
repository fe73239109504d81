// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/beds.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <stdexcept>

#include "benchmarks/bed_file.hpp"
#include "benchmarks/random_bed.hpp"

namespace packbed::benchmarks {
namespace {

constexpr double density = 1140.0;    // [kg/m3]
constexpr double body_force = 457.2;  // [m/s2]
constexpr dem::Material resin{.youngs_modulus = 30e6, .poisson_ratio = 0.2};
constexpr dem::Material steel{.youngs_modulus = 1e10, .poisson_ratio = 0.49};

Bed settled(const Bed& bed) {
  auto dem = make_dem(bed, 1e-6);
  double before = 0.0;
  for (int look = 0; look < 30; ++look) {
    dem.run(1000);
    const double pairs = 0.5 * dem.snapshot().coordination_number;
    if (pairs > 2.8 && std::abs(pairs - before) < 0.002) break;
    before = pairs;
  }
  const auto s = dem.snapshot();
  Bed now = bed;  // ids are places
  for (std::size_t i = 0; i < now.beads.size(); ++i) now.beads[i].x = s.x[i];
  return now;
}

Bed tiled(const Bed& bed, int across, int along) {
  Bed big{.beads = {}, .width_x = across * bed.width_x, .width_y = along * bed.width_y};
  for (int t = 0; t < across * along; ++t) {
    const Vec3 shift{t % across * bed.width_x, t / across * bed.width_y, 0.0};
    for (const auto& b : bed.beads) {
      auto copy = b;
      copy.properties.id = static_cast<std::int64_t>(big.beads.size());
      copy.x += shift;
      big.beads.push_back(copy);
    }
  }
  return big;
}

/// A bed by its recipe.
Bed generated(const std::string& name) {
  if (name == "b2k") return settled(random_bed(coarse_grains(2200, 1), 1.5e-3, 1.5e-3, false, 1));
  if (name == "b18k") return settled(random_bed(coarse_grains(18300, 2), 4.5e-3, 4.5e-3, false, 2));
  if (name == "s18k") return settled(random_bed(coarse_grains(18300, 3), 10e-3, 0.8e-3, true, 3));
  if (name == "equal20k") {
    return settled(random_bed(std::vector(20000, 260e-6), 4.5e-3, 4.5e-3, false, 4));
  }
  if (name == "wide20k") {
    return settled(random_bed(wide_sizes(20000, 474e-6, 10.0, 5), 5e-3, 5e-3, false, 5));
  }
  throw std::runtime_error("no bed called " + name +
                           "; there are b2k, b18k, s18k, b223k, b1m, equal20k and wide20k");
}

}  // namespace

dem::BeadStart bead(std::size_t id, double diameter, const Vec3& x) {
  const double mass = density * std::numbers::pi / 6.0 * diameter * diameter * diameter;
  return {.properties = {.id = static_cast<std::int64_t>(id),
                         .diameter = diameter,
                         .density = density,
                         .mass = mass,
                         .weight = body_force * mass,
                         .material = resin},
          .x = x,
          .v = {},
          .w = {}};
}

Bed packed_bed(const std::string& name) {
  if (name == "b223k") return tiled(packed_bed("b18k"), 3, 4);
  if (name == "b1m") return tiled(packed_bed("b18k"), 7, 8);
  const char* folder = std::getenv("PACKBED_BEDS");
  if (folder == nullptr) return generated(name);
  const auto file = std::filesystem::path(folder) / (name + ".data");
  if (!std::filesystem::exists(file)) write_bed(file.string(), generated(name));
  return read_bed(file.string());
}

dem::Domain domain_of(const Bed& bed) {
  return {.low = {},
          .size = {bed.width_x, bed.width_y, 1.0},
          .periodic = {!bed.walls_in_x, true, false}};
}

dem::Dem make_dem(const Bed& bed, double step, const Ranks& ranks) {
  dem::DemOptions options;
  options.domain = domain_of(bed);
  options.model = {.contact = dem::Hooke{.characteristic_velocity = 0.1, .restitution = 0.5},
                   .rolling = dem::ElasticPlastic{0.35},
                   .friction = 0.1};
  options.step = step;
  options.background_damping = 1e4;
  const auto plane = [](const char* at, const Vec3& point, const Vec3& normal) {
    return dem::Wall{.name = at,
                     .surface = dem::Plane{.point = point, .normal = normal},
                     .material = steel,
                     .velocity = {},
                     .friction = 0.1};
  };
  std::vector<dem::Wall> walls = {plane("floor", {}, {0.0, 0.0, 1.0})};
  if (bed.walls_in_x) {
    walls.push_back(plane("x_low", {}, {1.0, 0.0, 0.0}));
    walls.push_back(plane("x_high", {bed.width_x, 0.0, 0.0}, {-1.0, 0.0, 0.0}));
  }
  return {options, bed.beads, walls, ranks};
}

}  // namespace packbed::benchmarks
