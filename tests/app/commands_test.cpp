// SPDX-License-Identifier: BSD-3-Clause
// The program as a user calls it.
#include <algorithm>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.hpp"

namespace packbed {
namespace {

using test::run_packbed;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Program, TellsItsVersionAndHelp) {
  EXPECT_THAT(run_packbed("--version").out, HasSubstr("packbed 0."));
  EXPECT_EQ(run_packbed("--help").code, 0);
  EXPECT_THAT(run_packbed("--help").out, HasSubstr("resins"));
  for (const auto* command : {"run", "check", "resins", "units"}) {
    EXPECT_THAT(run_packbed(std::string(command) + " --help").out, HasSubstr("--json"));
  }
}

TEST(Program, RefusesUnknownCommandsAndOptionsOnOneLine) {
  EXPECT_THAT(run_packbed("chek x").err, HasSubstr("did you mean \"check\"?"));
  EXPECT_EQ(run_packbed("chek x").code, 1);
  EXPECT_EQ(run_packbed("check --nonsense cases/quickstart.toml").code, 1);
  EXPECT_EQ(run_packbed("check").code, 1);
  EXPECT_EQ(run_packbed("check no/such/case.toml").code, 3);
  EXPECT_EQ(run_packbed("check no/such/case.toml").err,
            "packbed: no/such/case.toml: cannot be opened (No such file or directory)\n");
}

TEST(Check, OfTheQuickstartIsACaseFileAgain) {
  const test::TemporaryFolder folder;
  const auto first = run_packbed("check cases/quickstart.toml");
  ASSERT_EQ(first.code, 0) << first.err;
  const auto again = folder.file("quickstart.toml", first.out);

  const auto a = nlohmann::json::parse(run_packbed("check --json cases/quickstart.toml").out);
  const auto b = nlohmann::json::parse(run_packbed("check --json " + again.string()).out);

  EXPECT_EQ(a, b);
  EXPECT_EQ(a["case"]["column"]["inner_diameter_m"], 4e-3);
  EXPECT_EQ(a["case"]["protocol"].size(), 3U);
  EXPECT_GT(a["figures"]["bed"]["height_m"], 0.0);
}

TEST(Check, DrawsTheMesh) {
  const test::TemporaryFolder folder;
  const auto svg = (folder.path() / "mesh.svg").string();

  const auto check = run_packbed("check cases/quickstart.toml --mesh-svg " + svg);

  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_THAT(read_text_file(svg), HasSubstr("11 cells in a layer"));
  EXPECT_EQ(run_packbed("check cases/01_two_beads_collide/case.toml --mesh-svg " + svg).err,
            "packbed: cases/01_two_beads_collide/case.toml: --mesh-svg: there is no mesh without a "
            "[liquid]; leave the option out, or give a liquid\n");
}

TEST(Check, IsTheSameUnderADecimalCommaLocale) {
  const auto plain = run_packbed("check cases/quickstart.toml");
  const auto german = test::run_shell(
      std::string("LC_ALL=de_DE.UTF-8 ") + PACKBED_PROGRAM + " check cases/quickstart.toml",
      PACKBED_SOURCE_DIR);
  EXPECT_EQ(german.out, plain.out);
}

/// A column that nothing says the beads of.
std::filesystem::path case_without_beads(const test::TemporaryFolder& folder,
                                         const std::string& name = "empty.toml") {
  return folder.file(
      name,
      "[column]\nshape = \"slice\"\ninner_diameter = \"5 mm\"\nslice_depth = \"1 mm\"\n"
      "height = \"10 mm\"\n[resin]\nname = \"CM Sepharose 6FF\"\n"
      "[[protocol]]\nstep = \"run\"\nduration = \"1 ms\"\n");
}

TEST(Run, WritesTheFullCaseAndSaysWhatItDidNotDo) {
  const test::TemporaryFolder folder;
  const auto out = (folder.path() / "résultat 1").string();

  const auto run = run_packbed("run " + case_without_beads(folder).string() + " -o '" + out + "'");

  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("NOT SIMULATED"));
  EXPECT_EQ(run_packbed("check '" + out + "/case.toml'").code, 0);
  const auto summary = nlohmann::json::parse(read_text_file(out + "/summary.json"));
  EXPECT_EQ(summary["steps_carried_out"], 0);
}

