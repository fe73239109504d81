// SPDX-License-Identifier: BSD-3-Clause
#include "io/bead_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/message_of.hpp"
#include "tests/support/temporary_folder.hpp"

namespace packbed::io {
namespace {

using testing::HasSubstr;

class BeadCsv : public testing::Test {
 protected:
  BeadTable read(std::string_view text) const { return read_bead_csv(folder_.file("b.csv", text)); }
  std::string refusal(std::string_view text) const {
    return test::message_of([&] { read(text); });
  }
  test::TemporaryFolder folder_;
};

TEST_F(BeadCsv, NeedsOnlyPositionAndDiameter) {
  const auto beads = read("x_m,y_m,z_m,diameter_m\n1e-3,2e-3,3e-3,9e-5\n");

  ASSERT_EQ(beads.size(), 1U);
  EXPECT_EQ(beads.x[0], (std::array{1e-3, 2e-3, 3e-3}));
  EXPECT_EQ(beads.diameter[0], 9e-5);
  EXPECT_EQ(beads.v[0], (std::array{0.0, 0.0, 0.0}));
  EXPECT_TRUE(beads.fixed.empty());
  EXPECT_TRUE(beads.density.empty());
}

TEST_F(BeadCsv, ReadsEveryColumnInAnyOrder) {
  const auto beads = read(
      "diameter_m,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s,fixed,density_kg_m3,"
      "youngs_modulus_Pa,poisson_ratio,resin\n"
      "9e-5,1,2,3,4,5,6,7,8,9,1,1140,3e7,0.2,SEP\n");

  EXPECT_EQ(beads.x[0], (std::array{1.0, 2.0, 3.0}));
  EXPECT_EQ(beads.v[0], (std::array{4.0, 5.0, 6.0}));
  EXPECT_EQ(beads.omega[0], (std::array{7.0, 8.0, 9.0}));
  EXPECT_TRUE(beads.fixed[0]);
  EXPECT_EQ(beads.density[0], 1140.0);
  EXPECT_EQ(beads.youngs_modulus[0], 3e7);
  EXPECT_EQ(beads.poisson_ratio[0], 0.2);
  EXPECT_EQ(beads.resin[0], "SEP");
}

TEST_F(BeadCsv, ReadsWhatItWrote) {
  const BeadRow row{.id = 12,
                    .x = {1.0 / 3.0, 2e-5, -0.1},
                    .v = {1e-300, 2.0, 3.0},
                    .w = {4.0, 5.0, 0.1 + 0.2},
                    .diameter = 86.9e-6,
                    .fixed = true,
                    .density = 1140.0,
                    .youngs_modulus = 3e7,
                    .poisson_ratio = 0.2,
                    .force = {1, 2, 3},
                    .torque = {4, 5, 6}};
  const auto file = folder_.path() / "beads.csv";

  write_bead_csv(file, {row});

  const auto beads = read_bead_csv(file);
  EXPECT_EQ(beads.id[0], 12);
  EXPECT_EQ(beads.x[0], row.x);
  EXPECT_EQ(beads.v[0], row.v);
  EXPECT_EQ(beads.omega[0], row.w);
  EXPECT_EQ(beads.diameter[0], row.diameter);
  EXPECT_TRUE(beads.fixed[0]);
  EXPECT_EQ(beads.youngs_modulus[0], row.youngs_modulus);
}

TEST_F(BeadCsv, RefusesIdsThatAreThereTwice) {
  EXPECT_THAT(refusal("id,x_m,y_m,z_m,diameter_m\n3,1,1,1,1e-4\n3,2,1,1,1e-4\n"),
              HasSubstr("b.csv:3: id = 3 must be a whole number"));
}

TEST_F(BeadCsv, RefusesMissingAndUnknownColumns) {
  EXPECT_THAT(refusal("x_m,y_m,z_m\n1,2,3\n"), HasSubstr("column \"diameter_m\" is missing"));
  EXPECT_THAT(refusal("x_m,y_m,z_m,diameter_m,vx\n1,2,3,4,5\n"),
              HasSubstr("unknown column \"vx\""));
  EXPECT_THAT(refusal("x_m,y_m,z_m,diametre_m\n1,2,3,4\n"),
              HasSubstr("did you mean \"diameter_m\"?"));
}

TEST_F(BeadCsv, RefusesValuesOutOfRangeNamingTheLine) {
  const std::string head = "x_m,y_m,z_m,diameter_m,density_kg_m3,poisson_ratio,fixed\n";
  EXPECT_THAT(refusal(head + "1,1,1,1e-4,1140,0.2,0\n1,1,1,0,1140,0.2,0\n"),
              HasSubstr("b.csv:3: diameter_m = 0 must be positive"));
  EXPECT_THAT(refusal(head + "1,1,1,1e-4,-1,0.2,0\n"), HasSubstr("density_kg_m3 = -1"));
  EXPECT_THAT(refusal(head + "1,1,1,1e-4,1140,0.6,0\n"), HasSubstr("outside (-1, 0.5]"));
  EXPECT_THAT(refusal(head + "1,1,1,1e-4,1140,0.2,2\n"), HasSubstr("must be 0 or 1"));
  EXPECT_THAT(refusal(head + "1,1,1,1e-4,1140,0.2,true\n"), HasSubstr("must be 0 or 1"));
  EXPECT_THAT(refusal(head + "nan,1,1,1e-4,1140,0.2,0\n"), HasSubstr("not a finite number"));
}

}  // namespace
}  // namespace packbed::io
