// SPDX-License-Identifier: BSD-3-Clause
// Where points are found. Oracle: every cell by its corners, in long double.
#include "mesh/column_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "mesh/five_block.hpp"
#include "tests/support/meshes.hpp"

namespace packbed::mesh {
namespace {

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

// How far a point is inside of the quadrilateral of a cell: negative outside.
long double depth_in(const CrossSection& section, std::size_t cell, double x, double y) {
  long double least = std::numeric_limits<long double>::max();
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& a = section.points[at(section.cells[cell][k])];
    const auto& b = section.points[at(section.cells[cell][(k + 1) % 4])];
    const long double u = static_cast<long double>(b.x) - a.x;
    const long double v = static_cast<long double>(b.y) - a.y;
    const long double inside =
        u * (static_cast<long double>(y) - a.y) - v * (static_cast<long double>(x) - a.x);
    least = std::min(least, inside / std::hypot(u, v));
  }
  return least;
}

// Cells that a point may belong to, within rounding.
std::set<std::int64_t> brute_force(const ColumnMesh& mesh, const Vec3& p, double rounding) {
  std::set<std::int64_t> cells;
  for (std::int32_t k = 0; k < mesh.layers(); ++k) {
    if (p.z < mesh.level(k) - rounding || p.z > mesh.level(k + 1) + rounding) continue;
    for (std::int32_t c = 0; c < mesh.cells_per_layer(); ++c) {
      if (depth_in(mesh.section(), at(c), p.x, p.y) >= -rounding) {
        cells.insert(k * mesh.cells_per_layer() + c);
      }
    }
  }
  return cells;
}

// Uniform over the column.
Vec3 random_point(const ColumnShape& shape, std::uint64_t i) {
  const auto u = [&](std::uint64_t k) { return uniform(11, Stream::bead_position, 3 * i + k); };
  const double z = height(shape) * u(2);
  if (const auto* box = std::get_if<Box>(&shape)) {
    return {box->size[0] * u(0), box->size[1] * u(1), z};
  }
  if (const auto* slice = std::get_if<Slice>(&shape)) {
    return {slice->inner_diameter * (u(0) - 0.5), slice->depth * (u(1) - 0.5), z};
  }
  const double r = 0.5 * std::get<Cylinder>(shape).inner_diameter * std::sqrt(u(0));
  const double angle = 2.0 * std::numbers::pi * u(1);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

class Location : public testing::TestWithParam<test::NamedShape> {};

TEST_P(Location, LosesNoPointAndFillsCellsEvenly) {
  const auto mesh = GetParam().mesh();
#ifdef NDEBUG
  constexpr std::uint64_t count = 1'000'000;
#else
  constexpr std::uint64_t count = 20'000;
#endif
  std::vector<double> found(at(mesh.cells_per_layer()), 0.0);
  std::uint64_t lost = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto cell = mesh.cell_at(random_point(GetParam().shape, i));
    if (!cell || *cell < 0 || *cell >= mesh.cell_count()) {
      ++lost;
    } else {
      found[at(*cell % mesh.cells_per_layer())] += 1.0;
    }
  }
  EXPECT_EQ(lost, 0U);
  // A cell of area a has a share of a / A, give or take sqrt(share); 6 of them: once in 10^9 cells.
  for (std::size_t c = 0; c < found.size(); ++c) {
    const double expected =
        static_cast<double>(count) * mesh.section().area[c] / cross_section(GetParam().shape);
    EXPECT_NEAR(found[c], expected, 6.0 * std::sqrt(expected)) << "column " << c;
  }
}

TEST_P(Location, AgreesWithBruteForce) {
  const auto mesh = GetParam().mesh();
  for (std::uint64_t i = 0; i < 300; ++i) {
    const auto p = random_point(GetParam().shape, i);
    const auto possible = brute_force(mesh, p, 1e-17);
    const auto cell = mesh.cell_at(p);
    ASSERT_TRUE(cell.has_value());
    // None: between a facet and the round wall; the next test.
    if (possible.empty()) continue;
    EXPECT_TRUE(possible.contains(*cell)) << p.x << ", " << p.y << ", " << p.z;
  }
}

TEST_P(Location, FindsCentersInTheirCells) {
  const auto mesh = GetParam().mesh();
  for (std::int64_t c = 0; c < mesh.cell_count(); ++c) EXPECT_EQ(mesh.cell_at(mesh.center(c)), c);
}

// Corners and middles of edges and faces: one of the cells there, within rounding of the points; at heights that
// are exact, the lower layer.
TEST_P(Location, GivesPointsOnFacesEdgesAndCornersToACellThere) {
  const auto mesh = GetParam().mesh();
  const auto& s = mesh.section();
  for (std::int32_t k = 0; k <= mesh.layers(); ++k) {
    for (std::size_t c = 0; c < s.cells.size(); ++c) {
      for (std::size_t e = 0; e < 4; ++e) {
        const auto& a = s.points[at(s.cells[c][e])];
        const auto& b = s.points[at(s.cells[c][(e + 1) % 4])];
        for (const double t : {0.0, 0.5}) {
          const Vec3 p = {(1 - t) * a.x + t * b.x, (1 - t) * a.y + t * b.y, mesh.level(k)};
          const auto cell = mesh.cell_at(p);
          ASSERT_TRUE(cell.has_value());
          EXPECT_EQ(*cell / mesh.cells_per_layer(), std::max(k - 1, 0));
          EXPECT_GE(depth_in(s, at(*cell % mesh.cells_per_layer()), p.x, p.y), -1e-17L);
        }
      }
    }
  }
}

TEST_P(Location, FindsACellForAnyPointWhenAskedForTheNearest) {
  const auto mesh = GetParam().mesh();
  constexpr double far = 1e300;
  for (const double x : {-far, -1.0, 0.0, 1.0, far}) {
    for (const double z : {-far, -1.0, 0.0, 1.0, far}) {
      const auto cell = mesh.nearest_cell({x, -x, z});
      EXPECT_GE(cell, 0);
      EXPECT_LT(cell, mesh.cell_count());
    }
  }
  EXPECT_EQ(mesh.cell_at({0, 0, 1.0}), std::nullopt);
  EXPECT_EQ(mesh.cell_at({0, 1.0, 0.0}), std::nullopt);
  EXPECT_EQ(mesh.cell_at({std::nan(""), 0, 0}), std::nullopt);
  EXPECT_EQ(mesh.cell_at({0, 0, std::nan("")}), std::nullopt);
}

TEST_P(Location, KnowsAllCellsWithinReach) {
  const auto mesh = GetParam().mesh();
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const auto p = random_point(GetParam().shape, i);
    const double reach = 1e-3 * uniform(5, Stream::bead_size, i);
    const auto u = [&](std::uint64_t k) {
      return reach * (2.0 * uniform(6, Stream::bead_size, 2 * i + k) - 1.0);
    };
    const auto near = mesh.locator().cells_within({p.x, p.y}, reach);
    const auto other = mesh.locator().cell_at({p.x + u(0), p.y + u(1)});
    EXPECT_TRUE(std::ranges::binary_search(near, other));
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes,
                         Location,
                         testing::ValuesIn(test::mesh_shapes()),
                         [](const auto& param) { return param.param.name; });

// Exact where edges lie along the axes; points on slanted ones are rounded to either side.
TEST(LocationOnAFace, IsInTheCellOfTheLowerNumber) {
  for (const auto& shape : test::mesh_shapes()) {
    if (std::holds_alternative<Cylinder>(shape.shape)) continue;
    const auto mesh = shape.mesh();
    for (const auto& e : mesh.section().inner) {
      if (e.shift.x != 0.0 || e.shift.y != 0.0) continue;
      const auto& a = mesh.section().points[at(e.a)];
      const auto& b = mesh.section().points[at(e.b)];
      EXPECT_EQ(mesh.locator().cell_at({0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}), e.owner) << shape;
    }
  }
}

// Between a facet and the wall, at the wall, and outside by rounding: the cell of the facet that is
// passed, found by the angle.
TEST(LocationAtTheWall, GivesPointsBehindAFacetToItsCell) {
  const double radius = 5e-3;
  const Cylinder cylinder{.inner_diameter = 2 * radius, .height = 1e-3};
  const ColumnMesh mesh(cylinder, cell_counts(cylinder, {}));
  const double facet = wall_point_radius(radius, 14) * std::cos(std::numbers::pi / 56);
  for (const auto& e : mesh.section().border) {
    const auto& a = mesh.section().points[at(e.a)];
    const auto& b = mesh.section().points[at(e.b)];
    // Side edges at the wall are radial to 3 degrees: 0.3 mm * tan(3 degrees) ~ nothing at 5 um.
    for (const double t : {0.03, 0.3, 0.5, 0.97}) {
      const double angle = std::atan2((1 - t) * a.y + t * b.y, (1 - t) * a.x + t * b.x);
      for (const double r : {facet, radius, std::nextafter(radius, 1.0), radius * (1 + 1e-9)}) {
        const Vec3 p = {r * std::cos(angle), r * std::sin(angle), 0.0};
        EXPECT_EQ(mesh.cell_at(p), e.cell) << r << " at " << angle;
      }
    }
  }
}

TEST(LocationAtTheWall, RefusesPointsFartherOutsideThanRounding) {
  const Cylinder cylinder{.inner_diameter = 10e-3, .height = 3e-3};
  const ColumnMesh mesh(cylinder, cell_counts(cylinder, {}));
  EXPECT_TRUE(mesh.cell_at({5e-3, 0, 3e-3}).has_value());
  EXPECT_TRUE(mesh.cell_at({5e-3 + 1e-9, 0, 3e-3 + 1e-9}).has_value());
  EXPECT_FALSE(mesh.cell_at({5.02e-3, 0, 1e-3}).has_value());
  EXPECT_FALSE(mesh.cell_at({0, 0, 3.02e-3}).has_value());
  EXPECT_FALSE(mesh.cell_at({0, 0, -0.02e-3}).has_value());
}

TEST(ColumnMesh, FollowsTheTopWhenPointsAreFound) {
  const Cylinder cylinder{.inner_diameter = 4e-3, .height = 10e-3};
  ColumnMesh mesh(cylinder, cell_counts(cylinder, {.layers = 10}));
  EXPECT_EQ(mesh.layer_at(4.5e-3), 4);

  mesh.set_top(5e-3);

  EXPECT_EQ(mesh.layer_at(4.5e-3), 8);  // on the face between layers 8 and 9
  EXPECT_EQ(mesh.cell_at({0, 0, 6e-3}), std::nullopt);
}

}  // namespace
}  // namespace packbed::mesh
