// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/settled_porosity.hpp"

#include <gtest/gtest.h>

namespace packbed::column {
namespace {

TEST(SettledPorosity, IsWhatWasMeasured) {
  EXPECT_DOUBLE_EQ(settled_porosity(0.1, 0.35), 0.3930);
  EXPECT_DOUBLE_EQ(settled_porosity(0.1, 0.0), 0.3778);
  EXPECT_NEAR(settled_porosity(0.1, 0.1), 0.3880, 1e-3);
  EXPECT_NEAR(settled_porosity(0.5, 0.1), 0.4352, 3e-3);
  EXPECT_DOUBLE_EQ(settled_porosity(3.0, 0.35), settled_porosity(0.5, 0.35));
}

TEST(SettledPorosity, TellsTheFrictionForIt) {
  for (const double rolling : {0.0, 0.1, 0.35, 1.0}) {
    for (double friction = 0.0; friction <= 0.5; friction += 0.05) {
      EXPECT_NEAR(settling_friction(settled_porosity(friction, rolling), rolling), friction, 1e-9);
    }
  }
  EXPECT_NEAR(settling_friction(0.6, 0.35), 0.5, 1e-9);
}

TEST(SettledPorosity, TellsTheContactsOfABedThatSettledToIt) {
  EXPECT_NEAR(settled_coordination(0.3930, 0.35), 4.93, 1e-9);
  EXPECT_NEAR(settled_coordination(0.3778, 0.0), 5.18, 1e-9);
  EXPECT_NEAR(settled_coordination(0.38540, 0.35), 5.135, 1e-3);  // half way from 0.3778 to 0.3930
  EXPECT_NEAR(settled_coordination(0.3880, 0.1), 4.96, 0.1);      // measured apart
  EXPECT_NEAR(settled_coordination(0.30, 0.35), 5.90, 1e-9);      // held at the ends
}

}  // namespace
}  // namespace packbed::column
