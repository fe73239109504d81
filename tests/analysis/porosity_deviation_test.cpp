// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/porosity_deviation.hpp"

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

}  // namespace
}  // namespace packbed::analysis
