// SPDX-License-Identifier: BSD-3-Clause
#include "continuum/water.hpp"

#include <gtest/gtest.h>

namespace packbed::continuum {
namespace {

constexpr double celsius = 273.15;

// Check values of IAPWS SR6-08(2011), table 5, at 260 K and 298.15 K.
TEST(Water, MeetsTheCheckValuesOfItsSource) {
  EXPECT_NEAR(water_density(260.0), 997.0683602710492, 1e-9);
  EXPECT_NEAR(water_density(298.15), 997.047013, 1e-5);
}

// ISO/TR 3666: water at 20 degC has 1.0016 mPa s. The density has its maximum, 999.975 kg/m3, at
// 3.98 degC (Kell 1975); 998.207 kg/m3 at 20 degC.
TEST(Water, AgreesWithTheStandards) {
  EXPECT_NEAR(water_viscosity(celsius + 20.0), 1.0016e-3, 0.0002e-3);
  EXPECT_NEAR(water_density(celsius + 20.0), 998.207, 0.001);
  EXPECT_NEAR(water_density(celsius + 3.98), 999.975, 0.001);
  EXPECT_GT(water_density(celsius + 3.98), water_density(celsius + 3.0));
  EXPECT_GT(water_density(celsius + 3.98), water_density(celsius + 5.0));
}

}  // namespace
}  // namespace packbed::continuum
