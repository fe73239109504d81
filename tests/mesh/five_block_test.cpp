// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/five_block.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "mesh/mesh_quality.hpp"
#include "tests/support/message_of.hpp"

namespace packbed::mesh {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double disc = std::numbers::pi * 25e-6;  // of 10 mm diameter [m2]

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// Thesis table 5.2: 10 mm, 588 cells in the cross-section; fig. 5.6: the side blocks have half the
// number of cells of the middle block.
TEST(FiveBlock, HasTheCellsOfTheThesisByDefault) {
  const Cylinder cylinder{.inner_diameter = 10e-3, .height = 70e-3};

  const auto counts = cell_counts(cylinder, {});

  EXPECT_EQ(counts.per_layer(), 588);
  EXPECT_EQ(counts.core, 14);
  EXPECT_EQ(counts.ring, 7);
  EXPECT_EQ(counts.layers, 200);
  EXPECT_EQ(cell_counts(cylinder, {.layers = 60}).all(), 35280);
}

TEST(FiveBlock, IsAsLargeAsTheDisc) {
  for (const std::int32_t core : {2, 3, 7, 14, 28}) {
    EXPECT_NEAR(sum(five_block_section(5e-3, core, (core + 1) / 2).area) / disc, 1.0, 1e-14)
        << core;
  }
}

// A regular polygon of n sides as large as the disc: its points lie (pi/n)^2 / 3 radii outside, the
// middles of its facets (pi/n)^2 / 6 inside (leading terms).
TEST(FiveBlock, HasItsWallPointsALittleOutside) {
  const double a = std::numbers::pi / 56;
  const double outside = wall_point_radius(1.0, 14) - 1.0;
  const double inside = 1.0 - wall_point_radius(1.0, 14) * std::cos(a);

  EXPECT_NEAR(outside / (a * a / 3), 1.0, 2e-3);  // 2e-3: next term of the series, a^2
  EXPECT_NEAR(inside / (a * a / 6), 1.0, 1e-2);
  const auto section = five_block_section(5e-3, 14, 7);
  for (const auto& e : section.border) {
    const auto& p = section.points[static_cast<std::size_t>(e.a)];
    EXPECT_NEAR(std::hypot(p.x, p.y), 5e-3 * (1 + outside), 1e-17);
  }
}

TEST(FiveBlock, HasConvexCellsAtAnyResolution) {
  for (std::int32_t core = 2; core < 20; ++core) {
    for (const std::int32_t ring : {1, core / 2 + 1, 2 * core}) {
      const auto section = five_block_section(1.0, core, ring);
      for (const auto& corners : section.cells) {
        for (std::size_t k = 0; k < 4; ++k) {
          const auto& p = section.points[static_cast<std::size_t>(corners[k])];
          const auto& q = section.points[static_cast<std::size_t>(corners[(k + 1) % 4])];
          const auto& r = section.points[static_cast<std::size_t>(corners[(k + 2) % 4])];
          EXPECT_GT((q.x - p.x) * (r.y - q.y) - (q.y - p.y) * (r.x - q.x), 0.0)
              << core << ", " << ring;
        }
      }
    }
  }
}

// The figures of docs/theory/mesh.md, for the thesis's 10 mm column with cells of 0.35 mm.
TEST(FiveBlock, IsNearlyOrthogonalWithCellsOfLikeSize) {
  const Cylinder cylinder{.inner_diameter = 10e-3, .height = 70e-3};

  const auto q = quality({cylinder, cell_counts(cylinder, {})});

  EXPECT_LT(q.largest_non_orthogonality, 13.1 * degree);
  EXPECT_LT(q.mean_non_orthogonality, 2.6 * degree);
  EXPECT_LT(q.largest_skewness, 0.15);
  EXPECT_LT(q.largest_aspect, 1.83);
  EXPECT_LT(q.largest_over_smallest, 2.85);
}

// n sides around the disc, none lost: every wall edge once, every other edge between two cells.
TEST(FiveBlock, HasTheEdgesOfADisc) {
  const auto section = five_block_section(1.0, 6, 3);

  EXPECT_EQ(section.border.size(), 24U);
  EXPECT_EQ(2 * section.inner.size() + section.border.size(), 4 * section.cells.size());
  // Euler: points - edges + cells = 1
  EXPECT_EQ(section.points.size() + section.cells.size(),
            section.inner.size() + section.border.size() + 1);
  for (const auto& e : section.border) EXPECT_EQ(e.patch, Patch::wall);
}

TEST(CellCounts, SaysWhenThereAreTooMany) {
  const Cylinder cylinder{.inner_diameter = 0.3, .height = 0.3};
  EXPECT_EQ(
      test::message_of([&] { cell_counts(cylinder, {.cell = 10e-6}); }),
      "makes 6.75e+08 cells in each of 3e+04 layers; at most 1 million in a layer and 200 million "
      "in all can be handled");
}

TEST(CellCounts, KeepsNumbersThatAreGiven) {
  const Slice slice{.inner_diameter = 10e-3, .depth = 0.6e-3, .height = 70e-3};
  // Thesis table 5.2: 30 cells in the xy-plane, 60 in z.
  const auto thesis = cell_counts(slice, {.cells_x = 30, .cells_y = 1, .layers = 60});
  EXPECT_EQ(thesis.all(), 1800);
  EXPECT_EQ(cell_counts(slice, {}).all(), 29 * 200);
}

}  // namespace
}  // namespace packbed::mesh
