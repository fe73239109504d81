// SPDX-License-Identifier: BSD-3-Clause
#include "coupling/weights.hpp"

#include <cmath>
#include <cstdint>
#include <map>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/random.hpp"
#include "coupling/kernel.hpp"
#include "tests/support/meshes.hpp"

namespace packbed::coupling {
namespace {

double u(std::uint64_t n) { return uniform(3, Stream::bead_position, n); }

/// Random points in the column, walls and ends among them.
std::vector<Vec3> points_in(const mesh::ColumnMesh& mesh, int count) {
  const auto low = mesh.locator().low();
  const auto high = mesh.locator().high();
  std::vector<Vec3> points;
  for (std::uint64_t k = 0; points.size() < static_cast<std::size_t>(count); ++k) {
    const Vec3 x{low.x + u(3 * k) * (high.x - low.x), low.y + u(3 * k + 1) * (high.y - low.y),
                 u(3 * k + 2) * mesh.top()};
    if (mesh.cell_at(x)) points.push_back(x);
  }
  points.push_back({0.5 * (low.x + high.x), 0.5 * (low.y + high.y), 0.0});
  points.push_back({0.5 * (low.x + high.x), 0.5 * (low.y + high.y), mesh.top()});
  return points;
}

std::map<std::int64_t, double> row_of(const Weights& weights, std::size_t i) {
  std::map<std::int64_t, double> row;
  weights.for_each(i, [&](std::int64_t cell, double w) { row[cell] += w; });
  return row;
}

class WeightsOfShape : public testing::TestWithParam<test::NamedShape> {};

// V1: no volume is lost, wherever a bead is, on any mesh.
TEST_P(WeightsOfShape, AddUpToOneForEachBead) {
  const auto mesh = GetParam().mesh();
  Weights weights(mesh, GetParam().shape, {.reach = 0.45e-3, .reach_z = 0.45e-3});
  const auto points = points_in(mesh, 200);
  weights.set_rows(mesh, points);
  ASSERT_EQ(weights.rows(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    double sum = 0.0;
    weights.for_each(i, [&](std::int64_t cell, double w) {
      EXPECT_GE(cell, 0);
      EXPECT_LT(cell, mesh.cell_count());
      EXPECT_GE(w, 0.0);
      sum += w;
    });
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
}

// A bead whose kernel ends within rounding of a level has no negative share beyond it.
TEST(Weights, AreNotNegativeWhereABeadJustReachesALayer) {
  const mesh::Slice slice{.inner_diameter = 2e-3, .depth = 0.7e-3, .height = 5e-3};
  const mesh::ColumnMesh mesh(slice, mesh::cell_counts(slice, {}));
  const double reach = 0.75e-3;
  Weights weights(mesh, slice, {.reach = reach, .reach_z = reach});
  std::vector<Vec3> points;
  for (std::uint64_t k = 0; k < 20000; ++k) {
    const double beyond = std::pow(10.0, -3.0 - 10.0 * u(2 * k)) * reach;
    const double level = mesh.level(5);
    points.push_back({0.0, 0.0, k % 2 == 0 ? level + reach - beyond : level - reach + beyond});
  }
  weights.set_rows(mesh, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    weights.for_each(i, [&](std::int64_t /*cell*/, double w) { ASSERT_GE(w, 0.0) << i; });
  }
}

// V4: when a bead moves by a thousandth of a cell, no weight jumps, faces of cells and sides among them.
TEST_P(WeightsOfShape, ChangeSmoothlyAlongAnyWay) {
  const auto mesh = GetParam().mesh();
  const double reach = 0.45e-3;
  Weights weights(mesh, GetParam().shape, {.reach = reach, .reach_z = reach});
  const auto ends = points_in(mesh, 12);
  const int steps = 2000;
  for (std::size_t k = 0; k + 1 < ends.size(); k += 4) {
    std::vector<Vec3> way;
    for (int n = 0; n <= steps; ++n)
      way.push_back(ends[k] + n / double{steps} * (ends[k + 1] - ends[k]));
    weights.set_rows(mesh, way);
    const double step = norm(ends[k + 1] - ends[k]) / steps;
    auto before = row_of(weights, 0);
    for (std::size_t n = 1; n < way.size(); ++n) {
      auto now = row_of(weights, n);
      double change = 0.0;
      for (const auto& [cell, w] : now) change += std::abs(w - before[cell]);
      for (const auto& [cell, w] : before) {
        if (!now.contains(cell)) change += w;
      }
      EXPECT_LT(change, 12.0 * step / reach) << GetParam() << " from " << k << " at " << n;
      before = std::move(now);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes,
                         WeightsOfShape,
                         testing::ValuesIn([] {
                           auto shapes = test::mesh_shapes();
                           // Of a single cell: the kernel would be wider than the box.
                           std::erase_if(shapes,
                                         [](const auto& s) { return s.name == "box_open_of_one"; });
                           return shapes;
                         }()),
                         [](const auto& p) { return p.param.name; });

/// The integral of the kernel over each cell by fine sampling, over its sum.
std::map<std::int64_t, double> sampled(const mesh::ColumnMesh& mesh, const Vec3& x, double reach) {
  std::map<std::int64_t, double> row;
  double total = 0.0;
  constexpr int n = 160;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double dx = reach * (2.0 * (i + 0.5) / n - 1.0);
      const double dy = reach * (2.0 * (j + 0.5) / n - 1.0);
      const double w = kernel((dx * dx + dy * dy) / (reach * reach));
      if (w == 0.0) continue;
      const auto cell = mesh.cell_at({x.x + dx, x.y + dy, 0.5 * mesh.level(1)});
      if (!cell) continue;
      row[*cell] += w;
      total += w;
    }
  }
  for (auto& [cell, w] : row) w /= total;
  return row;
}

TEST(Weights, AreTheIntegralOfTheKernel) {
  const mesh::Cylinder column{.inner_diameter = 10e-3, .height = 3e-3};
  const mesh::ColumnMesh mesh(column, mesh::cell_counts(column, {}));
  const double reach = 0.8e-3;
  Weights weights(mesh, column, {.reach = reach, .reach_z = reach});
  for (const Vec3& x : {Vec3{0.2e-3, -0.3e-3, 1.5e-3}, Vec3{3.1e-3, 1.2e-3, 1.5e-3},
                        Vec3{-2.2e-3, -3.9e-3, 1.5e-3}}) {
    weights.set_rows(mesh, std::vector<Vec3>{x});
    std::map<std::int64_t, double> plane;
    weights.for_each(
        0, [&](std::int64_t cell, double w) { plane[cell % mesh.cells_per_layer()] += w; });
    for (const auto& [cell, w] : sampled(mesh, x, reach)) EXPECT_NEAR(plane[cell], w, 3e-3) << cell;
  }
}

// V3: a lattice of beads has its solid fraction in every cell.
TEST(Weights, OfALatticeGiveItsSolidFraction) {
  using enum mesh::Boundary;
  const mesh::Box box{.size = {3e-3, 3e-3, 3e-3}, .boundaries = {periodic, periodic, periodic}};
  const mesh::ColumnMesh mesh(box, mesh::cell_counts(box, {.cell = 0.3e-3}));
  Weights weights(mesh, box, {.reach = 0.9e-3, .reach_z = 0.9e-3});
  std::vector<Vec3> centers;
  constexpr int n = 10;
  constexpr double pitch = 3e-3 / n;
  for (int i = 0; i < n * n * n; ++i) {
    centers.push_back(
        {(i % n + 0.21) * pitch, (i / n % n + 0.43) * pitch, (i / n / n + 0.64) * pitch});
  }
  weights.set_rows(mesh, centers);
  std::vector<double> volume(static_cast<std::size_t>(mesh.cell_count()), 0.0);
  const double bead = std::numbers::pi / 6.0 * pitch * pitch * pitch;
  for (std::size_t i = 0; i < centers.size(); ++i) {
    weights.for_each(
        i, [&](std::int64_t c, double w) { volume[static_cast<std::size_t>(c)] += w * bead; });
  }
  for (std::size_t c = 0; c < volume.size(); ++c) {
    EXPECT_NEAR(volume[c] / mesh.volume(static_cast<std::int64_t>(c)), std::numbers::pi / 6.0,
                1e-3);
  }
}

TEST(Weights, SeeThePeriodicSidesAndNotTheEmptyDirection) {
  const mesh::Slice slice{.inner_diameter = 4e-3, .depth = 0.9e-3, .height = 6e-3};
  const mesh::ColumnMesh one(slice, mesh::cell_counts(slice, {}));
  Weights weights(one, slice, {.reach = 0.8e-3, .reach_z = 0.8e-3});  // wider than the slice
  weights.set_rows(one, std::vector<Vec3>{{0.3e-3, -0.44e-3, 2e-3}, {0.3e-3, 0.1e-3, 2e-3}});
  EXPECT_EQ(row_of(weights, 0), row_of(weights, 1));

  const mesh::ColumnMesh three(slice, mesh::cell_counts(slice, {.cells_y = 3}));
  Weights around(three, slice, {.reach = 0.4e-3, .reach_z = 0.4e-3});
  around.set_rows(three, std::vector<Vec3>{{0.3e-3, -0.45e-3, 2e-3}, {0.3e-3, 0.45e-3, 2e-3}});
  const auto low = row_of(around, 0);
  const auto high = row_of(around, 1);
  ASSERT_EQ(low.size(), high.size());
  for (const auto& [cell, w] : low) EXPECT_NEAR(w, high.at(cell), 1e-12);
}

TEST(Weights, FollowAMeshThatIsStretched) {
  const mesh::Slice slice{.inner_diameter = 4e-3, .depth = 0.9e-3, .height = 6e-3};
  mesh::ColumnMesh mesh(slice, mesh::cell_counts(slice, {}));
  Weights weights(mesh, slice, {.reach = 0.8e-3, .reach_z = 0.8e-3});
  mesh.set_top(4.5e-3);
  const Vec3 x{0.3e-3, 0.0, 3.1e-3};
  weights.set_rows(mesh, std::vector<Vec3>{x});
  double mean_z = 0.0;
  double sum = 0.0;
  weights.for_each(0, [&](std::int64_t cell, double w) {
    mean_z += w * mesh.center(cell).z;
    sum += w;
  });
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_NEAR(mean_z, x.z, 0.02e-3);
}

TEST(Weights, RefuseAWidthThatIsNoneOrTooLarge) {
  using enum mesh::Boundary;
  const mesh::Box box{.size = {2e-3, 2e-3, 2e-3}, .boundaries = {periodic, wall, periodic}};
  const mesh::ColumnMesh mesh(box, mesh::cell_counts(box, {}));
  EXPECT_THROW(Weights(mesh, box, {.reach = 0.0, .reach_z = 1e-3}), ValueError);
  EXPECT_THROW(Weights(mesh, box, {.reach = 1.1e-3, .reach_z = 0.5e-3}), ValueError);
  EXPECT_THROW(Weights(mesh, box, {.reach = 0.5e-3, .reach_z = 1.1e-3}), ValueError);
}

}  // namespace
}  // namespace packbed::coupling
