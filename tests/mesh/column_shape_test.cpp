// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/column_shape.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace packbed::mesh {
namespace {

constexpr Slice slice{.inner_diameter = 9.6e-3, .depth = 0.6e-3, .height = 0.07};
constexpr Cylinder cylinder{.inner_diameter = 9.6e-3, .height = 0.07};
constexpr Box box{.size = {2e-3, 3e-3, 5e-3},
                  .boundaries = {Boundary::periodic, Boundary::wall, Boundary::open}};

TEST(ColumnShape, HasTheAreaOfItsCrossSection) {
  EXPECT_DOUBLE_EQ(cross_section(slice), 9.6e-3 * 0.6e-3);
  EXPECT_DOUBLE_EQ(cross_section(cylinder), std::numbers::pi * 4.8e-3 * 4.8e-3);
  EXPECT_DOUBLE_EQ(cross_section(box), 6e-6);
}

// Thesis 5.4: the pump's 2 L/h are 2763, 1630, 964 and 637 cm/h in its four columns.
TEST(ColumnShape, TurnsFlowRatesIntoTheThesisVelocities) {
  const double flow = 2e-3 / 3600.0;
  const double cm_h = 0.01 / 3600.0;
  const auto velocity = [&](double diameter) {
    return flow / flow_cross_section(Cylinder{.inner_diameter = diameter, .height = 0.1}) / cm_h;
  };
  EXPECT_NEAR(velocity(9.6e-3), 2763.0, 0.5);
  EXPECT_NEAR(velocity(12.5e-3), 1630.0, 0.5);
  EXPECT_NEAR(velocity(16.25e-3), 964.0, 0.5);
  EXPECT_NEAR(velocity(20e-3), 637.0, 0.5);
}

TEST(ColumnShape, FlowThroughASliceIsThatOfTheRoundColumn) {
  EXPECT_EQ(flow_cross_section(slice), flow_cross_section(cylinder));
  EXPECT_EQ(flow_cross_section(box), cross_section(box));
}

TEST(ColumnShape, KnowsItsInside) {
  EXPECT_TRUE(contains(slice, {-4.7e-3, 0.3e-3, 0.0}));
  EXPECT_FALSE(contains(slice, {0.0, 0.31e-3, 0.01}));
  EXPECT_FALSE(contains(slice, {0.0, 0.0, 0.08}));
  EXPECT_TRUE(contains(cylinder, {3.3e-3, 3.3e-3, 0.01}));
  EXPECT_FALSE(contains(cylinder, {4.7e-3, 4.7e-3, 0.01}));
  EXPECT_FALSE(contains(cylinder, {0.0, 0.0, -1e-6}));
  EXPECT_TRUE(contains(box, {1e-3, 1e-3, 1e-3}));
  EXPECT_FALSE(contains(box, {2.1e-3, 1e-3, 1e-3}));
}

TEST(ColumnShape, OpenSidesDoNotBound) { EXPECT_TRUE(contains(box, {1e-3, 1e-3, -1.0})); }

}  // namespace
}  // namespace packbed::mesh
