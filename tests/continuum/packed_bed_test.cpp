// SPDX-License-Identifier: BSD-3-Clause
#include "continuum/packed_bed.hpp"

#include <gtest/gtest.h>

namespace packbed::continuum {
namespace {

constexpr double cm_h = 0.01 / 3600.0;

// Thesis fig. 7.1: factor 180, d32 93 um, eps 0.36, 1 mPa s. The values are the formula worked out
// apart from the code: 2.537620e5 Pa/m at 500 cm/h, 1.402289e6 at 2763 cm/h.
TEST(KozenyCarman, GivesTheLineOfTheThesis) {
  EXPECT_NEAR(kozeny_carman_gradient(0.36, 93e-6, 1e-3, 500 * cm_h), 2.537620e5, 0.5);
  EXPECT_NEAR(kozeny_carman_gradient(0.36, 93e-6, 1e-3, 2763 * cm_h), 1.402289e6, 0.5);
}

TEST(BedReynolds, StaysBelowTenInTheThesisColumn) {  // fig. 7.2, for eps above 0.1
  EXPECT_LT(bed_reynolds(1000.0, 2763 * cm_h, 93e-6, 1e-3, 0.1), 10.0);
  EXPECT_NEAR(bed_reynolds(1000.0, 2763 * cm_h, 93e-6, 1e-3, 0.36), 1.983, 0.001);
}

TEST(FlowStokes, IsThatOfTheThesis) {  // 0.046 with its density 1150 kg/m3, section 8.1
  EXPECT_NEAR(flow_stokes(1150.0, 93e-6, 1e-3, 2763 * cm_h), 0.046, 0.0005);
}

}  // namespace
}  // namespace packbed::continuum
