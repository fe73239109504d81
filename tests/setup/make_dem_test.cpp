// SPDX-License-Identifier: BSD-3-Clause
#include "setup/make_dem.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "setup/read_case.hpp"
#include "tests/support/temporary_folder.hpp"

namespace packbed::setup {
namespace {

class MakeDem : public testing::Test {
 protected:
  Case read(const std::string& column, const std::string& rest) const {
    (void)folder_.file("beads.csv", "x_m,y_m,z_m,diameter_m,vz_m_s\n0,0,1e-3,86.9e-6,-0.1\n");
    return read_case(folder_.file("case.toml", column +
                                                   "[resin]\nname = \"SEP\"\n[beads]\n"
                                                   "csv = \"beads.csv\"\n" +
                                                   rest),
                     units_);
  }
  test::TemporaryFolder folder_;
  UnitSystem units_;
  const std::string cylinder_ =
      "[column]\nshape = \"cylinder\"\ninner_diameter = \"5 mm\"\nheight = \"20 mm\"\n";
};

TEST_F(MakeDem, BuildsTheWallsOfTheShape) {
  const auto names = [](const std::vector<dem::Wall>& walls) {
    std::string all;
    for (const auto& wall : walls) all += wall.name + " ";
    return all;
  };
  EXPECT_EQ(names(make_walls(read(cylinder_, ""))), "tube floor lid ");
  EXPECT_EQ(names(make_walls(read("[column]\nshape = \"slice\"\ninner_diameter = \"5 mm\"\n"
                                  "slice_depth = \"1 mm\"\nheight = \"20 mm\"\n",
                                  ""))),
            "x_low x_high floor lid ");
  EXPECT_EQ(
      names(make_walls(read("[column]\nshape = \"box\"\nsize = [\"1 mm\", \"1 mm\", \"2 mm\"]\n"
                            "boundaries = { x = \"periodic\", y = \"open\" }\n",
                            ""))),
      "floor lid ");
}

TEST_F(MakeDem, WeighsBeadsInTheLiquidAndWithout) {
  const double volume = std::numbers::pi / 6.0 * std::pow(86.9e-6, 3);
  const auto weight = [&](const std::string& rest) {
    return make_beads(read(cylinder_, rest))[0].properties.weight;
  };
  EXPECT_NEAR(weight("") / (1140.0 * volume * gravity), 1.0, 1e-12);
  EXPECT_NEAR(weight("[liquid]\ndensity = \"1000 kg/m3\"\nviscosity = \"1 cP\"\n") /
                  (140.0 * volume * gravity),
              1.0, 1e-12);
  EXPECT_EQ(weight("[numerics]\ngravity = false\n"), 0.0);
}

TEST_F(MakeDem, TakesTheLawsOfTheResin) {
  const auto model = contact_model(read(cylinder_, ""));
  const auto& law = std::get<dem::Hooke>(model.contact);
  EXPECT_EQ(law.characteristic_velocity, 0.1);
  EXPECT_EQ(law.restitution, 0.5);
  EXPECT_EQ(std::get<dem::ElasticPlastic>(model.rolling).mu_r, 0.35);
  EXPECT_EQ(model.friction, 0.1);
}

TEST_F(MakeDem, ViscousRestitutionTakesTheLiquidsViscosity) {
  const auto c = read_case(
      folder_.file("v.toml", cylinder_ + "[resin]\nname = \"SEP\"\nviscous = true\n[liquid]\n"
                                         "density = \"1000 kg/m3\"\nviscosity = \"2 cP\"\n"),
      units_);
  const auto model = contact_model(c);
  const auto& law = std::get<dem::ViscousHooke>(model.contact);
  EXPECT_EQ(law.viscosity, 2e-3);
  EXPECT_EQ(law.restitution_max, 0.9);
  EXPECT_EQ(law.critical_stokes, 0.3);
}

// The plate contact of bead S lasts 6.280e-6 s undamped, pi sqrt(m / 98.011745 N/m); eight contacts
// of k = 37.209127 N/m, gamma = 3.678538e-5 kg/s on 0.4 m are stable up to 0.7672 us.
TEST_F(MakeDem, RecommendsAStepForBedsOfTheseBeads) {
  const auto choice = step_of(read(cylinder_, ""));
  EXPECT_NEAR(choice.contact_time, 6.2805e-6, 1e-9);
  EXPECT_NEAR(choice.stable_in_a_bed, 0.7672e-6, 1e-10);
  EXPECT_EQ(choice.step, 0.8 * choice.stable_in_a_bed);
  EXPECT_EQ(step_of(read(cylinder_, "[numerics]\nstep = \"1 ns\"\n")).step, 1e-9);
}

}  // namespace
}  // namespace packbed::setup
