// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/overlap.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/spheres.hpp"

namespace packbed::analysis {
namespace {

using namespace packbed::test;  // NOLINT
using mesh::Boundary;

constexpr double d = 0.3e-3;
const auto alone = Ranks::alone();
const Range all_z{-1.0, 1.0};

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

mesh::Box box(double x, double y, double z, Boundary sides) {
  return {.size = {x, y, z}, .boundaries = {sides, sides, Boundary::wall}};
}

// P8: a plane at distance h from the centers of a cubic lattice cuts discs of pi (R^2 - h^2).
TEST(PlanePorosity, OfALatticeIsThatOfItsDiscs) {
  const auto beads = cubic(d, 3, 4, 6);
  const auto shape = box(3 * d, 4 * d, 6 * d, Boundary::periodic);
  const double r = 0.5 * d;
  std::vector<double> planes;
  for (const double u : {0.01, 0.1, 0.25, 0.5, 0.77}) planes.push_back((1.0 + u) * d);

  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    const auto eps = plane_porosities(beads, shape, axis, planes, {0.0, 6 * d}, alone);
    for (std::size_t k = 0; k < planes.size(); ++k) {
      const double h = planes[k] - 1.5 * d;
      EXPECT_NEAR(eps[k], 1.0 - std::numbers::pi * (r * r - h * h) / (d * d), 1e-10);
    }
  }
}

/// Largest difference of a lattice's profile, eight bins a cell, from that of its caps.
double error_of_caps(const Profile& p) {
  double largest = 0.0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const double low = 0.125 * d * static_cast<double>(k % 8) - 0.5 * d;
    const double cap = volume_in_slab(0.5 * d, {low, low + 0.125 * d});
    largest = std::max(largest, std::abs(p.porosity(k) - (1.0 - cap / (0.125 * d * d * d))));
  }
  return largest;
}

TEST(BedProfile, OfALatticeIsThatOfItsCaps) {
  const auto beads = cubic(d, 3, 4, 6);
  const auto shape = box(3 * d, 4 * d, 6 * d, Boundary::periodic);

  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    const auto p = bed_profile(beads, shape, axis, {0.125 * d, {0.0, 6 * d}}, alone);
    const std::size_t cells = axis == Axis::x ? 3 : axis == Axis::y ? 4 : 6;
    EXPECT_EQ(p.size(), 8 * cells);
    EXPECT_LT(error_of_caps(p), 1e-10);
    EXPECT_EQ(p.outside, 0.0);
  }
}

TEST(BedProfile, OfAMiddleHalfCutsSpheresExactly) {
  const auto beads = cubic(d, 2, 2, 4);
  const auto shape = box(2 * d, 2 * d, 4 * d, Boundary::periodic);
  // From a quarter of the first layer to the equator of the third: two layers and a cut one.
  const Range z{0.25 * d, 2.5 * d};

  const auto p = bed_profile(beads, shape, Axis::x, {0.1 * d, z}, alone);

  const double layers = 1.5 * sphere_volume(0.5 * d) + volume_in_slab(0.5 * d, {-0.25 * d, d});
  EXPECT_NEAR(sum(p.solid) / (4.0 * layers), 1.0, 1e-9);
  EXPECT_NEAR(sum(p.volume), 4.0 * d * d * 2.25 * d, 1e-12 * d * d * d);
}

// What leaves through one periodic side enters through the other.
TEST(BedProfile, WrapsPeriodicSides) {
  const auto shape = box(4 * d, 4 * d, 4 * d, Boundary::periodic);
  const auto beads = cloud(50, {0, 0, 0}, {4 * d, 4 * d, 4 * d}, 11);
  auto moved = beads;
  for (auto& b : moved) b.x.x += 7.0 * d;  // one period and three quarters

  const auto before = bed_profile(beads, shape, Axis::x, {0.25 * d, all_z}, alone);
  const auto after = bed_profile(moved, shape, Axis::x, {0.25 * d, all_z}, alone);

  EXPECT_NEAR(sum(before.solid) / total_volume(beads), 1.0, 1e-12);
  for (std::size_t k = 0; k < 16; ++k) {
    EXPECT_NEAR(after.solid[(k + 12) % 16], before.solid[k], 1e-12 * total_volume(beads));
  }
}

void expect_all_volume(const Profile& p, const std::vector<Bead>& beads, double volume) {
  EXPECT_NEAR((sum(p.solid) + p.outside) / total_volume(beads), 1.0, 1e-12);
  EXPECT_NEAR(sum(p.volume) / volume, 1.0, 1e-12);
}

