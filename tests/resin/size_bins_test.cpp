// SPDX-License-Identifier: BSD-3-Clause
#include "resin/size_bins.hpp"

#include <gtest/gtest.h>

#include "tests/support/message_of.hpp"

namespace packbed::resin {
namespace {

// Four beads of 51, 54, 55, 62 um: bins from 50 um; cubes 132651, 157464, 166375, 238328, sum 694818.
TEST(SizeBins, CountBeadsAndTheirVolume) {
  const std::vector<double> d{55e-6, 51e-6, 62e-6, 54e-6};

  const auto bins = size_bins(d, 5e-6);

  ASSERT_EQ(bins.size(), 3U);
  EXPECT_NEAR(bins[0].lower, 50e-6, 1e-12);
  EXPECT_NEAR(bins[2].upper, 65e-6, 1e-12);
  EXPECT_DOUBLE_EQ(bins[0].number_share, 0.5);
  EXPECT_DOUBLE_EQ(bins[1].number_share, 0.25);  // 55 um belongs above its edge
  EXPECT_NEAR(bins[0].volume_share, 290115.0 / 694818.0, 1e-12);
  EXPECT_NEAR(bins[0].number_density(), 0.5 / 5e-6, 1e-6);
  EXPECT_DOUBLE_EQ(bins[1].number_below_upper, 0.75);
  EXPECT_NEAR(bins[2].volume_below_upper, 1.0, 1e-14);
}

TEST(SizeBins, RefuseWidthsThatMakeNoSense) {
  const std::vector<double> d{55e-6, 5.0};
  EXPECT_EQ(test::message_of([&] { size_bins(d, 0.0); }), "the width of a bin must be positive");
  EXPECT_EQ(test::message_of([&] { size_bins(d, 5e-6); }),
            "999990 bins would be needed; take wider ones");
}

}  // namespace
}  // namespace packbed::resin
