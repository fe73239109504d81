// SPDX-License-Identifier: BSD-3-Clause
#include "continuum/wall_porosity.hpp"

#include <gtest/gtest.h>

namespace packbed::continuum {
namespace {

constexpr BeyEigenberger profile{.column_diameter = 16.0, .bead_diameter = 1.0};

// D/d = 16, worked out apart from the code.
TEST(BeyEigenberger, IsTheCurveOfTheThesis) {
  EXPECT_NEAR(profile.y_min(), 0.516685, 5e-7);
  EXPECT_NEAR(profile(0.0), 1.0, 1e-15);
  EXPECT_NEAR(profile(0.1), 0.734285, 5e-7);
  EXPECT_NEAR(profile(0.25), 0.442469, 5e-7);
  EXPECT_NEAR(profile(0.5), 0.240793, 5e-7);
  EXPECT_NEAR(profile(1.0), 0.506037, 5e-7);
  EXPECT_NEAR(profile(1.5), 0.310147, 5e-7);
  EXPECT_NEAR(profile(2.0), 0.437141, 5e-7);
  EXPECT_NEAR(profile(3.0), 0.391901, 5e-7);
}

TEST(BeyEigenberger, HasTheMeanOfTheCrossSection) {
  const int rings = 20000;
  double sum = 0.0;
  for (int k = 0; k < rings; ++k) {
    const double r = 8.0 * (k + 0.5) / rings;
    sum += profile(8.0 - r) * 2.0 * r / 64.0 * 8.0 / rings;
  }
  EXPECT_NEAR(sum, 0.402999, 5e-7);
}

}  // namespace
}  // namespace packbed::continuum
