// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/beds.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>
#include <stdexcept>

namespace packbed::benchmarks {
namespace {

constexpr double density = 1140.0;    // [kg/m3]
constexpr double body_force = 457.2;  // [m/s2]
constexpr dem::Material resin{.youngs_modulus = 30e6, .poisson_ratio = 0.2};
constexpr dem::Material steel{.youngs_modulus = 1e10, .poisson_ratio = 0.49};

dem::BeadStart bead(std::size_t id, double diameter, const Vec3& x) {
  const double mass = density * std::numbers::pi / 6.0 * diameter * diameter * diameter;
  return {.properties = {.id = static_cast<std::int64_t>(id),
                         .diameter = diameter,
                         .mass = mass,
                         .weight = body_force * mass,
                         .material = resin},
          .x = x,
          .v = {},
          .w = {}};
}

/// Box of cells as wide as the largest bead, periodic in x and y.
struct Cells {
  double lx, ly, lz;
  int nx, ny, nz;
  std::vector<std::vector<std::size_t>> beads;

  Cells(double x, double y, double z, double width)
      : lx(x),
        ly(y),
        lz(z),
        nx(std::max(3, static_cast<int>(x / width))),
        ny(std::max(3, static_cast<int>(y / width))),
        nz(std::max(1, static_cast<int>(z / width))),
        beads(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) *
              static_cast<std::size_t>(nz)) {}

  [[nodiscard]] static int cell(double a, double length, int n) {
    return std::clamp(static_cast<int>(a / length * n), 0, n - 1);
  }
  std::vector<std::size_t>& at(int x, int y, int z) {
    return beads[static_cast<std::size_t>((z * ny + (y + ny) % ny) * nx + (x + nx) % nx)];
  }
};

// Moves every overlapping pair apart along its line, each by half; returns the largest overlap over
// the sum of the radii.
double push_apart(const std::vector<double>& radius, std::vector<Vec3>& x, Cells& cells) {
  for (auto& list : cells.beads) list.clear();
  const auto home = [&](const Vec3& a) {
    return std::array{Cells::cell(a.x, cells.lx, cells.nx), Cells::cell(a.y, cells.ly, cells.ny),
                      Cells::cell(a.z, cells.lz, cells.nz)};
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto [a, b, c] = home(x[i]);
    cells.at(a, b, c).push_back(i);
  }
  double worst = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto [a, b, c] = home(x[i]);
    for (int cz = std::max(0, c - 1); cz <= std::min(cells.nz - 1, c + 1); ++cz) {
      for (int near = 0; near < 9; ++near) {
        for (const std::size_t j : cells.at(a + near % 3 - 1, b + near / 3 - 1, cz)) {
          if (j <= i) continue;
          Vec3 d = x[j] - x[i];
          d.x -= cells.lx * std::round(d.x / cells.lx);
          d.y -= cells.ly * std::round(d.y / cells.ly);
          const double apart = radius[i] + radius[j];
          const double r = norm(d) + 1e-12;
          if (r >= apart) continue;
          worst = std::max(worst, (apart - r) / apart);
          const Vec3 move = (0.5 * (apart - r) / r) * d;
          x[i] -= move;
          x[j] += move;
        }
      }
    }
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i].x -= cells.lx * std::floor(x[i].x / cells.lx);
    x[i].y -= cells.ly * std::floor(x[i].y / cells.ly);
    x[i].z = std::clamp(x[i].z, radius[i], cells.lz - radius[i]);
  }
  return worst;
}

Bed random_bed(std::size_t count, double width, std::uint64_t seed) {
  constexpr double solid_fraction = 0.58;
  constexpr double coarse_grain = 3.0;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> size(86.9e-6, 16.6e-6);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<double> radius;
  double volume = 0.0;
  while (radius.size() < count) {
    const double d = size(random);
    if (d < 49.7e-6 || d > 142.7e-6) continue;
    radius.push_back(0.5 * coarse_grain * d);
    volume += 4.0 / 3.0 * std::numbers::pi * std::pow(radius.back(), 3);
  }
  const double height = volume / (solid_fraction * width * width);
  std::vector<Vec3> x;
  while (x.size() < count) {
    const double a = width * unit(random);
    const double b = width * unit(random);
    x.push_back({a, b, height * unit(random)});
  }
  Cells cells(width, width, height, 2.0 * std::ranges::max(radius));
  for (int round = 0; round < 1500 && push_apart(radius, x, cells) > 0.02;) ++round;
  Bed bed{.beads = {}, .width_x = width, .width_y = width};
  for (std::size_t i = 0; i < count; ++i) bed.beads.push_back(bead(i, 2.0 * radius[i], x[i]));
  return bed;
}

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

// A LAMMPS data file of atom style sphere: "id type diameter density x y z" after "Atoms".
Bed read_bed(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file);
  Bed bed;
  bool atoms = false;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    double low = 0.0;
    double high = 0.0;
    if (line.find("xlo") != std::string::npos && words >> low >> high) bed.width_x = high - low;
    if (line.find("ylo") != std::string::npos && words >> low >> high) bed.width_y = high - low;
    if (line.starts_with("Atoms")) atoms = true;
    std::size_t id = 0;
    int type = 0;
    double d = 0.0;
    double rho = 0.0;
    Vec3 x;
    if (atoms && words >> id >> type >> d >> rho >> x.x >> x.y >> x.z) {
      bed.beads.push_back(bead(bed.beads.size(), d, x));
    }
  }
  return bed;
}

}  // namespace

Bed packed_bed(const std::string& name) {
  if (name == "b1m") return tiled(packed_bed("b18k"), 7, 8);
  if (const char* folder = std::getenv("PACKBED_BEDS")) {
    return read_bed(std::string(folder) + "/" + name + ".data");
  }
  if (name == "b2k") return settled(random_bed(2200, 1.5e-3, 1));
  if (name == "b18k") return settled(random_bed(18300, 4.5e-3, 2));
  throw std::runtime_error("no bed called " + name);
}

dem::Dem make_dem(const Bed& bed, double step) {
  dem::DemOptions options;
  options.domain = {
      .low = {}, .size = {bed.width_x, bed.width_y, 1.0}, .periodic = {true, true, false}};
  options.model = {.contact = dem::Hooke{.characteristic_velocity = 0.1, .restitution = 0.5},
                   .rolling = dem::ElasticPlastic{0.35},
                   .friction = 0.1};
  options.step = step;
  options.background_damping = 1e4;
  dem::Wall floor{.name = "floor",
                  .surface = dem::Plane{.point = {}, .normal = {0.0, 0.0, 1.0}},
                  .material = steel,
                  .velocity = {},
                  .friction = 0.1};
  return {options, bed.beads, {floor}};
}

}  // namespace packbed::benchmarks
