// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/granular_temperature.hpp"

#include <gtest/gtest.h>

namespace packbed::analysis {
namespace {

const std::vector<double> edges = {0.0, 1.0, 2.0, 3.0};

TEST(GranularTemperature, OfSlabsThatMoveAsAWholeIsZero) {
  const std::vector<MovingBead> beads = {{{0, 0, 0.2}, {1, 2, 3}},
                                         {{5, 0, 0.7}, {1, 2, 3}},
                                         {{0, 0, 1.5}, {-4, 0, 1}},
                                         {{0, 9, 1.0}, {-4, 0, 1}}};
  const auto t = granular_temperature(beads, edges);
  EXPECT_EQ(t.mean, 0.0);
  EXPECT_EQ(t.slabs[0].mean, (Vec3{1, 2, 3}));
  EXPECT_EQ(t.slabs[1].mean, (Vec3{-4, 0, 1}));
  EXPECT_EQ(t.slabs[1].beads, 2);
  EXPECT_EQ(t.outside, 0);
}

// A slab of two beads with +-(1, 2, 2), T = 9/3, and one of a single bead.
TEST(GranularTemperature, IsAThirdOfTheMeanSquareFluctuation) {
  const std::vector<MovingBead> beads = {{{0, 0, 0.2}, {11, 2, 2}},
                                         {{0, 0, 0.4}, {9, -2, -2}},
                                         {{0, 0, 2.5}, {7, 7, 7}},
                                         {{0, 0, 3.0}, {90, 0, 0}},
                                         {{0, 0, -0.1}, {90, 0, 0}}};
  const auto t = granular_temperature(beads, edges);
  ASSERT_EQ(t.slabs.size(), 3U);
  EXPECT_NEAR(t.slabs[0].temperature, 3.0, 1e-14);
  EXPECT_EQ(t.slabs[1].temperature, 0.0);
  EXPECT_EQ(t.slabs[2].temperature, 0.0);
  EXPECT_EQ(t.slabs[2].z.high, 3.0);
  EXPECT_NEAR(t.mean, 2.0, 1e-14);
  EXPECT_EQ(t.outside, 2);
}

TEST(GranularTemperature, OfNothingIsZero) {
  const auto t = granular_temperature({}, edges);
  EXPECT_EQ(t.mean, 0.0);
  EXPECT_EQ(t.slabs[0].temperature, 0.0);
}

}  // namespace
}  // namespace packbed::analysis
