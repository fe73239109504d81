// SPDX-License-Identifier: BSD-3-Clause
// A case that begins with the bed of another run.
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/file.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace packbed {
namespace {

namespace fs = std::filesystem;
using test::run_packbed;
using testing::HasSubstr;
using testing::Not;

constexpr const char* column = R"(
[column]
shape = "slice"
inner_diameter = "{}"
slice_depth = "0.5 mm"
height = "4 mm"
[resin]
name = "CM Sepharose 6FF"
coarse_grain = {}
[liquid]
)";

class BedOfARun : public testing::Test {
 protected:
  void SetUp() override {
    write("settle.toml",
          text("1.2 mm", 3) + "[beads]\ncount = 40\n[[protocol]]\nstep = \"settle\"\n");
    ASSERT_EQ(run_packbed("run settle.toml -n 1 -o settled", folder_).code, 0);
  }
  static std::string text(const char* diameter, int coarse_grain) {
    return fmt::format(fmt::runtime(column), diameter, coarse_grain);
  }
  void write(const char* name, const std::string& text) const {
    write_text_file(folder_ / name, text);
  }
  [[nodiscard]] nlohmann::json summary(const char* run) const {
    return nlohmann::json::parse(read_text_file(folder_ / run / "summary.json"));
  }

  test::TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
};

const std::string taken = "[beads]\nrun = \"settled\"\n";

TEST_F(BedOfARun, IsThereWithItsContactsAndStays) {
  write("go.toml",
        text("1.2 mm", 3) + taken + "[[protocol]]\nstep = \"run\"\nduration = \"5 ms\"\n");
  const auto run = run_packbed("run go.toml -n 1 -o gone", folder_);
  ASSERT_EQ(run.code, 0) << run.err;
  const auto before = summary("settled");
  const auto after = summary("gone");
  EXPECT_EQ(after["beads"], 40);
  EXPECT_NEAR(after["bed_height_m"], before["bed_height_m"], 1e-9);
  EXPECT_EQ(after["settled_height_m"], before["bed_height_m"]);
  EXPECT_NEAR(after["coordination_number"], before["coordination_number"], 0.11);  // two contacts
  EXPECT_LT(after["unbalanced_force"], 1e-4);  // springs are there: without, it would not stand
}

TEST_F(BedOfARun, FlowsOnTwoRanksAsOnOne) {
  write("flow.toml",
        text("1.2 mm", 3) + taken +
            "[[protocol]]\nstep = \"flow_ramp\"\nto = \"500 cm/h\"\nhold = \"20 ms\"\n");
  ASSERT_EQ(test::run_on_ranks(1, "run flow.toml -o one", folder_).code, 0);
  ASSERT_EQ(test::run_on_ranks(2, "run flow.toml -o two", folder_).code, 0);
  const double drop = summary("one")["pressure_drop_at_highest_flow_Pa"];
  EXPECT_GT(drop, 0.0);
  EXPECT_NEAR(summary("two")["pressure_drop_at_highest_flow_Pa"], drop, 1e-6 * drop);
}

// What was packed stays packed, and is compared with the bed as it had settled.
TEST_F(BedOfARun, StaysBelowItsPlunger) {
  const std::string column_of_beds = text("1.2 mm", 3);
  write("pack.toml",
        column_of_beds + taken +
            "[[protocol]]\nstep = \"compress\"\nspeed = \"5 mm/s\"\ncompression = \"5 %\"\n");
  const auto pressed = test::run_on_ranks(1, "run pack.toml -o packed", folder_);
  ASSERT_EQ(pressed.code, 0) << pressed.err;
  write("load.toml", column_of_beds + "[beads]\nrun = \"packed\"\n[[protocol]]\nstep = \"hold\"\n" +
                         "flow = \"100 cm/h\"\nduration = \"20 ms\"\n");
  const auto run = test::run_on_ranks(1, "run load.toml -o loaded", folder_);
  ASSERT_EQ(run.code, 0) << run.err;
  const auto settled = summary("settled");
  const auto packed = summary("packed");
  const auto loaded = summary("loaded");
  EXPECT_THAT(pressed.out, Not(HasSubstr("Highest flow")));
  EXPECT_EQ(loaded["settled_height_m"], settled["bed_height_m"]);
  EXPECT_EQ(loaded["settled_porosity"], settled["settled_porosity"]);
  EXPECT_LT(loaded["bed_height_m"], 0.98 * settled["bed_height_m"].get<double>());
  EXPECT_NEAR(loaded["bed_height_m"], packed["bed_height_m"],
              2e-3 * settled["bed_height_m"].get<double>());
  EXPECT_THAT(read_text_file(folder_ / "loaded/run.log"), HasSubstr(", plunger at "));
}

TEST_F(BedOfARun, IsRefusedInAnotherColumnOrOfOtherGrains) {
  write("wide.toml", text("1.4 mm", 3) + taken);
  EXPECT_THAT(run_packbed("run wide.toml -n 1 -o w", folder_).err,
              HasSubstr("does not belong in this column: column.inner_diameter was 0.0012, and is "
                        "0.0014 now; make them equal"));
  write("fine.toml", text("1.2 mm", 2) + taken);
  EXPECT_THAT(run_packbed("run fine.toml -n 1 -o f", folder_).err,
              HasSubstr("resin.coarse_grain was 3, and is 2 now"));
}

}  // namespace
}  // namespace packbed
