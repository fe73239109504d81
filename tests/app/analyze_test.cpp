// SPDX-License-Identifier: BSD-3-Clause
// packbed analyze and packbed compare, of small runs.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/csv.hpp"
#include "tests/support/run_program.hpp"

namespace packbed {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::run_on_ranks;
using test::run_packbed;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;

const std::string bed = R"(
[column]
shape = "slice"
inner_diameter = "1.2 mm"
slice_depth = "0.5 mm"
height = "4 mm"
[resin]
name = "CM Sepharose 6FF"
youngs_modulus = "3 MPa"
coarse_grain = 3
[liquid]
[beads]
count = 80
[[protocol]]
step = "settle"
[[protocol]]
step = "flow_ramp"
to = "500 cm/h"
hold = "20 ms"
)";

/// One run for all tests, as it takes a second.
class Analyze : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new test::TemporaryFolder;
    (void)folder_->file("bed.toml", bed);
    run_ = new test::Outcome(run_on_ranks(1, "run bed.toml -o bed", folder_->path()));
  }
  // Here, as tests of a suite that cannot be set up count as left out.
  void SetUp() override {
    ASSERT_EQ(run_->code, 0) << run_->err;
    EXPECT_THAT(run_->out, HasSubstr("frames, analysis, checkpoints"));
    EXPECT_EQ(run_->err, "");
  }
  static void TearDownTestSuite() {
    delete folder_;
    delete run_;
    folder_ = nullptr;
    run_ = nullptr;
  }
  static fs::path path(const std::string& name) { return folder_->path() / name; }
  static test::Outcome packbed(const std::string& arguments) {
    return run_packbed(arguments, folder_->path());
  }
  /// A copy of the run, to be spoiled.
  static void copy_run(const std::string& name) {
    fs::copy(path("bed"), path(name), fs::copy_options::recursive);
  }

  static test::TemporaryFolder* folder_;  // NOLINT(readability-identifier-naming): private
  static test::Outcome* run_;             // NOLINT(readability-identifier-naming): private
};
test::TemporaryFolder* Analyze::folder_ = nullptr;
test::Outcome* Analyze::run_ = nullptr;

/// analysis.csv row by row, by names of columns; empty cells are NaN.
std::vector<std::map<std::string, double>> rows_of(const fs::path& file) {
  const CsvTable table(file);
  std::vector<std::map<std::string, double>> rows(table.rows());
  for (std::size_t r = 0; r < table.rows(); ++r) {
    for (std::size_t k = 0; k < table.header().size(); ++k) {
      const auto& cell = table.text(r, static_cast<int>(k));
      if (table.header()[k] == "stage_name") continue;
      rows[r][table.header()[k]] = cell.empty() ? std::nan("") : std::stod(cell);
    }
  }
  return rows;
}

TEST_F(Analyze, IsDoneByARunAtTheEndsOfItsStages) {
  const auto rows = rows_of(path("bed/analysis/analysis.csv"));

  ASSERT_EQ(rows.size(), 2U);  // the cloud of the start is no bed
  EXPECT_EQ(rows[0].at("stage"), 1.0);
  EXPECT_EQ(rows[1].at("stage"), 2.0);
  EXPECT_EQ(rows[1].at("packing_end"), 1.0);
  EXPECT_EQ(rows[0].at("S_init"), 0.0);
  EXPECT_THAT(read_text_file(path("bed/report.html")),
              AllOf(HasSubstr("Forces in the bed"), HasSubstr("How even the bed is")));
}

TEST_F(Analyze, FindsAllFiguresOfABedInAFlow) {
  const auto row = rows_of(path("bed/analysis/analysis.csv")).back();

  for (const auto& [name, value] : row) EXPECT_TRUE(std::isfinite(value)) << name;
  EXPECT_GT(row.at("S_init"), 0.0);
  EXPECT_GT(row.at("sigma_z2_m2_s2"), 0.0);
  EXPECT_GT(row.at("coordination"), 3.0);
  EXPECT_GE(row.at("coordination_without_rattlers"), row.at("coordination"));
}

