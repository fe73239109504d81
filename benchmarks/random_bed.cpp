// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/random_bed.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "dem/neighbors.hpp"

namespace packbed::benchmarks {
namespace {

/// Moves every overlapping pair apart along its line, each by half; returns the largest overlap over
/// the sum of the radii.
double push_apart(const dem::Domain& domain, bool walls_in_x, double height, dem::Particles& p) {
  double worst = 0.0;
  for (const auto& pair : dem::find_pairs(p, domain, 0.0)) {
    const auto i = static_cast<std::size_t>(pair.i);
    const auto j = static_cast<std::size_t>(pair.j);
    const Vec3 d = p.motion[j].x + dem::offset(domain, pair.image) - p.motion[i].x;
    const double apart = p.radius(i) + p.radius(j);
    const double r = norm(d) + 1e-12;
    if (r >= apart) continue;
    worst = std::max(worst, (apart - r) / apart);
    const Vec3 move = (0.5 * (apart - r) / r) * d;
    p.motion[i].x -= move;
    p.motion[j].x += move;
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    Vec3& x = p.motion[i].x;
    const double r = p.radius(i);
    if (walls_in_x) x.x = std::clamp(x.x, r, domain.size[0] - r);
    x.z = std::clamp(x.z, r, height - r);
  }
  dem::wrap(p, domain);
  return worst;
}

}  // namespace

std::vector<double> coarse_grains(std::size_t count, std::uint64_t seed) {
  constexpr double coarse_grain = 3.0;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> size(86.9e-6, 16.6e-6);
  std::vector<double> diameters;
  while (diameters.size() < count) {
    const double d = size(random);
    if (d >= 49.7e-6 && d <= 142.7e-6) diameters.push_back(coarse_grain * d);
  }
  return diameters;
}

// The number of beads between d and d + dd falls as d^-4: d^-3 is uniform.
std::vector<double> wide_sizes(std::size_t count, double mean, double ratio, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double most = std::pow(mean / std::sqrt(ratio), -3.0);
  const double least = std::pow(mean * std::sqrt(ratio), -3.0);
  std::vector<double> diameters(count);
  for (double& d : diameters) d = 1.0 / std::cbrt(least + (most - least) * unit(random));
  return diameters;
}

Bed random_bed(const std::vector<double>& diameters,
               double width_x,
               double width_y,
               bool walls_in_x,
               std::uint64_t seed) {
  constexpr double solid_fraction = 0.58;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  double volume = 0.0;
  for (const double d : diameters) volume += std::numbers::pi / 6.0 * std::pow(d, 3);
  const double height = volume / (solid_fraction * width_x * width_y);
  Bed bed{.beads = {}, .width_x = width_x, .width_y = width_y, .walls_in_x = walls_in_x};
  for (const double d : diameters) {
    const double x = width_x * unit(random);
    const double y = width_y * unit(random);
    bed.beads.push_back(bead(bed.beads.size(), d, {x, y, height * unit(random)}));
  }
  const auto domain = domain_of(bed);
  auto particles = dem::make_particles(bed.beads, 1.0);
  for (int round = 0; round < 1500 && push_apart(domain, walls_in_x, height, particles) > 0.02;) {
    ++round;
  }
  for (std::size_t i = 0; i < bed.beads.size(); ++i) bed.beads[i].x = particles.motion[i].x;
  return bed;
}

}  // namespace packbed::benchmarks
