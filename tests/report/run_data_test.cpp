// SPDX-License-Identifier: BSD-3-Clause
#include "report/run_data.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/report/small_run.hpp"
#include "tests/support/message_of.hpp"

namespace packbed::report {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ReadRun : public testing::Test {
 protected:
  [[nodiscard]] RunData read() const { return read_run(run_.path(), units_); }
  [[nodiscard]] std::string refusal() const {
    return test::message_of([&] { (void)read(); });
  }
  test::SmallRun run_;
  UnitSystem units_;
};

TEST_F(ReadRun, KnowsStagesOfRepeatsAndTheFilesThatAreThere) {
  const auto run = read();

  EXPECT_THAT(run.stages, ElementsAre("settle", "flow_ramp", "hold"));
  EXPECT_EQ(run.series.rows(), 9U);
  EXPECT_TRUE(std::isnan(run.series["compression"][0]));
  EXPECT_EQ(run.porosity_z.at(0).table["porosity"][1], 0.25);
  EXPECT_TRUE(run.plateau_z.empty());
  EXPECT_FALSE(run.measured);
}

TEST_F(ReadRun, FindsPlateausInTheSeriesWhereNoFileTellsThem) {
  const auto plateaus = read().plateaus;

  ASSERT_EQ(plateaus.size(), 3U);
  EXPECT_EQ(plateaus[0].time, 2.0);
  EXPECT_EQ(plateaus[1].velocity, 0.002);
  EXPECT_EQ(plateaus[1].pressure_gradient, 200 / 0.00784);
  EXPECT_EQ(plateaus[2].compression, 0.015);
}

TEST_F(ReadRun, TakesEachRowForItselfWhereRowsAreFewerThanPlateaus) {
  run_.write("series.csv",
             "time_s,stage,superficial_velocity_m_s,pressure_drop_Pa\n0,0,0,0\n1,1,0.001,1\n"
             "2,1,0.002,2\n");

  EXPECT_EQ(read().plateaus.size(), 2U);
}

TEST_F(ReadRun, PrefersTheFileOfPlateausAndWarnsOfThoseThatAreNotSteady) {
  run_.write("plateaus.csv",
             "plateau,stage,start_time_s,end_time_s,superficial_velocity_m_s,pressure_drop_Pa,"
             "pressure_drop_per_height_Pa_m,bed_height_m,compression,pressure_noise,steady\n"
             "1,2,1,2,0.001,100,12500,0.008,0.01,,1\n"
             "2,2,2,3,0.002,200,25000,0.008,0.02,1e-4,0\n");

  const auto run = read();

  EXPECT_EQ(run.plateaus.size(), 2U);
  EXPECT_THAT(
      run.warnings(),
      ElementsAre("mind the gap", HasSubstr("stage 2 (flow_ramp): 1 of 2 plateaus was not")));
}

TEST_F(ReadRun, ReadsMeasuredPoints) {
  run_.write("measured.csv", "superficial velocity [m/s],pressure drop [Pa]\n0.001,120\n");

  EXPECT_EQ(read().measured->pressure_drop.at(0), 120.0);
}

TEST_F(ReadRun, TellsAFolderThatIsNotThereFromOneWithoutARunAndOneThatHasNotEnded) {
  EXPECT_THAT(test::message_of([&] { (void)read_run(run_.path() / "none", units_); }),
              HasSubstr("there is no such folder"));
  run_.remove("summary.json");
  EXPECT_THAT(refusal(), HasSubstr("this run has not ended"));
  run_.remove("case.toml");
  EXPECT_THAT(refusal(), HasSubstr("there is no run in this folder"));
}

TEST_F(ReadRun, NamesTheFileThatIsMissingOrDamaged) {
  run_.write("series.csv", "time_s,stage\n0,0\n1,x\n");
  EXPECT_THAT(refusal(), HasSubstr("series.csv:3: "));
  run_.write("series.csv", "time_s,stage\n0,0\n1\n");
  EXPECT_THAT(refusal(), HasSubstr("series.csv:3: "));
  run_.write("series.csv", "time_s,superficial_velocity_m_s\n0,0\n1,1\n");
  EXPECT_THAT(refusal(), HasSubstr("series.csv: column \"stage\" is missing"));
  run_.remove("series.csv");
  EXPECT_THAT(refusal(), HasSubstr("series.csv: cannot be opened"));
  run_.write("summary.json", "{\"title\": ");
  EXPECT_THAT(refusal(), HasSubstr("summary.json: it is not a summary of packbed"));
  run_.write("summary.json", "{}");
  run_.write("case.toml", "[[protocol]]\nstep = 3\n");
  EXPECT_THAT(refusal(), HasSubstr("is not as packbed wrote it"));
}

}  // namespace
}  // namespace packbed::report
