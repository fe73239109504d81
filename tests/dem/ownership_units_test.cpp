// SPDX-License-Identifier: BSD-3-Clause
#include "dem/ownership_units.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace packbed::dem {
namespace {

constexpr std::array<double, 3> size = {2e-3, 0.5e-3, 3e-3};

double random(std::uint64_t k) { return uniform(23, Stream::bead_position, k); }

Domain domain(std::array<bool, 3> periodic) {
  return {.low = {0, 0, 0}, .size = size, .periodic = periodic};
}

CellUnits cells(const Domain& d, const mesh::MeshOptions& options) {
  const auto side = [&](std::size_t axis) {
    return d.periodic[axis] ? mesh::Boundary::periodic : mesh::Boundary::wall;
  };
  const mesh::Box box{.size = size, .boundaries = {side(0), side(1), side(2)}};
  return {d, std::make_shared<mesh::ColumnMesh>(box, mesh::cell_counts(box, options))};
}

// A point and another one within reach of it, over periodic sides too; both inside. A fifth lies
// outside where no side is periodic.
std::pair<Vec3, Vec3> near_points(const Domain& d, double reach, std::uint64_t k) {
  std::array<double, 3> p{};
  std::array<double, 3> q{};
  std::array<double, 3> way{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    p[axis] = size[axis] * random(8 * k + axis);
    if (k % 5 == 0 && !d.periodic[axis]) p[axis] = size[axis] * (3.0 * random(8 * k + axis) - 1.0);
    way[axis] = 2.0 * random(8 * k + 3 + axis) - 1.0;
  }
  const double length = norm(to_vec3(way)) / (reach * random(8 * k + 7));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    q[axis] = p[axis] + way[axis] / length;
    if (d.periodic[axis]) q[axis] -= size[axis] * std::floor(q[axis] / size[axis]);
  }
  return {to_vec3(p), to_vec3(q)};
}

bool contain(const std::vector<UnitRange>& ranges, std::int64_t unit) {
  return std::ranges::any_of(ranges,
                             [&](const UnitRange& r) { return r.first <= unit && unit <= r.last; });
}

template <class Units>
void expect_to_find_near_points(const Units& units, const Domain& d) {
  for (std::uint64_t k = 0; k < 3000; ++k) {
    const double reach = 0.7e-3 * random(100000 + k);  // up to more than the depth
    const auto [p, q] = near_points(d, reach, k);
    const auto unit = units.unit(q);
    ASSERT_GE(unit, 0);
    ASSERT_LT(unit, units.count());
    EXPECT_TRUE(contain(units.within(p, reach), unit)) << k;
    EXPECT_TRUE(contain(units.slabs_within(p, reach), unit)) << k;
  }
}

constexpr std::array<std::array<bool, 3>, 4> sides = {
    {{false, false, false}, {false, true, false}, {true, true, false}, {true, true, true}}};

TEST(RowUnits, FindTheRowsOfAllPointsWithinReach) {
  for (const auto& periodic : sides) {
    RowUnits units(domain(periodic), 0.15e-3);
    units.fit({{0, 0.1e-3, 0.2e-3}, {0, 0.45e-3, 2.5e-3}}, Ranks::alone());
    expect_to_find_near_points(units, domain(periodic));
  }
}

TEST(CellUnits, FindTheCellsOfAllPointsWithinReach) {
  for (const auto& periodic : sides) {
    for (const auto& options :
         {mesh::MeshOptions{.cell = 0.1e-3}, {.cell = 0.4e-3}, {.cell = 1.0}}) {
      expect_to_find_near_points(cells(domain(periodic), options), domain(periodic));
    }
  }
}

TEST(CellUnits, LeaveMostCellsOut) {
  const auto d = domain({true, true, false});
  const auto units = cells(d, {.cell = 0.1e-3});
  std::int64_t found = 0;
  for (const auto& r : units.within({1e-3, 0.25e-3, 1.5e-3}, 0.1e-3)) found += r.last - r.first + 1;
  // 0.2 mm meet 3 cells of 0.1 mm a direction at least, and buckets hold up to one more on each side.
  EXPECT_GE(found, 3 * 3 * 3);
  EXPECT_LE(found, 3 * 5 * 5);
}

}  // namespace
}  // namespace packbed::dem
