// SPDX-License-Identifier: BSD-3-Clause
// The same bits on any number of ranks. Run under mpiexec; every rank also analyzes the bed alone.
#include <cstdio>
#include <cstring>
#include <vector>

#include "analysis/bed_height.hpp"
#include "analysis/profile.hpp"
#include "analysis/sections.hpp"
#include "tests/support/spheres.hpp"

namespace packbed::analysis {
namespace {

constexpr double depth = 0.9e-3;

/// All that is worked out of some beads.
std::vector<double> figures(const std::vector<Bead>& beads, const Ranks& ranks) {
  const mesh::Slice slice{.inner_diameter = 3e-3, .depth = depth, .height = 8e-3};
  const mesh::Cylinder cylinder{.inner_diameter = 3e-3, .height = 8e-3};
  const auto bed = bed_figures(beads, 3e-3 * depth, ranks);
  std::vector<double> all = {bed.height, bed.mean_porosity, bed.middle_porosity};
  const auto take = [&](const std::vector<double>& v) {
    all.insert(all.end(), v.begin(), v.end());
  };
  const ProfileBins bins{0.1e-3, middle_half(bed.height)};
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    take(bed_profile(beads, slice, axis, bins, ranks).solid);
    take(plane_porosities(beads, slice, axis, std::vector<double>{1e-4, 2e-4}, bins.z, ranks));
  }
  take(wall_profile(beads, cylinder, bins, ranks).solid);
  const auto reference = section_reference(beads, bed.height, {.count = 5}, ranks);
  auto moved = beads;
  for (auto& b : moved) b.x.z -= 10.0 * b.x.z * b.x.z;
  for (const auto& s : sections(reference, moved, 0.9 * bed.height, 3e-3 * depth, ranks)) {
    take({s.z_top, s.z_bottom, s.compression, s.packing_density});
  }
  return all;
}

int compare(const Ranks& ranks) {
  const auto beads =
      packbed::test::cloud(600, {-1.5e-3, -0.5 * depth, 0}, {1.5e-3, 0.5 * depth, 7e-3}, 29);
  std::vector<Bead> own;
  for (const auto& b : beads) {
    if ((b.id * b.id / 3) % ranks.size() == ranks.rank()) own.push_back(b);
  }
  const auto together = figures(own, ranks);
  const auto alone = figures(beads, Ranks::alone());
  if (together.size() == alone.size() &&
      std::memcmp(together.data(), alone.data(), alone.size() * sizeof(double)) == 0) {
    return 0;
  }
  std::fprintf(stderr, "rank %d of %d: the figures differ from those of one rank\n", ranks.rank(),
               ranks.size());
  return 1;
}

}  // namespace
}  // namespace packbed::analysis

int main() {
  const packbed::MpiSession session;
  return packbed::analysis::compare(packbed::Ranks::all());
}