TEST(BedProfile, KeepsAllVolumeInColumnsWithWalls) {
  const mesh::Slice slice{.inner_diameter = 3e-3, .depth = 0.4e-3, .height = 5e-3};
  const mesh::Cylinder cylinder{.inner_diameter = 3e-3, .height = 5e-3};
  const auto beads = cloud(300, {-1.5e-3, -1e-3, 0}, {1.5e-3, 1e-3, 5e-3}, 13);
  const ProfileBins bins{0.07e-3, all_z};

  for (const mesh::ColumnShape& shape : {mesh::ColumnShape{slice}, mesh::ColumnShape{cylinder}}) {
    const double volume = mesh::cross_section(shape) * (all_z.high - all_z.low);
    expect_all_volume(bed_profile(beads, shape, Axis::x, bins, alone), beads, volume);
    expect_all_volume(bed_profile(beads, shape, Axis::y, bins, alone), beads, volume);
    const auto p = wall_profile(beads, shape, bins, alone);
    expect_all_volume(p, beads, volume);
    EXPECT_GT(p.outside, 0.0);
    EXPECT_NEAR(p.edges.back(), 1.5e-3, 1e-18);
  }
}

TEST(WallProfile, SumsPartsOverHeightToTheWhole) {
  const mesh::Cylinder cylinder{.inner_diameter = 3e-3, .height = 5e-3};
  const auto beads = cloud(200, {-1e-3, -1e-3, 0}, {1e-3, 1e-3, 5e-3}, 17);

  const auto whole = wall_profile(beads, cylinder, {0.1e-3, all_z}, alone);
  const auto lower = wall_profile(beads, cylinder, {0.1e-3, {-1.0, 2.2e-3}}, alone);
  const auto upper = wall_profile(beads, cylinder, {0.1e-3, {2.2e-3, 1.0}}, alone);

  for (std::size_t k = 0; k < whole.size(); ++k) {
    EXPECT_NEAR(lower.solid[k] + upper.solid[k], whole.solid[k], 1e-9 * sphere_volume(0.2e-3));
  }
}

// Points thrown into each ring: the share of hits is the solid fraction of spheres that do not overlap.
TEST(WallProfile, AgreesWithRandomPoints) {
  const mesh::Cylinder cylinder{.inner_diameter = 1.6e-3, .height = 2e-3};
  std::vector<Bead> beads;
  for (const auto& b : cubic(d, 6, 6, 5, {-3 * d, -3 * d, 0})) {
    if (std::hypot(b.x.x, b.x.y) < 0.8e-3) beads.push_back(b);
  }
  const Range z{0.4e-3, 1.1e-3};
  const auto p = wall_profile(beads, cylinder, {0.1e-3, z}, alone);
  Draws draw(19);

  for (std::size_t k = 0; k < p.size(); ++k) {
    const int points = 4000;
    int hits = 0;
    const double outer = 0.8e-3 - p.edges[k];
    const double inner = 0.8e-3 - p.edges[k + 1];
    for (int n = 0; n < points; ++n) {
      const double r = std::sqrt(draw(inner * inner, outer * outer));
      const double angle = draw(0.0, 2.0 * std::numbers::pi);
      const Vec3 x{r * std::cos(angle), r * std::sin(angle), draw(z.low, z.high)};
      for (const auto& b : beads) {
        if (norm(x - b.x) < b.radius) {
          ++hits;
          break;
        }
      }
    }
    EXPECT_NEAR(1.0 - p.porosity(k), hits / (1.0 * points), 4.0 * std::sqrt(0.25 / points));
  }
}

TEST(WallProfile, OfASliceFoldsBothWalls) {
  const mesh::Slice slice{.inner_diameter = 1e-3, .depth = 0.5e-3, .height = 1e-3};
  const std::vector<Bead> beads = {{{-0.5e-3 + 0.1e-3, 0, 0.5e-3}, 0.1e-3},
                                   {{0.5e-3 - 0.3e-3, 0, 0.5e-3}, 0.1e-3}};

  const auto p = wall_profile(beads, slice, {0.2e-3, {0.0, 1e-3}}, alone);

  ASSERT_EQ(p.size(), 3U);
  EXPECT_NEAR(p.solid[0], sphere_volume(0.1e-3), 1e-24);
  EXPECT_NEAR(p.solid[1], sphere_volume(0.1e-3), 1e-24);
  EXPECT_NEAR(p.solid[2], 0.0, 1e-24);
  EXPECT_NEAR(p.volume[2], 2 * 0.1e-3 * 0.5e-3 * 1e-3, 1e-22);  // the last bin is what is left
}

TEST(WallProfile, NeedsAWall) {
  const auto shape = box(d, d, d, Boundary::periodic);
  EXPECT_THAT(message_of([&] {
                (void)wall_profile({}, shape, {d, all_z}, alone);
              }),
              testing::HasSubstr("without walls in x and y"));
}

}  // namespace
}  // namespace packbed::analysis
