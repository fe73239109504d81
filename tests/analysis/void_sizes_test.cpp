// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/void_sizes.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "analysis/nearest_bead.hpp"
#include "analysis/overlap.hpp"
#include "core/error.hpp"
#include "tests/support/spheres.hpp"

namespace packbed::analysis {
namespace {

using namespace packbed::test;  // NOLINT
using enum mesh::Boundary;

double by_trying_all(const std::vector<Bead>& beads, const Vec3& point, const Vec3& period) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& b : beads) {
    for (int i = -2; i <= 2; ++i) {
      for (int j = -2; j <= 2; ++j) {
        const Vec3 image = b.x + Vec3{i * period.x, j * period.y, 0.0};
        nearest = std::min(nearest, norm(point - image) - b.radius);
      }
    }
  }
  return nearest;
}

void expect_nearest(const std::vector<Bead>& beads, const Vec3& period) {
  Draws draw(4);
  const NearestBead nearest(beads, period);
  for (int k = 0; k < 300; ++k) {
    const Vec3 point{draw(-2e-3, 4e-3), draw(-0.5e-3, 1e-3), draw(-1e-3, 8e-3)};
    const double expected = by_trying_all(beads, point, period);
    const double found = nearest.distance(point);
    // Inside a bead any value <= 0 will do.
    EXPECT_NEAR(std::max(found, 0.0), std::max(expected, 0.0), 1e-15);
  }
}

TEST(NearestBead, IsTheOneThatTryingAllFinds) {
  for (const int count : {1, 3, 40, 400}) {
    auto beads = cloud(count, {-1e-3, 0, 0}, {2e-3, 0.5e-3, 5e-3}, 7);
    for (std::size_t k = 0; k < beads.size(); k += 3) beads[k].radius *= 0.1;
    expect_nearest(beads, {3e-3, 0.0, 0.0});
    expect_nearest(beads, {3e-3, 0.5e-3, 0.0});
  }
}

// Cubic lattice of touching spheres of diameter 1. Up to t = (sqrt(2) - 1)/2 the points nearer than t are spheres of
// radius R + t less the lenses that each shares with three neighbors.
double nearer(double t) {
  const double r = 0.5 + t;
  const double void_volume = 1.0 - std::numbers::pi / 6.0;
  const double lens = 2.0 * volume_below(r, -0.5);
  return (sphere_volume(r) - 3.0 * lens - std::numbers::pi / 6.0) / void_volume;
}

TEST(VoidSizes, OfACubicLatticeAreKnown) {
  const auto beads = cubic(1.0, 3, 3, 3);
  const mesh::Box box{{3.0, 3.0, 3.0}, {periodic, periodic, periodic}};

  const auto v = void_sizes(beads, box, {.z = {0.0, 3.0}, .points = 20000});

  EXPECT_NEAR(v.share, 1.0 - std::numbers::pi / 6.0, 4.0 * v.error);
  EXPECT_NEAR(v.error, 0.0035, 1e-4);
  const auto n = static_cast<double>(v.points);
  EXPECT_NEAR(nearer(v.d10), 0.1, 4.0 * std::sqrt(0.09 / n));
  EXPECT_NEAR(nearer(v.d50), 0.5, 4.0 * std::sqrt(0.25 / n));
  EXPECT_LT(v.d50, v.d90);
  EXPECT_LE(v.largest, 0.5 * (std::sqrt(3.0) - 1.0));
  EXPECT_GT(v.largest, 0.45 * (std::sqrt(3.0) - 1.0));
  EXPECT_EQ(std::ssize(v.distances), v.points);
}

TEST(VoidSizes, EndAtTheWalls) {
  const std::vector<Bead> beads = {{{0, 0, -9}, 0.5, 0}};
  const auto tube = void_sizes(beads, mesh::Cylinder{2.0, 4.0}, {.z = {0.0, 4.0}, .points = 4000});
  EXPECT_EQ(tube.share, 1.0);
  EXPECT_LE(tube.largest, 1.0);
  EXPECT_NEAR(tube.d50, 1.0 - std::sqrt(0.5), 0.02);  // half the area lies within r^2 = 1/2
  const auto slice =
      void_sizes(beads, mesh::Slice{2.0, 9.0, 4.0}, {.z = {0.0, 4.0}, .points = 4000});
  EXPECT_NEAR(slice.d50, 0.5, 0.03);
  const auto free = void_sizes(beads, mesh::Box{{2.0, 9.0, 4.0}, {open, periodic, wall}},
                               {.z = {0.0, 4.0}, .points = 100});
  EXPECT_GT(free.largest, 9.0);
}

TEST(VoidSizes, AreThoseOfTheSeedAndOfAnyOrder) {
  auto beads = cloud(60, {0, 0, 0}, {1e-3, 1e-3, 2e-3}, 3);
  const mesh::Box box{{1e-3, 1e-3, 2e-3}, {periodic, wall, wall}};
  const VoidOptions options{.z = {0.0, 2e-3}, .points = 500};
  const auto v = void_sizes(beads, box, options);
  std::ranges::reverse(beads);
  EXPECT_EQ(void_sizes(beads, box, options).distances, v.distances);
  EXPECT_NE(void_sizes(beads, box, {.z = {0.0, 2e-3}, .points = 500, .seed = 2}).d50, v.d50);
}

TEST(VoidSizes, MayFindNoVoid) {
  const std::vector<Bead> beads = {{{0, 0, 0}, 100.0, 0}};
  const auto v = void_sizes(beads, mesh::Cylinder{1.0, 1.0}, {.z = {0.0, 1.0}, .points = 10});
  EXPECT_EQ(v.points, 0);
  EXPECT_EQ(v.d50, 0.0);
  EXPECT_EQ(v.share, 0.0);
}

TEST(VoidSizes, SayWhatIsMissing) {
  const mesh::Cylinder shape{1.0, 1.0};
  const std::vector<Bead> beads = {{{0, 0, 0}, 0.1, 0}};
  EXPECT_THROW((void)void_sizes({}, shape, {.z = {0.0, 1.0}}), ValueError);
  EXPECT_THROW((void)void_sizes(beads, shape, {.z = {1.0, 1.0}}), ValueError);
  EXPECT_THROW((void)void_sizes(beads, shape, {.z = {0.0, 1.0}, .points = 0}), ValueError);
}

}  // namespace
}  // namespace packbed::analysis
