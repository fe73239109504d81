// SPDX-License-Identifier: BSD-3-Clause
// packbed report, and the page that a run writes.
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/run_program.hpp"

namespace packbed {
namespace {

using test::run_packbed;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;

class Report : public testing::Test {
 protected:
  /// Two beads collide, with measured points (which this dry case has no curve for).
  void SetUp() override {
    const auto case_folder =
        std::filesystem::path(PACKBED_SOURCE_DIR) / "cases/01_two_beads_collide";
    (void)folder_.file("beads.csv", read_text_file(case_folder / "beads.csv"));
    (void)folder_.file("lab.csv", "superficial velocity [cm/h],pressure drop [bar]\n300,0.5\n");
    (void)folder_.file("two.toml",
                       read_text_file(case_folder / "case.toml") + "measured = \"lab.csv\"\n");
  }
  [[nodiscard]] std::filesystem::path path(const std::string& name) const {
    return folder_.path() / name;
  }
  test::TemporaryFolder folder_;
};

TEST_F(Report, IsWrittenByARunAndAgainByItsCommand) {
  const auto run = run_packbed("run two.toml -o out", folder_.path());

  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, EndsWith("run.log, measured.csv, report.html\nReport: out/report.html\n"));
  const auto page = read_text_file(path("out/report.html"));
  EXPECT_THAT(page, AllOf(HasSubstr("<title>Two beads collide"), HasSubstr("measured")));
  std::filesystem::remove(path("out/report.html"));
  std::filesystem::remove(path("lab.csv"));  // its points went along
  EXPECT_EQ(run_packbed("report out", folder_.path()).out, "Report: out/report.html\n");
  EXPECT_EQ(read_text_file(path("out/report.html")), page);
}

TEST_F(Report, ComparesRunsInAFileOfItsOwn) {
  ASSERT_EQ(run_packbed("run two.toml -o a", folder_.path()).code, 0);
  ASSERT_EQ(run_packbed("run two.toml -o b --json", folder_.path()).code, 0);

  EXPECT_EQ(run_packbed("report a b", folder_.path()).out, "Report: comparison.html\n");
  EXPECT_EQ(run_packbed("report a b -o ab.html", folder_.path()).out, "Report: ab.html\n");
  EXPECT_THAT(read_text_file(path("ab.html")), HasSubstr("2 runs compared"));
  EXPECT_TRUE(std::filesystem::exists(path("b/report.html")));
}

TEST_F(Report, TakesOtherMeasuredPoints) {
  ASSERT_EQ(run_packbed("run two.toml -o out", folder_.path()).code, 0);
  (void)folder_.file("new.csv", "superficial velocity [cm/h],bed height [mm]\n300,77.25\n");

  const auto report = run_packbed("report out --measured new.csv", folder_.path());

  EXPECT_EQ(report.code, 0) << report.err;
  EXPECT_THAT(read_text_file(path("out/report.html")), HasSubstr("77.25"));
}

TEST_F(Report, RefusesFoldersWithoutAFinishedRunOnOneLine) {
  EXPECT_EQ(run_packbed("report none", folder_.path()).err,
            "packbed: none: there is no such folder; name the folder of a run, such as "
            "runs/quickstart\n");
  EXPECT_EQ(run_packbed("report none", folder_.path()).code, 3);
  EXPECT_EQ(run_packbed("report", folder_.path()).code, 1);
}

}  // namespace
}  // namespace packbed
