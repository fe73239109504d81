// SPDX-License-Identifier: BSD-3-Clause
// What is refused is shown by cases/errors/measured_*.toml (tests/app).
#include "setup/read_measured.hpp"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace packbed::setup {
namespace {

class Measured : public testing::Test {
 protected:
  MeasuredFlow read(std::string_view text) {
    return read_measured(folder_.file("lab.csv", text), units_);
  }
  test::TemporaryFolder folder_;
  UnitSystem units_;
};

TEST_F(Measured, ComesInAnyUnitsAndOrder) {
  const auto m = read(
      "bed height [cm],superficial velocity [mm/s],compression [%],pressure drop per height "
      "[kPa/m],"
      "pressure drop [mbar]\n# up\n3.1,1,5,100,31\n");

  EXPECT_DOUBLE_EQ(m.superficial_velocity.at(0), 1e-3);
  EXPECT_DOUBLE_EQ(m.bed_height.at(0), 0.031);
  EXPECT_DOUBLE_EQ(m.compression.at(0), 0.05);
  EXPECT_DOUBLE_EQ(m.pressure_gradient.at(0), 1e5);
  EXPECT_DOUBLE_EQ(m.pressure_drop.at(0), 3100.0);
}

TEST_F(Measured, TakesADashAsTheUnitOfAFraction) {
  EXPECT_EQ(read("superficial velocity [m/s],compression [-]\n1,0.25\n").compression.at(0), 0.25);
  EXPECT_EQ(read("superficial velocity [m/s],compression\n1,0.25\n").compression.at(0), 0.25);
}

TEST_F(Measured, IsWrittenSoThatItReadsToTheSameBits) {
  const auto m = read(
      "superficial velocity [cm/h],pressure drop per height [bar/m],compression [%]\n"
      "276.3,0.77,0.3\n553,1.61,-0.01\n");

  EXPECT_EQ(read(to_csv(m)), m);
}

}  // namespace
}  // namespace packbed::setup