TEST_F(Analyze, WritesTablesOfEachFrame) {
  const auto folder = path("bed/analysis");
  for (const auto* table : {"forces", "angles", "stress", "wall_porosity"}) {
    for (const auto* number : {"_000001.csv", "_000002.csv"}) {
      EXPECT_GT(CsvTable(folder / (std::string(table) + number)).rows(), 2U) << table;
    }
  }
  EXPECT_TRUE(fs::exists(folder / "wall_velocity_000002.csv"));
  EXPECT_FALSE(fs::exists(folder / "wall_velocity_000001.csv"));  // no liquid yet
}

TEST_F(Analyze, TellsWhatMovedFromFrameToFrame) {
  const auto moved = rows_of(path("bed/analysis/rearrangement.csv"));
  ASSERT_EQ(moved.size(), 1U);
  EXPECT_EQ(moved[0].at("beads"), 80.0);
  EXPECT_GT(moved[0].at("non_affine_m"), 0.0);
}

// The floor carries what the lowest slab passes on; frames hold seven digits.
TEST_F(Analyze, FindsTheStressThatTheFloorCarries) {
  const CsvTable stress(path("bed/analysis/stress_000002.csv"));
  const CsvTable series(path("bed/series.csv"));
  const double floor =
      series.number(series.rows() - 1, series.find("floor_force_N")) / (1.2e-3 * 0.5e-3);

  const double lowest = stress.number(0, stress.find("stress_zz_Pa"));

  EXPECT_LT(lowest,
            floor * 1.0001);  // the weight and drag of the slab's beads is missing in its mean
  EXPECT_GT(lowest, 0.7 * floor);
}

TEST_F(Analyze, GivesTheSameTablesAgainAndElsewhere) {
  const auto before = read_text_file(path("bed/analysis/analysis.csv"));
  (void)folder_->file("bed/analysis/forces_000099.csv", "of an earlier analysis");
  (void)folder_->file("bed/analysis/mine.csv", "of the user");

  const auto again = packbed("analyze bed");

  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_THAT(again.out,
              HasSubstr("Written in bed/analysis: analysis.csv, rearrangement.csv, tables"));
  EXPECT_EQ(read_text_file(path("bed/analysis/analysis.csv")), before);
  EXPECT_FALSE(fs::exists(path("bed/analysis/forces_000099.csv")));
  EXPECT_TRUE(fs::exists(path("bed/analysis/mine.csv")));
  ASSERT_EQ(packbed("analyze bed -o elsewhere").code, 0);
  EXPECT_EQ(read_text_file(path("elsewhere/analysis.csv")), before);
}

TEST_F(Analyze, TakesOneFrameOrAllAndPrintsJson) {
  const auto one = packbed("analyze bed --frame 2 -o one --json");
  ASSERT_EQ(one.code, 0) << one.err;
  const auto found = json::parse(one.out);
  ASSERT_EQ(found["frames"].size(), 1U);
  EXPECT_EQ(found["frames"][0]["stage_name"], "flow_ramp");
  EXPECT_GT(found["frames"][0]["mean_force_N"], 0.0);
  EXPECT_FALSE(fs::exists(path("one/rearrangement.csv")));
  const auto all = packbed("analyze bed --all -o all --json");
  ASSERT_EQ(all.code, 0) << all.err;
  EXPECT_EQ(json::parse(all.out)["frames"].size(), 3U);
  EXPECT_EQ(json::parse(all.out)["frames"][0]["S_mean"], nullptr);
}

