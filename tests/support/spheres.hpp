// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Lattices and clouds of spheres to analyze.

#include <vector>

#include "analysis/bead.hpp"
#include "core/random.hpp"

namespace packbed::test {

/// Numbers of (0, 1), each new.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : seed_(seed) {}
  double operator()() { return uniform(seed_, Stream::bead_position, next_++); }
  double operator()(double low, double high) { return low + (high - low) * (*this)(); }

 private:
  std::uint64_t seed_;
  std::uint64_t next_ = 0;
};

/// Simple cubic lattice of touching spheres from `corner` on, nx x ny x nz of them.
inline std::vector<analysis::Bead> cubic(
    double diameter, int nx, int ny, int nz, const Vec3& corner = {0, 0, 0}) {
  std::vector<analysis::Bead> beads;
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        const Vec3 x = corner + diameter * Vec3{i + 0.5, j + 0.5, k + 0.5};
        beads.push_back({x, 0.5 * diameter, static_cast<std::int64_t>(beads.size())});
      }
    }
  }
  return beads;
}

/// Spheres of 0.2 to 0.4 mm with centers anywhere between two corners; they overlap.
inline std::vector<analysis::Bead> cloud(int count,
                                         const Vec3& low,
                                         const Vec3& high,
                                         std::uint64_t seed) {
  Draws draw(seed);
  std::vector<analysis::Bead> beads;
  for (int k = 0; k < count; ++k) {
    const Vec3 x{draw(low.x, high.x), draw(low.y, high.y), draw(low.z, high.z)};
    beads.push_back({x, draw(0.1e-3, 0.2e-3), k});
  }
  return beads;
}

inline double total_volume(const std::vector<analysis::Bead>& beads) {
  double sum = 0.0;
  for (const auto& b : beads)
    sum += 4.0 / 3.0 * 3.14159265358979323846 * b.radius * b.radius * b.radius;
  return sum;
}

}  // namespace packbed::test