TEST(Run, CollidesTwoBeadsOfAFile) {
  const test::TemporaryFolder folder;
  const auto out = folder.path().string();

  const auto run = run_packbed("run cases/01_two_beads_collide/case.toml -o " + out);

  ASSERT_EQ(run.code, 0) << run.err;
  const auto last = read_text_file(out + "/frames/beads_000020.csv");  // half of 0.05 m/s, turned
  EXPECT_THAT(last, ContainsRegex("\n0,[^,]*,0.0005,0.0005,8.69e-05,-0.025"));
  EXPECT_THAT(last, ContainsRegex("\n1,[^,]*,0.0005,0.0005,8.69e-05,0.025"));
  EXPECT_THAT(read_text_file(out + "/series.csv"), HasSubstr("time_s,step,stage,mean_overlap_m"));
  const auto summary = nlohmann::json::parse(read_text_file(out + "/summary.json"));
  EXPECT_EQ(summary["bead_steps"], 4000);
  EXPECT_EQ(summary["steps_carried_out"], 1);
}

TEST(Run, WritesTheSameOnSeveralRanks) {
  const test::TemporaryFolder folder;
  const auto out = folder.path().string();
  // They collide along z, across the border of two ranks; a third one has escaped far away.
  const auto file = folder.file(
      "case.toml", read_text_file(PACKBED_SOURCE_DIR "/cases/01_two_beads_collide/case.toml"));
  (void)folder.file("beads.csv",
                    "x_m,y_m,z_m,diameter_m,vx_m_s,vy_m_s,vz_m_s\n"
                    "0.5e-3,0.5e-3,0.4565e-3,86.9e-6,0,0,0.05\n"
                    "0.5e-3,0.5e-3,0.5435e-3,86.9e-6,0,0,-0.05\n"
                    "0.5e-3,0.5e-3,-10,86.9e-6,0,0,0\n");
  const std::string arguments = "run " + file.string() + " -o " + out;
  ASSERT_EQ(run_packbed(arguments + "/one -n 1").code, 0);
  const auto two = test::run_on_ranks(2, arguments + "/two");
  ASSERT_EQ(two.code, 0) << two.err;

  for (const auto* name : {"/series.csv", "/frames/beads_000010.csv"}) {
    EXPECT_EQ(read_text_file(out + "/one" + name), read_text_file(out + "/two" + name)) << name;
  }
  const auto again = test::run_on_ranks(2, arguments + "/two");
  EXPECT_EQ(again.code, 1);
  EXPECT_EQ(std::ranges::count(again.err, '\n'), 1) << again.err;
}

// NOLINTNEXTLINE(readability-function-cognitive-complexity): that of the macros
TEST(Run, TakesNothingAwayThatItReads) {
  const test::TemporaryFolder folder;
  const std::string source = PACKBED_SOURCE_DIR "/cases/01_two_beads_collide/";
  const auto text = read_text_file(source + "case.toml");
  const auto file = folder.file("case.toml", text);
  (void)folder.file("beads.csv", read_text_file(source + "beads.csv"));
  const auto out = folder.path().string();
  ASSERT_EQ(run_packbed("run " + file.string() + " -o " + out + "/r").code, 0);
  auto from_frame = text;
  from_frame.replace(from_frame.find("beads.csv"), 9, "r/frames/beads_000010.csv");
  const auto again = folder.file("again.toml", from_frame);

  for (const auto* ranks : {" -n 1", " -n 2"}) {
    const auto here = run_packbed("run " + file.string() + " --overwrite -o " + out + ranks);
    EXPECT_EQ(here.code, 1);
    EXPECT_THAT(here.err, HasSubstr("case.toml: the run reads this file and would replace it"));
    EXPECT_EQ(read_text_file(file), text);
    const auto frame =
        run_packbed("run " + again.string() + " --overwrite -o " + out + "/r" + ranks);
    EXPECT_EQ(frame.code, 1);
    EXPECT_TRUE(std::filesystem::exists(out + "/r/frames/beads_000010.csv"));
  }
}

