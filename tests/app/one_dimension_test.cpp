// SPDX-License-Identifier: BSD-3-Clause
// `packbed bead fit`, `bead sizes`, `flow` and `wall-support` as a user calls them, with a user's mistakes.
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.hpp"

namespace packbed {
namespace {

using test::run_packbed;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

nlohmann::json figures(const std::string& arguments) {
  const auto outcome = run_packbed(arguments + " --json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return nlohmann::json::parse(outcome.out);
}

bool inside(const nlohmann::json& estimate, double truth) {
  return estimate["low"] <= truth && truth <= estimate["high"];
}

/// A file of data with a mistake, what is added to the command line, and the answer.
struct Mistake {
  std::string text, more;
  testing::Matcher<std::string> answer;
};

template <class CommandLine>
void expect_answers(const std::vector<Mistake>& mistakes, CommandLine command_line) {
  const test::TemporaryFolder folder;
  for (const auto& mistake : mistakes) {
    write_text_file(folder.path() / "data.csv", mistake.text);
    const auto outcome = run_packbed(command_line(mistake), folder.path());
    EXPECT_THAT(outcome.err, mistake.answer);
    EXPECT_EQ(outcome.code, 1) << mistake.text;
  }
}

const std::string bead = " --radius '30 um' --poisson 0.2";

TEST(BeadFit, OfTheExamplesFindsWhatTheyWereMadeOf) {
  const auto sls =
      figures("bead fit cases/bead/sls_slow.csv --model sls-maxwell" + bead)["curves"][0];
  EXPECT_TRUE(inside(sls["parameters"]["G0_Pa"], 1.62e6));
  EXPECT_TRUE(inside(sls["parameters"]["G1_Pa"], 3.51e6));
  EXPECT_TRUE(inside(sls["figures"]["eta_Pa_s"], 0.9e6));
  EXPECT_GT(sls["r2"], 0.99);
}

TEST(BeadFit, OfTheRelaxationsFindsWhatTheyWereMadeOf) {
  const auto relaxation = figures("bead fit cases/bead/relaxation.csv --model prony" + bead);

  ASSERT_EQ(relaxation["curves"].size(), 3U);
  EXPECT_EQ(relaxation["collapse"]["better"], "viscoelastic");
  for (const auto& curve : relaxation["curves"]) {
    EXPECT_TRUE(inside(curve["figures"]["G_relaxed_Pa"], 1.7e6)) << curve["curve"];
    EXPECT_EQ(curve["parameters"].size(), 5U) << curve["curve"];  // two times, chosen
  }
}

// Intervals by profile likelihood: not symmetric; they hold what the curve was made of.
TEST(BeadFit, GivesProfileIntervals) {
  const std::string line = "bead fit cases/bead/sls_slow.csv --model sls-maxwell" + bead;
  const auto linear = figures(line)["curves"][0];
  const auto profile = figures(line + " --intervals profile")["curves"][0];

  EXPECT_TRUE(inside(profile["parameters"]["G1_Pa"], 3.51e6));
  EXPECT_TRUE(inside(profile["figures"]["eta_Pa_s"], 0.9e6));
  for (const auto* name : {"G0_Pa", "G1_Pa", "tau_s"}) {
    const auto& p = profile["parameters"][name];
    const auto& l = linear["parameters"][name];
    EXPECT_EQ(p["error"], l["error"]);
    EXPECT_NE(p["low"], l["low"]);
    EXPECT_NEAR(p["low"].get<double>(), l["low"].get<double>(), 1.5 * l["error"].get<double>());
    EXPECT_NEAR(p["high"].get<double>(), l["high"].get<double>(), 1.5 * l["error"].get<double>());
  }
  EXPECT_THAT(run_packbed(line + " --intervals exact").err,
              HasSubstr("--intervals \"exact\" is not known; known are linear and profile"));
}

TEST(BeadFit, ThatStartsAtItsSolutionHasConverged) {
  const test::TemporaryFolder folder;
  write_text_file(folder.path() / "data.csv",
                  "time [s],displacement [um],force [uN]\n0,0,0\n1,1,1\n2,2,2.8\n3,3,5.2\n");
  const auto outcome = run_packbed("bead fit data.csv --model hertz" + bead, folder.path());
  EXPECT_THAT(outcome.out, testing::Not(HasSubstr("NOT CONVERGED")));
}

TEST(BeadFit, OfTheLoopGivesItsRestitution) {
  const auto loop = figures("bead fit cases/bead/loop.csv --model restitution")["curves"][0];
  EXPECT_NEAR(loop["restitution"], 0.956, 0.003);
}

TEST(BeadFit, AveragesOverBeads) {
  const auto j =
      figures("bead fit cases/bead/sls_slow.csv cases/bead/sls_slow.csv --model hertz" + bead);
  EXPECT_EQ(j["over_curves"][0]["E_Pa"]["curves"], 2);
  EXPECT_NEAR(j["over_curves"][0]["E_Pa"]["standard_deviation"], 0.0, 1e-3);
}

TEST(BeadFit, ReadsWhatBeadCompressWrote) {
  const test::TemporaryFolder folder;
  const auto csv = (folder.path() / "curve.csv").string();
  run_packbed("bead compress --model hertz --E '3.9 MPa'" + bead +
              " --speed '1 um/s' --time '4 s' --csv " + csv);
  EXPECT_NEAR(figures("bead fit " + csv + " --model hertz" +
                      bead)["curves"][0]["parameters"]["E_Pa"]["value"]
                      .get<double>() /
                  3.9e6,
              1.0, 1e-9);
}

// A user's mistakes, each with one line that names the file, what was found and what is accepted.
TEST(BeadFit, AnswersMistakesInTheDataOnOneLine) {
  const std::vector<Mistake> mistakes{
      {"time [s],displacement [um],force [um]\n0,0,0\n", "hertz",
       "packbed: data.csv:1: unit [um] of \"force\" is refused: it is a length, not a force; "
       "the header must be like "
       "\"time [s],displacement [um],force [uN]\"\n"},
      {"time [s],displacement [um]\n0,0\n", "hertz",
       "packbed: data.csv:1: column \"force\" is missing; the header must be like \"time "
       "[s],displacement [um],force [uN]\"\n"},
      {"time [s],displacement [um],force\n0,0,0\n", "hertz",
       "packbed: data.csv:1: column \"force\" has no unit; the header must be like \"time "
       "[s],displacement [um],force [uN]\"\n"},
      {"time [s],displacement [um],force [uN]\n0,0,0\n0,1,0,2,0,3\n", "hertz",
       "packbed: data.csv:3: cells in this row: 6, in the header: 3; decimals need points, "
       "not commas\n"},
      {"time [s];displacement [um];force [uN]\n0;0;0\n", "hertz",
       "packbed: data.csv:1: columns must be separated by commas (and decimals by points), "
       "not by semicolons\n"},
      {"time [s],displacement [um],force [uN]\n0,0,0\n2,1,1\n1,2,2\n", "hertz",
       "packbed: data.csv:4: the time 1 s comes after 2 s; rows must be in the order of time\n"},
      {"time [s],displacement [um],force [uN]\n0,0,0\n1,one,1\n", "hertz",
       "packbed: data.csv:3: displacement [um] = \"one\" is not a finite number\n"},
      {"time [s],displacement [um],force [uN]\n0,4,9\n1,4,8\n2,4,7\n",
       "prony --terms 2 --ramp-time '0 s'",
       StartsWith("packbed: data.csv: curve \"data\": 3 rows of data for 5 parameters; at "
                  "least 6 rows are needed")},
      {"time [s],displacement [um],force [uN]\n0,4,9\n1,4,8\n2,4,7\n", "prony",
       AllOf(HasSubstr("its speed is not known"), HasSubstr("give --ramp-time"))},
  };
  expect_answers(mistakes,
                 [](const Mistake& m) { return "bead fit data.csv --model " + m.more + bead; });
}

TEST(BeadFit, AcceptsCrlfAndByteOrderMark) {
  const test::TemporaryFolder folder;
  write_text_file(
      folder.path() / "data.csv",
      "\xEF\xBB\xBFtime [s],displacement [um],force [uN]\r\n0,0,0\r\n1,1,1\r\n2,2,2.828\r\n");
  EXPECT_EQ(run_packbed("bead fit data.csv --model hertz" + bead, folder.path()).code, 0);
}

TEST(BeadFit, NeedsARadius) {
  EXPECT_THAT(
      run_packbed("bead fit cases/bead/sls_slow.csv --model hertz --poisson 0.2").err,
      HasSubstr("the radius of the bead is not known; give --radius, or a column \"radius [um]\""));
}

TEST(BeadSizes, OfTheExample) {
  const auto j = figures("bead sizes cases/bead/sizes.csv");
  EXPECT_EQ(j["beads"], 166);
  double number = 0.0;
  for (const auto& bin : j["bins"]) number += bin["number_share"].get<double>();
  EXPECT_NEAR(number, 1.0, 1e-12);
  EXPECT_NEAR(j["bin_width_m"], 5e-6, 1e-18);
  EXPECT_GT(j["sauter_m"], j["mean_m"]);
}

TEST(BeadProperties, GivesTheWetDensityOfTable62) {
  const auto j =
      figures("bead properties --intraparticle-porosity 0.84 --dry-density '1.87 g/cm3'");
  EXPECT_NEAR(j["wet_density_kg_m3"], 1139.2, 1e-9);
  EXPECT_THAT(run_packbed("bead properties --radius '30 um' --compressed-height '48 um' "
                          "--compressed-radius '32 um'")
                  .err,
              HasSubstr("a bead does not grow when it is compressed"));
}

TEST(BeadXray, MixesMatrixAndLiquid) {
  const test::TemporaryFolder folder;
  write_text_file(folder.path() / "mu.csv",
                  "energy [keV],matrix [cm2/g],liquid [cm2/g]\n20,0.5,0.8\n");
  const auto outcome = run_packbed(
      "bead xray mu.csv --intraparticle-porosity 0.63 --dry-density '1.76 g/cm3' --thickness '9.6 "
      "mm' --json",
      folder.path());
  const auto row = nlohmann::json::parse(outcome.out)["rows"][0];
  const double w = 630.0 / 1281.2;  // eq. 7.1
  EXPECT_NEAR(row["bead_mass_attenuation_m2_kg"], 0.1 * (0.8 * w + 0.5 * (1 - w)), 1e-12);
  EXPECT_NEAR(row["absorbed_liquid"], 1 - std::exp(-0.08 * 1000 * 9.6e-3), 1e-12);  // eq. 5.2
}

TEST(Flow, GivesTheLineOfTheThesis) {  // fig. 7.1; case D4: 1.402289e6 Pa/m
  const auto j =
      figures("flow --porosity 0.36 --sauter '93 um' --velocity '2763 cm/h' --height '31 mm'");
  EXPECT_NEAR(j["kozeny_carman_Pa_m"].get<double>() / 1.402289e6, 1.0, 1e-6);
  EXPECT_NEAR(j["ergun_Pa_m"].get<double>() / 1.183779e6, 1.0, 1e-6);
  EXPECT_NEAR(j["kozeny_carman_Pa"].get<double>(), j["kozeny_carman_Pa_m"].get<double>() * 0.031,
              1e-6);
  EXPECT_EQ(j["regime"], "laminar");
}

TEST(Flow, ReadsAFlowRate) {  // 2 L/h in 9.6 mm are 2763 cm/h
  EXPECT_NEAR(
      figures("flow --porosity 0.36 --sauter '93 um' --flow-rate '2 L/h' --diameter '9.6 mm'")
              ["superficial_velocity_m_s"]
                  .get<double>() *
          3.6e5,
      2763.1, 0.05);
  EXPECT_THAT(run_packbed("flow --porosity 0.36 --sauter '93 um' --flow-rate '2 L/h'").err,
              HasSubstr("--flow-rate needs --diameter"));
  EXPECT_THAT(run_packbed("flow --porosity 0.36 --velocity '2 L/h' --sauter '93 um'").err,
              HasSubstr("it is a volume flow, not a velocity"));
}

TEST(Flow, ConvertsCompressions) {
  const auto j = figures("flow convert --factor 1.15 --settled-porosity 0.4");
  EXPECT_NEAR(j["compression"], 0.1304348, 1e-7);
  EXPECT_NEAR(j["packing_density"], 0.69, 1e-12);
  EXPECT_THAT(run_packbed("flow convert --factor 1.15 --compression 0.1").err,
              HasSubstr("give exactly one of"));
  EXPECT_THAT(run_packbed("flow convert --compression 0.5 --settled-porosity 0.4").err,
              HasSubstr("leaves no pores"));
}

TEST(Flow, ProfilesTheWall) {  // case P5: area mean 0.402999 for D/d = 16, y_min 0.516685 d
  const auto j = figures("flow wall --diameter '16 mm' --bead-diameter '1 mm'");
  EXPECT_NEAR(j["y_min_per_bead"], 0.516685, 1e-6);
  EXPECT_NEAR(j["porosity_mean"], 0.402999, 2e-6);
}

const std::string sep = "wall-support --resin 'CM Sepharose 6FF' --height '30 mm' ";

TEST(WallSupport, OfOneColumn) {
  const auto j = figures(sep + "--diameter '9.6 mm' --velocity '636.6198 cm/h'");
  EXPECT_NEAR(j["pressure_drop_per_height_Pa_m"].get<double>() / 5.127164e5, 1.0, 1e-6);  // W4
  EXPECT_NEAR(j["compression"], 0.037484, 1e-6);
  EXPECT_NEAR(j["critical_velocity_m_s"].get<double>() * 3.6e5, 1048.95, 1.0);
  EXPECT_NEAR(j["bottom_stress_Pa"].get<double>(), 0.101e6 * j["bottom_compression"].get<double>(),
              1e-6);
  EXPECT_FALSE(j["extrapolated"]);
}

TEST(WallSupport, BeyondCollapseGivesNoNumber) {  // W8
  const auto outcome = run_packbed(sep + "--diameter '9.6 mm' --velocity '1100 cm/h' --json");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, StartsWith("packbed: no steady state above u_crit = 1048.9"));
}

TEST(WallSupport, FlagsExtrapolation) {  // SEP was calibrated to 0.05701
  EXPECT_TRUE(figures(sep + "--diameter '50 mm' --velocity '636.6198 cm/h'")["extrapolated"]);
}

TEST(WallSupport, OverridesTheLibrary) {  // W2: without wall; gravity remains, so a little less
  const auto j = figures(sep + "--no-wall --velocity '100 cm/h' --density-difference '0 kg/m3'");
  EXPECT_NEAR(j["critical_velocity_m_s"].get<double>() * 3.6e5, 620.2076, 1e-3);
  EXPECT_THAT(
      run_packbed("wall-support --height '30 mm' --diameter '1 cm' --velocity '1 cm/h'").err,
      HasSubstr("--B is missing"));
  EXPECT_THAT(
      run_packbed(
          "wall-support --resin MabSelect --height '30 mm' --diameter '1 cm' --velocity '1 cm/h'")
          .err,
      HasSubstr("the library has no bed_modulus of \"MabSelect\"; give --B"));
}

TEST(WallSupport, SweepsTheDiameterWithTheLogarithmicFit) {
  const auto j = figures(
      "wall-support diameters --resin 'Toyopearl SP-650M' --height '30 mm' --velocity '636.6198 "
      "cm/h' --diameter '9.6 mm' --diameter '12.5 mm' --diameter '16.25 mm' --diameter '20 mm' "
      "--diameter '50 mm'");
  EXPECT_EQ(j["points"].size(), 5U);
  EXPECT_NEAR(j["points"][4]["pressure_drop_per_height_Pa_m"].get<double>(), 17.182357e5, 5.0);
  EXPECT_GT(j["pressure_drop_bar_m_over_ln_mm"]["r2"], 0.97);
}

TEST(WallSupport, SweepsLeaveOutWhatIsNotSteady) {
  const test::TemporaryFolder folder;
  const auto csv = (folder.path() / "sweep.csv").string();
  const auto svg = (folder.path() / "sweep.svg").string();
  const auto j = figures(
      "wall-support velocities --resin SEP --height '30 mm' --diameter '20 mm' --to '1000 cm/h' "
      "--points 11 --csv " +
      csv + " --plot " + svg);
  EXPECT_TRUE(j["points"][8]["steady"]);  // 800 cm/h, u_crit = 816.89
  EXPECT_FALSE(j["points"][9]["steady"]);
  EXPECT_FALSE(j["points"][9].contains("pressure_drop_Pa"));
  EXPECT_THAT(read_text_file(csv), testing::Not(HasSubstr("nan")));
  EXPECT_THAT(read_text_file(svg), HasSubstr("D = 20 mm"));
}

TEST(WallSupport, ReadsAModulusTable) {
  const test::TemporaryFolder folder;
  write_text_file(folder.path() / "b.csv", "compression,modulus [MPa]\n0.03,0.101\n0.2,0.101\n");
  const auto outcome = run_packbed(
      "wall-support --resin SEP --modulus-table b.csv --height '30 mm' --diameter '9.6 mm' "
      "--velocity '636.6198 cm/h' --json",
      folder.path());
  EXPECT_NEAR(nlohmann::json::parse(outcome.out)["compression"], 0.037484, 1e-6);
}

TEST(WallSupportFitCommand, RefitsTheThesis) {
  const auto j = figures(
      "wall-support fit cases/wall_support/thesis_toy.csv --resin 'Toyopearl SP-650M' --height '30 "
      "mm' --free B,bead-diameter,wall-friction");
  EXPECT_GT(j["r2_pressure_gradient"], 0.98);
  EXPECT_GT(j["r2_compression"], 0.8);
  EXPECT_NEAR(j["parameters"]["B_Pa"]["value"].get<double>() / 0.164e6, 1.0, 0.1);
  EXPECT_NEAR(j["calibrated_compression"], 0.08946, 1e-12);
}

TEST(WallSupportFitCommand, AnswersMistakesOnOneLine) {
  const std::string tail =
      "; the header must be like \"diameter [mm],velocity [cm/h],pressure_gradient "
      "[bar/m],compression\"\n";
  const std::vector<Mistake> mistakes{
      {"diameter [mm],velocity [cm/h]\n9.6,637\n", " --height '30 mm'",
       "packbed: data.csv:1: column \"pressure_gradient\" is missing" + tail},
      {"diameter [mm],velocity [cm/h],pressure_gradient [bar]\n9.6,637,5\n", " --height '30 mm'",
       "packbed: data.csv:1: unit [bar] of \"pressure_gradient\" is refused: it is not a "
       "pressure per m" +
           tail},
      {"diameter [mm],velocity [mm],pressure_gradient [bar/m]\n9.6,637,5\n", " --height '30 mm'",
       "packbed: data.csv:1: unit [mm] of \"velocity\" is refused: it is a length, not a velocity" +
           tail},
      {"diameter [mm],velocity [cm/h],pressure_gradient [bar/m]\n9.6,637,-5\n", " --height '30 mm'",
       "packbed: data.csv:2: pressure_gradient must be positive\n"},
      {"diameter [mm],velocity [cm/h],pressure_gradient [bar/m]\n9.6,637,5\n", "",
       "packbed: data.csv:1: the settled height is not known; give --height, or a column "
       "\"height [mm]\"\n"},
      {"diameter [mm],velocity [cm/h],pressure_gradient "
       "[bar/m]\n9.6,637,5\n12.5,637,5\n20,637,6\n",
       " --height '30 mm' --free B,bead-diameter,wall-friction,poisson,settled-porosity",
       "packbed: data.csv: 3 rows of data for 5 parameters; at least 6 rows are needed, or a model "
       "with fewer parameters\n"},
      {"diameter [mm],velocity [cm/h],pressure_gradient [bar/m]\n9.6,637,5\n",
       " --height '30 mm' --free B,colour",
       HasSubstr("--free: \"colour\" is not a parameter of the bed; known are B, bead-diameter")},
  };
  expect_answers(mistakes,
                 [](const Mistake& m) { return "wall-support fit data.csv --resin SEP" + m.more; });
}

}  // namespace
}  // namespace packbed
