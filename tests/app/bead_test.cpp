// SPDX-License-Identifier: BSD-3-Clause
// `packbed bead compress` and `packbed bead relax` as a user calls them.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.hpp"

namespace packbed {
namespace {

using test::run_packbed;
using testing::HasSubstr;

const std::string sls =
    "--radius '30 um' --poisson 0.2 --G0 '1.62 MPa' --G1 '3.51 MPa' --eta '0.9 MPa s' ";
const std::string bead = "--radius '30 um' --poisson 0.2 ";

nlohmann::json figures(const std::string& arguments) {
  const auto outcome = run_packbed(arguments + " --json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return nlohmann::json::parse(outcome.out);
}

double force(const std::string& arguments) { return figures(arguments)["force_N"]; }

TEST(BeadCompress, GivesTheForcesOfTheReference) {  // B1: 116.0210038 uN
  const std::string end = "--speed '0.9 um/s' --time '5 s'";
  EXPECT_NEAR(force("bead compress --model sls-maxwell " + sls + end) / 116.0210038e-6, 1.0, 1e-9);
  // Hertz with E = 2.4 G: (2/3) sqrt(2R)/(1 - nu) G Delta^1.5 worked out: 99.76... by eq. C.20.
  const double hertz = 2.0 / 3.0 * std::sqrt(60e-6) / 0.8 * 1.62e6 * std::pow(4.5e-6, 1.5);
  EXPECT_NEAR(force("bead compress --model hertz --E '3.888 MPa' " + bead + end) / hertz, 1.0,
              1e-12);
  // A Prony series of 2 G with the halves of the SLS is the same bead.
  EXPECT_NEAR(
      force("bead compress --model prony --C0 '3.24 MPa' --term '7.02 MPa,0.2564102564102564 s' " +
            bead + end) /
          116.0210038e-6,
      1.0, 1e-9);
  // Hooke: k of bead S on a rigid plate (see elastic_test) times half the displacement.
  EXPECT_NEAR(force("bead compress --model hooke --E '30 MPa' --density '1140 kg/m3' "
                    "--characteristic-velocity '0.1 m/s' --radius '43.45 um' --poisson 0.2 " +
                    end) /
                  (37.209127 * std::pow(2.0, 1.4) * 2.25e-6),
              1.0, 1e-7);
}

TEST(BeadCompress, TakesTheConstantOfAPronySeriesAsATerm) {
  const std::string end = " --term '7.02 MPa,0.3 s' --speed '0.9 um/s' --time '5 s'";
  EXPECT_DOUBLE_EQ(force("bead compress --model prony --C0 '3.24 MPa' " + bead + end),
                   force("bead compress --model prony --term '3.24 MPa,inf' " + bead + end));
}

TEST(BeadCompress, KelvinIsTheOtherSolid) {  // C.15: relaxed modulus G0 G1 / (G0 + G1)
  const auto j =
      figures("bead compress --model sls-kelvin " + sls + "--speed '0.9 um/s' --time '5 s'");
  EXPECT_NEAR(j["shear_modulus_relaxed_Pa"].get<double>() / (1.62e6 * 3.51 / 5.13), 1.0, 1e-12);
  EXPECT_NEAR(j["shear_modulus_instantaneous_Pa"].get<double>() / 1.62e6, 1.0, 1e-12);
}

TEST(BeadCompress, WritesTheCurveAndItsPlot) {
  const test::TemporaryFolder folder;
  const auto csv = (folder.path() / "curve.csv").string();
  const auto svg = (folder.path() / "curve.svg").string();

  const auto j = figures("bead compress --model sls-maxwell " + sls +
                         "--speed '0.9 um/s' --time '5 s' --unload --points 11 --csv " + csv +
                         " --plot " + svg);

  const auto text = read_text_file(csv);
  EXPECT_THAT(text, HasSubstr("time_s,displacement_m,force_N\n0,0,0\n1,9.000"));
  EXPECT_THAT(text, HasSubstr("\n5,4.5e-06,0.000116021"));
  EXPECT_THAT(read_text_file(svg), HasSubstr("displacement of the plates [um]"));
  EXPECT_LT(j["restitution"].get<double>(), 1.0);
  EXPECT_NEAR(std::sqrt(j["work_unloading_J"].get<double>() / j["work_loading_J"].get<double>()),
              j["restitution"].get<double>(), 1e-12);
}

TEST(BeadRelax, StartsAtTheEndOfTheRampAndEndsRelaxed) {
  const std::string line =
      "bead relax --model sls-maxwell " + sls + "--depth '4.5 um' --speed '0.9 um/s' ";
  const auto start = figures(line + "--time '0 s'");
  EXPECT_NEAR(start["force_N"].get<double>() / 116.0210038e-6, 1.0, 1e-9);
  EXPECT_NEAR(start["ramp_time_s"].get<double>(), 5.0, 1e-12);
  const double relaxed = 2.0 / 3.0 * std::sqrt(60e-6) / 0.8 * 1.62e6 * std::pow(4.5e-6, 1.5);
  EXPECT_NEAR(force(line + "--time '100 s'") / relaxed, 1.0, 1e-10);
}

TEST(BeadRelax, OfAPoroelasticBead) {  // B5: F0 = 1.6 F_inf at nu = 0.2
  const std::string line =
      "bead relax --model poroelastic " + bead +
      "--G0 '1.62 MPa' --pore-radius '20 nm' --intraparticle-porosity 0.84 --depth '4 um' ";
  EXPECT_NEAR(force(line + "--time '0 s'") / force(line + "--time '1000 h'"), 1.6, 1e-9);
  EXPECT_FALSE(figures(line + "--time '0 s'").contains("note"));
}

TEST(BeadCompress, OfAPoroelasticBeadLiesBetweenItsLimitsAndSaysThatItIsApproximate) {
  const std::string line = "bead compress --model poroelastic " + bead +
                           "--G0 '1.62 MPa' --pore-radius '20 nm' --intraparticle-porosity 0.84 ";
  const auto slow = force(line + "--speed '1 pm/s' --time '4e6 s'");
  EXPECT_NEAR(force(line + "--speed '1 km/s' --time '4 ns'") / slow, 1.6, 1e-3);
  EXPECT_GT(force(line + "--speed '10 um/s' --time '0.4 s'"), slow);
  EXPECT_THAT(figures(line + "--speed '10 um/s' --time '0.4 s'")["note"].get<std::string>(),
              HasSubstr("approximation"));
}

TEST(Bead, RefusesOnOneLine) {
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {"compress --radius '30 um'",
       "packbed: --model is missing; known are hertz, hooke, sls-maxwell, sls-kelvin, prony "
       "or poroelastic\n"},
      {"compress --model hurtz",
       "packbed: --model \"hurtz\" is not known; known are hertz, hooke, sls-maxwell, "
       "sls-kelvin, prony or poroelastic\n"},
      {"compress --model hertz --radius '30 MPa' --poisson 0.2",
       "packbed: --radius = \"30 MPa\" is refused: it is a pressure, not a length; give a "
       "length such as \"90 um\"\n"},
      {"compress --model hertz " + bead + "--G0 '1 MPa'",
       "packbed: --G0 does not apply to --model hertz; leave it out\n"},
      {"compress --model prony " + bead + "--C0 '1 MPa'",
       "packbed: --term is missing; give modulus and time such as \"0.4 MPa,12 s\"\n"},
      {"compress --model prony " + bead + "--C0 '1 MPa' --term '1 MPa'",
       "packbed: --term = \"1 MPa\" is refused: it has no comma; give modulus and time such "
       "as \"0.4 MPa,12 s\"\n"},
      {"compress --model poroelastic " + bead +
           "--G0 '1 MPa' --pore-radius '20 nm' --intraparticle-porosity 0.8 --unload",
       "packbed: --unload does not apply to --model poroelastic, whose contact shrinks in a way "
       "that "
       "is not known; leave it out\n"},
      {"relax --model hertz --E '1 MPa' --radius '30 um' --poisson 0.7 --depth '1 um' --time "
       "'1 s'",
       "packbed: --poisson = \"0.7\" is outside (-1, 0.5]; give a fraction such as \"0.38\"\n"},
  };
  for (const auto& [arguments, message] : mistakes) {
    const auto outcome = run_packbed("bead " + arguments);
    EXPECT_EQ(outcome.err, message);
    EXPECT_EQ(outcome.code, 1) << arguments;
  }
}

}  // namespace
}  // namespace packbed
