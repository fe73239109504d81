// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/velocity_variance.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace packbed::analysis {
namespace {

constexpr double far = std::numeric_limits<double>::infinity();
constexpr Range everywhere{-far, far};

/// Downward flow in four cells at distances 0.5, 1.5, 2.5 and 3.5 from the wall of a column of diameter 8; the
/// last one is high up.
std::vector<LiquidCell> row() {
  return {{.x = {3.5, 0, 1}, .volume = 2.0, .eps = 0.5, .u_z = -4.0},
          {.x = {0, 2.5, 1}, .volume = 1.0, .eps = 0.5, .u_z = -1.0},
          {.x = {-1.5, 0, 1}, .volume = 1.0, .eps = 0.5, .u_z = -1.0},
          {.x = {0, 0.5, 9}, .volume = 10.0, .eps = 0.4, .u_z = -2.0}};
}

TEST(VelocityVariance, IsTheSecondCentralMomentOverCells) {
  const auto v = velocity_variance(row(), {0.0, 5.0});
  EXPECT_EQ(v.cells, 3);
  EXPECT_EQ(v.mean, -2.0);
  EXPECT_NEAR(v.variance, (4.0 + 1.0 + 1.0) / 3.0, 1e-15);
  EXPECT_NEAR(v.variation, std::sqrt(2.0) / 2.0, 1e-15);
}

TEST(VelocityVariance, MayCountCellsByTheirLiquid) {
  const auto v = velocity_variance(row(), {0.0, 5.0}, CellWeight::liquid);
  EXPECT_EQ(v.mean, -2.5);
  EXPECT_NEAR(v.variance, (2.25 * 1.0 + 2.25 * 0.5 + 2.25 * 0.5) / 2.0, 1e-15);
}

// Cutting a cell in two changes a mean over cells, not one over liquid.
TEST(VelocityVariance, ByLiquidDoesNotDependOnTheMesh) {
  auto cells = row();
  const auto before = velocity_variance(cells, everywhere, CellWeight::liquid);
  const auto plain = velocity_variance(cells, everywhere);
  cells[0].volume = 1.0;
  cells.push_back(cells[0]);
  const auto after = velocity_variance(cells, everywhere, CellWeight::liquid);
  EXPECT_NEAR(after.variance, before.variance, 1e-15);
  EXPECT_GT(std::abs(velocity_variance(cells, everywhere).variance - plain.variance), 0.1);
}

TEST(VelocityVariance, OfNothingOrOfRestIsZero) {
  EXPECT_EQ(velocity_variance({}, everywhere).variation, 0.0);
  EXPECT_EQ(velocity_variance(row(), {20.0, 30.0}).cells, 0);
  const std::vector<LiquidCell> rest = {{.x = {}, .volume = 1.0, .eps = 1.0, .u_z = 0.0}};
  EXPECT_EQ(velocity_variance(rest, everywhere, CellWeight::liquid).variation, 0.0);
}

TEST(WallDistance, IsThatOfTheWallProfile) {
  const Vec3 x{1.0, 0.5, 0.3};
  EXPECT_NEAR(wall_distance(mesh::Cylinder{4.0, 9.0}, x), 2.0 - std::sqrt(1.25), 1e-15);
  EXPECT_EQ(wall_distance(mesh::Slice{4.0, 1.0, 9.0}, x), 1.0);
  using enum mesh::Boundary;
  EXPECT_EQ(wall_distance(mesh::Box{{4.0, 3.0, 9.0}, {wall, wall, wall}}, x), 1.0);
  EXPECT_EQ(wall_distance(mesh::Box{{4.0, 3.0, 9.0}, {periodic, wall, wall}}, x), 0.5);
  EXPECT_THROW((void)wall_distance(mesh::Box{{4.0, 3.0, 9.0}, {periodic, open, wall}}, x),
               ValueError);
}

TEST(VelocityProfile, IsOverTheMeanOfTheInnerPart) {
  const std::vector<double> edges = {0.0, 1.0, 3.0, 4.0};
  const auto bins =
      velocity_profile(row(), mesh::Cylinder{8.0, 10.0}, edges, {.z = {0.0, 5.0}, .inner = 1.0});
  ASSERT_EQ(bins.size(), 3U);
  EXPECT_EQ(bins[0].cells, 1);
  EXPECT_EQ(bins[0].mean, -4.0);
  EXPECT_EQ(bins[0].relative, 4.0);
  EXPECT_EQ(bins[1].cells, 2);
  EXPECT_EQ(bins[1].relative, 1.0);
  EXPECT_EQ(bins[2].cells, 0);
  EXPECT_EQ(bins[2].relative, 0.0);
  EXPECT_EQ(bins[2].distance.high, 4.0);

  const auto all = velocity_profile(row(), mesh::Cylinder{8.0, 10.0}, edges, {.z = {0.0, 5.0}});
  EXPECT_EQ(all[0].relative, 4.0 / 2.5);
  EXPECT_EQ(velocity_profile({}, mesh::Cylinder{8.0, 10.0}, edges, {.z = {0, 5}})[0].relative, 0.0);
}

}  // namespace
}  // namespace packbed::analysis
