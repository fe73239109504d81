// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/porosity_deviation.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "continuum/wall_porosity.hpp"
#include "core/error.hpp"

namespace packbed::analysis {
namespace {

TEST(PorosityBeyond, LeavesTheWallOut) {
  const Profile p{.edges = {0, 1, 2, 4}, .solid = {0.1, 0.6, 1.0}, .volume = {1, 1, 2}};
  EXPECT_NEAR(porosity_beyond(p, 1.0), 1.0 - 1.6 / 3.0, 1e-15);
  EXPECT_THROW((void)porosity_beyond(p, 2.5), ValueError);
}

TEST(PorosityDeviation, AddsBinsWithAndWithoutSign) {
  const std::vector<double> edges = {0.0, 0.1, 0.3, 0.4};
  const std::vector<double> eps = {1.0, 0.3, 0.4};
  const auto deviation = integral_porosity_deviation(edges, eps, 0.4);
  EXPECT_NEAR(deviation.with_sign, 0.06 - 0.02, 1e-15);
  EXPECT_NEAR(deviation.absolute, 0.06 + 0.02, 1e-15);
}

// P7: Bey and Eigenberger's profile at D/d = 16 from wall to axis, worked out apart from the code:
// 0.051315 d with sign, 0.291499 d without.
TEST(PorosityDeviation, OfTheCurveOfTheThesis) {
  const continuum::BeyEigenberger profile{.column_diameter = 16.0, .bead_diameter = 1.0};
  const int bins = 16000;
  std::vector<double> edges = {0.0};
  std::vector<double> eps;
  for (int k = 0; k < bins; ++k) {
    edges.push_back(8.0 * (k + 1) / bins);
    eps.push_back(profile(8.0 * (k + 0.5) / bins));
  }

  const auto deviation = integral_porosity_deviation(edges, eps, profile.eps_bulk);

  EXPECT_NEAR(deviation.with_sign, 0.051315, 1e-6);
  EXPECT_NEAR(deviation.absolute, 0.291499, 1e-6);
}

/// Its profile over the distance from the wall, from the wall to the axis; volumes are those of slabs of area 1.
Profile curve_of_the_thesis(double bead_diameter, double bin) {
  const continuum::BeyEigenberger curve{.column_diameter = 16.0 * bead_diameter,
                                        .bead_diameter = bead_diameter};
  Profile p;
  const auto bins = static_cast<int>(std::lround(8.0 / bin));
  const double width = bin * bead_diameter;
  for (int k = 0; k <= bins; ++k) p.edges.push_back(k * width);
  for (int k = 0; k < bins; ++k) {
    p.volume.push_back(width);
    p.solid.push_back(width * (1.0 - curve((k + 0.5) * width)));
  }
  return p;
}

// The same numbers in bead diameters, over one wall and over both.
TEST(WallDeviation, OfTheCurveOfTheThesis) {
  const double d = 86.9e-6;
  const auto w = wall_deviation(curve_of_the_thesis(d, 0.0005), d, 0.39);
  EXPECT_NEAR(w.wall_in_diameters.with_sign, 0.051315, 1e-5);
  EXPECT_NEAR(w.wall_in_diameters.absolute, 0.291499, 1e-5);
  EXPECT_NEAR(w.across_in_diameters.with_sign, 2.0 * 0.051315, 2e-5);
  EXPECT_NEAR(w.across_in_diameters.absolute, 2.0 * 0.291499, 2e-5);
  EXPECT_NEAR(w.wall.absolute, 0.291499 * d, 1e-5 * d);
  EXPECT_NEAR(w.across.with_sign, 2.0 * 0.051315 * d, 2e-5 * d);
}

// The curve still swings beyond 4 d, so that its own bulk is 0.001 off 0.39; over 8 d that is 0.008 of the integral.
TEST(WallDeviation, TakesTheBulkFromFourDiametersOn) {
  const double d = 86.9e-6;
  const auto profile = curve_of_the_thesis(d, deviation_bin);
  ASSERT_EQ(profile.size(), 160U);
  const auto w = wall_deviation(profile, d);
  EXPECT_NEAR(w.bulk_from, 4.0 * d, 1e-18);
  EXPECT_EQ(w.bulk, porosity_beyond(profile, profile.edges[80]));
  EXPECT_NEAR(w.bulk, 0.389, 1e-4);
  const auto known = wall_deviation(profile, d, 0.39);
  EXPECT_NEAR(w.wall_in_diameters.with_sign,
              known.wall_in_diameters.with_sign + 8.0 * (0.39 - w.bulk), 1e-12);
  EXPECT_NEAR(known.wall_in_diameters.with_sign, 0.051315, 1e-3);  // what bins of 0.05 d leave
  EXPECT_NEAR(known.wall_in_diameters.absolute, 0.291499, 2e-3);
}

TEST(WallDeviation, OfANarrowColumnTakesTheInnerHalf) {
  const Profile p{.edges = {0, 1, 2, 3, 4}, .solid = {0.1, 0.5, 0.6, 0.7}, .volume = {1, 1, 1, 1}};
  const auto w = wall_deviation(p, 1.0);
  EXPECT_EQ(w.bulk_from, 2.0);
  EXPECT_NEAR(w.bulk, 0.35, 1e-15);
  EXPECT_NEAR(w.wall.with_sign, 0.55 + 0.15, 1e-15);
  EXPECT_NEAR(w.wall.absolute, 0.55 + 0.15 + 0.1, 1e-15);
}

}  // namespace
}  // namespace packbed::analysis
