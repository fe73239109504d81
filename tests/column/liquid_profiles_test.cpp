// SPDX-License-Identifier: BSD-3-Clause
#include "column/liquid_profiles.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/liquid_of.hpp"

namespace packbed::column {
namespace {

using test::liquid_of;

constexpr mesh::Slice slice{.inner_diameter = 2e-3, .depth = 0.7e-3, .height = 3e-3};
constexpr mesh::Cylinder cylinder{.inner_diameter = 4e-3, .height = 2e-3};

double parabola(const Vec3& x) { return 1.0 - (x.x * x.x + x.y * x.y) / 4e-6; }

TEST(LiquidProfiles, OfLayersAreMeansOfTheirCells) {
  const auto fluid = liquid_of(
      slice, [](const Vec3& x) { return 0.3 + 100.0 * x.z; },
      [](const Vec3& x) { return 1e-3 + x.x; });  // the mean of x is 0
  const auto bins = layer_profile(fluid);
  const auto& mesh = fluid.domain().mesh;
  ASSERT_EQ(bins.size(), static_cast<std::size_t>(mesh.layers()));
  for (std::size_t k = 0; k < bins.size(); ++k) {
    const auto layer = static_cast<std::int32_t>(k);
    EXPECT_EQ(bins[k].low, mesh.level(layer));
    EXPECT_EQ(bins[k].high, mesh.level(layer + 1));
    const double porosity = 0.3 + 50.0 * (bins[k].low + bins[k].high);
    EXPECT_NEAR(bins[k].porosity, porosity, 1e-14);
    EXPECT_NEAR(bins[k].superficial_velocity, 1e-3 * porosity, 1e-16);  // downwards
    EXPECT_EQ(bins[k].pressure, 0.0);
  }
}

TEST(LiquidProfiles, AcrossASliceAreColumnsOfCellsBetweenTwoHeights) {
  const auto fluid = liquid_of(
      slice, [](const Vec3& x) { return 0.4 + 100.0 * x.x; },
      [](const Vec3& x) { return x.z > 1.55e-3 ? 2.0 : 1.0; });
  const double cut = fluid.domain().mesh.level(3);
  const double dz = fluid.domain().mesh.level(1);
  // A whole layer and a quarter of the next one, both below the jump.
  const auto bins = cross_profile(fluid, slice, {cut - dz, cut + 0.25 * dz});
  ASSERT_EQ(bins.size(), 6U);  // of 2 mm
  EXPECT_EQ(bins.front().low, -1e-3);
  EXPECT_EQ(bins.back().high, 1e-3);
  for (const auto& b : bins) {
    const double porosity = 0.4 + 50.0 * (b.low + b.high);
    EXPECT_NEAR(b.porosity, porosity, 1e-14);
    EXPECT_NEAR(b.superficial_velocity, porosity, 1e-14);
  }
  // Layers count by their share of the range: a quarter of a cell below the jump, three above.
  const double jump = fluid.domain().mesh.level(5);
  ASSERT_GT(jump + 0.5 * dz, 1.55e-3);
  ASSERT_LT(jump - 0.5 * dz, 1.55e-3);
  const auto mixed = cross_profile(fluid, slice, {jump - 0.25 * dz, jump + 0.75 * dz});
  EXPECT_NEAR(mixed[0].superficial_velocity / mixed[0].porosity, 1.75, 1e-13);
}

TEST(LiquidProfiles, OfARoundColumnAreRings) {
  const auto constant = liquid_of(
      cylinder, [](const Vec3&) { return 0.38; }, [](const Vec3&) { return 2e-3; });
  const auto even = cross_profile(constant, cylinder, {0.5e-3, 1.5e-3});
  const auto& mesh = constant.domain().mesh;
  EXPECT_EQ(even.front().low, 0.0);
  EXPECT_EQ(even.back().high, 2e-3);
  const double cell = std::sqrt(M_PI * 4e-6 / static_cast<double>(mesh.cells_per_layer()));
  for (const auto& b : even) {
    EXPECT_LE(b.high - b.low, cell * 1.01);
    EXPECT_NEAR(b.porosity, 0.38, 1e-14);
    EXPECT_NEAR(b.superficial_velocity, 0.38 * 2e-3, 1e-16);
  }

  const auto fluid = liquid_of(
      cylinder, [](const Vec3&) { return 0.5; }, parabola);
  const auto bins = cross_profile(fluid, cylinder, {0.0, 2e-3});
  double flow = 0.0;
  for (const auto& b : bins) {
    const double middle = 1.0 - 0.5 * (b.low * b.low + b.high * b.high) / 4e-6;
    EXPECT_NEAR(b.superficial_velocity, 0.5 * middle, 0.5 * 0.06);  // cells are no rings
    flow += M_PI * (b.high * b.high - b.low * b.low) * b.superficial_velocity;
  }
  EXPECT_NEAR(flow / (0.25 * M_PI * 4e-6), 1.0, 0.02);
}

}  // namespace
}  // namespace packbed::column
