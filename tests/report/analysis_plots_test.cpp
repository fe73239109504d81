// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "report/plots.hpp"
#include "tests/report/analyzed_run.hpp"

namespace packbed::report {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const Plot& plot(const PlotGroup& group, const std::string& title) {
  const auto found = std::ranges::find(group.plots, title, &Plot::title);
  if (found == group.plots.end()) throw std::out_of_range("no plot " + title);
  return *found;
}

class AnalysisPlots : public testing::Test {
 protected:
  void SetUp() override { test::add_analysis(run_, 0.01); }
  [[nodiscard]] std::vector<RunData> read() const { return {read_run(run_.path(), units_)}; }
  test::SmallRun run_;
  UnitSystem units_;
};

TEST_F(AnalysisPlots, ShowTheFramesOfARun) {
  const auto group = force_plots(read());

  const auto& forces = plot(group, "Forces between beads");
  EXPECT_TRUE(forces.y.logarithmic);
  ASSERT_EQ(forces.curves.size(), 3U);
  EXPECT_EQ(forces.curves[1].label, "after stage 2, flow_ramp");
  EXPECT_THAT(forces.curves[1].x, ElementsAre(0.25, 0.75, 1.25));
  EXPECT_THAT(forces.curves[1].y, ElementsAre(1.5, 0.0, 0.5));
  const auto& stress = plot(group, "Axial stress of the beads");
  EXPECT_THAT(stress.curves[2].x, ElementsAre(DoubleNear(2, 1e-9), DoubleNear(6, 1e-9)));
  EXPECT_THAT(stress.curves[2].y, ElementsAre(DoubleNear(3e-3, 1e-12), DoubleNear(1e-4, 1e-12)));
  EXPECT_THAT(plot(group, "Where forces point").curves[0].y, ElementsAre(0.9, 1.1));
}

TEST_F(AnalysisPlots, ShowFiguresOverStages) {
  const auto group = evenness_plots(read());

  EXPECT_THAT(group.text, HasSubstr("20.0"));
  const auto& spread = plot(group, "Unevenness of the sections");
  EXPECT_EQ(spread.curves.at(0).label, "S_mean");
  EXPECT_THAT(spread.curves[0].x, ElementsAre(1, 2, 3));
  EXPECT_EQ(spread.curves[0].y[0], 0.01);
  // No liquid after the first stage; nothing moves in this bed, so a logarithm has nothing to show.
  EXPECT_TRUE(std::isnan(plot(group, "Variance of the liquid's velocity").curves[0].y[0]));
  EXPECT_THROW(plot(group, "Granular temperature"), std::out_of_range);
}

TEST_F(AnalysisPlots, LaySeveralRunsOverEachOtherFromTheEndOfPackingOn) {
  auto runs = read();
  runs.push_back(runs[0]);
  runs[0].label = "a";
  runs[1].label = "b";

  EXPECT_THAT(plot(evenness_plots(runs), "Unevenness of the sections").curves.at(1).x,
              ElementsAre(0, 1, 2));
  const auto group = force_plots(runs);
  const auto& packed = plot(group, "Axial stress of the beads, after packing");
  ASSERT_EQ(packed.curves.size(), 2U);
  EXPECT_EQ(packed.curves[1].label, "b, after stage 1, settle");
  EXPECT_EQ(plot(group, "Axial stress of the beads, at the end").curves.at(0).label,
            "a, after stage 3, hold");
}

TEST_F(AnalysisPlots, AreLeftOutWhereNothingWasAnalyzed) {
  const test::SmallRun bare;
  const std::vector<RunData> runs = {read_run(bare.path(), units_)};

  EXPECT_THAT(force_plots(runs).plots, IsEmpty());
  EXPECT_THAT(evenness_plots(runs).plots, IsEmpty());
  EXPECT_THAT(plunger_plots(runs).plots, IsEmpty());
}

TEST_F(AnalysisPlots, NameATableThatIsDamaged) {
  run_.write("analysis/analysis.csv", "frame,stage_name\n1,settle\nx,hold\n");
  EXPECT_THROW(read(), DataError);
  run_.write("analysis/analysis.csv", "frame,stage_name\n1\n");
  EXPECT_THROW(read(), DataError);
}

TEST_F(AnalysisPlots, DrawTheStrokesOfAPlungerInAscendingOrder) {
  run_.write(
      "series.csv",
      "time_s,stage,plunger_compression,plunger_force_N,plunger_pressure_Pa,plunger_position_m\n"
      "0,0,,0,0,0.012\n"
      "1,1,-0.2,0,0,0.012\n"
      "2,2,0.01,1,1000,0.011\n"
      "3,2,0.02,2,2000,0.010\n"
      "4,3,0.015,0.5,500,0.011\n"
      "5,3,0.005,0,0,0.012\n");
  run_.write("plateaus.csv",
             "plateau,stage,start_time_s,end_time_s,superficial_velocity_m_s,pressure_drop_Pa,"
             "pressure_drop_per_height_Pa_m,bed_height_m,compression,pressure_noise,steady\n");

  const auto group = plunger_plots(read());

  const auto& force = plot(group, "Plunger force");
  ASSERT_EQ(force.curves.size(), 2U);  // stage 1 has a plunger that does not press
  EXPECT_EQ(force.curves[0].draw, Draw::line);
  EXPECT_THAT(force.curves[0].x, ElementsAre(1, 2));
  EXPECT_EQ(force.curves[1].draw, Draw::dashed);
  EXPECT_THAT(force.curves[1].x, ElementsAre(0.5, 1.5));
  EXPECT_THAT(force.curves[1].y, ElementsAre(0, 0.5));
  EXPECT_THAT(plot(group, "Plunger pressure").curves[0].y,
              ElementsAre(DoubleNear(0.01, 1e-12), DoubleNear(0.02, 1e-12)));
}

TEST_F(AnalysisPlots, OfSectionsShowTheirDensitiesAtTheEndsOfStages) {
  const auto group = section_plots(read());

  const auto& density = plot(group, "Packing density of the sections");
  ASSERT_EQ(density.curves.size(), 3U);  // before the first stage there are none
  EXPECT_EQ(density.curves[2].label, "after stage 3, hold");
  EXPECT_EQ(density.curves[2].y.size(), 7U);
  EXPECT_EQ(density.curves[2].y[0], 0.6);
}

}  // namespace
}  // namespace packbed::report