TEST(Run, LeavesWhatIsNotItsOwnAndAsksForInterruptedRuns) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "frames");
  (void)folder.file("frames/mine.txt", "mine");
  (void)folder.file("series.csv", "of a run that was interrupted");
  const auto arguments = "run cases/01_two_beads_collide/case.toml -o " + folder.path().string();

  EXPECT_EQ(run_packbed(arguments).code, 1);
  EXPECT_EQ(read_text_file(folder.path() / "series.csv"), "of a run that was interrupted");
  EXPECT_EQ(run_packbed(arguments + " --overwrite").code, 0);
  EXPECT_EQ(read_text_file(folder.path() / "frames/mine.txt"), "mine");
}

TEST(Run, RefusesAStepThatDoesNotResolveContacts) {
  const test::TemporaryFolder folder;
  auto text = read_text_file(PACKBED_SOURCE_DIR "/cases/01_two_beads_collide/case.toml");
  text.replace(text.find("5 ns"), 4, "2 us");
  const auto file = folder.file("case.toml", text);
  (void)folder.file("beads.csv",
                    read_text_file(PACKBED_SOURCE_DIR "/cases/01_two_beads_collide/beads.csv"));
  const auto run = run_packbed("run " + file.string() + " -o " + (folder.path() / "out").string());
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("leaves 3.6 steps to the shortest contact"));
}

TEST(Run, DoesNotOverwriteResultsUnasked) {
  const test::TemporaryFolder folder;
  const auto arguments =
      "run " + case_without_beads(folder).string() + " -o " + (folder.path() / "out").string();
  ASSERT_EQ(run_packbed(arguments).code, 0);

  EXPECT_EQ(run_packbed(arguments).code, 1);
  EXPECT_THAT(run_packbed(arguments).err, HasSubstr("--overwrite"));
  EXPECT_EQ(run_packbed(arguments + " --overwrite").code, 0);
}

TEST(Run, SaysWhyItsFolderCannotBeMade) {
  const test::TemporaryFolder folder;
  const auto file = folder.file("file", "");
  const auto run = run_packbed("run cases/quickstart.toml -o " + (file / "sub").string());
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("cannot be made"));
}

TEST(Program, SaysWhenItsOutputIsLost) {
  const auto lost =
      test::run_shell(std::string(PACKBED_PROGRAM) + " units 1>/dev/full", PACKBED_SOURCE_DIR);
  EXPECT_EQ(lost.code, 3);
  EXPECT_THAT(lost.err, HasSubstr("standard output cannot be written"));
}

TEST(Program, TakesFolderNamesThatAreNoUtf8) {
  const test::TemporaryFolder folder;
  const auto file = case_without_beads(folder, "f\xff/c.toml");
  const auto out = (folder.path() / "out").string();
  EXPECT_EQ(run_packbed("run --json '" + file.string() + "' -o " + out).code, 0);
}

TEST(Resins, ListsShowsAndPrintsJson) {
  EXPECT_THAT(run_packbed("resins").out, HasSubstr("CM Sepharose 6FF"));
  EXPECT_THAT(run_packbed("resins sep").out, HasSubstr("thesis, table 6.1"));
  const auto sep = nlohmann::json::parse(run_packbed("resins SEP --json").out);
  EXPECT_EQ(sep["properties"]["density_kg_m3"], 1140.0);
  EXPECT_EQ(sep["properties"]["density_spread_kg_m3"], 160.0);
  const auto all = nlohmann::json::parse(run_packbed("resins --json").out);
  EXPECT_GT(all.size(), 15U);
  EXPECT_THAT(run_packbed("resins sepp").err, HasSubstr("did you mean \"SEP\"?"));
  EXPECT_EQ(run_packbed("resins sepp").code, 1);
}

TEST(Units, ShowEveryDimension) {
  const auto units = nlohmann::json::parse(run_packbed("units --json").out);
  EXPECT_EQ(units.size(), 12U);
  EXPECT_EQ(units["velocity"][0]["value_m_s"], 2763.0 / 360000.0);
  EXPECT_THAT(run_packbed("units").err, IsEmpty());
}

}  // namespace
}  // namespace packbed