TEST_F(Analyze, SaysOnOneLineWhatIsMissing) {
  for (const auto* name : {"not_ended", "bare", "cut", "gone"}) copy_run(name);
  fs::remove(path("not_ended/summary.json"));
  fs::remove_all(path("bare/frames"));
  fs::resize_file(path("cut/frames/contacts_000002.hdf"), 900);
  fs::remove(path("gone/frames/beads_000001.hdf"));
  struct Mistake {
    const char* arguments;
    int code;
    const char* message;
  };
  const Mistake mistakes[] = {
      {"analyze none", 3, "none: there is no such folder"},
      {"analyze bed --frame 9", 1, "bed: there is no frame 9; the last one is 2"},
      {"analyze not_ended", 3, "not_ended: this run has not ended"},
      {"analyze bare", 3, "bare: this run has no frames; run the case again with frames = true"},
      {"analyze cut", 3, "cut/frames/contacts_000002.hdf: opening failed"},
      {"analyze gone", 3, "beads_000001.hdf: this frame is missing"},
      {"compare bed", 1, "compare takes the folders of two runs or more"}};
  for (const auto& [arguments, code, message] : mistakes) {
    const auto outcome = packbed(arguments);
    EXPECT_EQ(outcome.code, code) << arguments;
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  }
}

// Frames of cycles are stages of their own; packing is over before them.
TEST_F(Analyze, FollowsABedThroughPackingAndCycles) {
  (void)folder_->file("dac.toml", bed.substr(0, bed.find("[[protocol]]\nstep = \"flow_ramp\"")) +
                                      R"(
[[protocol]]
step = "compress"
speed = "20 mm/s"
compression = "5 %"
[[protocol]]
step = "cycle"
high = "500 cm/h"
low = "50 cm/h"
count = 1
high_duration = "10 ms"
low_duration = "10 ms"
)");
  const auto run = run_on_ranks(1, "run dac.toml -o dac", folder_->path());
  ASSERT_EQ(run.code, 0) << run.err;
  const auto rows = rows_of(path("dac/analysis/analysis.csv"));
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows.back().at("packing_end"), 2.0);
  EXPECT_EQ(rows[1].at("S_init"), 0.0);
  EXPECT_GT(rows[1].at("stress_top_Pa"), 100.0 * rows[0].at("stress_top_Pa"));
  const auto csv = read_text_file(path("dac/analysis/analysis.csv"));
  EXPECT_THAT(csv,
              AllOf(HasSubstr(",compress,"), HasSubstr(",cycle high,"), HasSubstr(",cycle low,")));
  EXPECT_THAT(read_text_file(path("dac/report.html")), HasSubstr("Plunger force"));
}

TEST_F(Analyze, IsLeftOutWhereTheCaseSaysSo) {
  (void)folder_->file("quick.toml", bed + "[output]\nanalysis = false\n");

  const auto run = run_on_ranks(1, "run quick.toml -o quick", folder_->path());

  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_FALSE(fs::exists(path("quick/analysis")));
  const auto compared = packbed("compare bed quick -o two.html --csv two.csv");
  ASSERT_EQ(compared.code, 0) << compared.err;
  EXPECT_THAT(compared.out, HasSubstr("Warning: quick: its frames were not analyzed"));
}

TEST_F(Analyze, IsComparedByTheScorecard) {
  copy_run("twin");

  const auto compared = packbed("compare bed twin --csv scores.csv");

  ASSERT_EQ(compared.code, 0) << compared.err;
  EXPECT_THAT(compared.out, AllOf(HasSubstr("S_mean"), HasSubstr("at 500 cm/h"),
                                  EndsWith("Table: scores.csv\nReport: comparison.html\n")));
  const CsvTable scores(path("scores.csv"));
  ASSERT_EQ(scores.rows(), 2U);
  for (std::size_t k = 2; k < scores.header().size(); ++k) {
    EXPECT_TRUE(std::isfinite(scores.number(0, static_cast<int>(k)))) << scores.header()[k];
  }
  EXPECT_THAT(read_text_file(path("comparison.html")), HasSubstr("Packing methods"));
}

}  // namespace
}  // namespace packbed
