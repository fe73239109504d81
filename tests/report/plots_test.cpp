// SPDX-License-Identifier: BSD-3-Clause
#include "report/plots.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/report/small_run.hpp"

namespace packbed::report {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<Plateau> plateaus_at(std::initializer_list<double> velocities) {
  std::vector<Plateau> plateaus;
  for (const double v : velocities) plateaus.push_back({.velocity = v});
  return plateaus;
}

setup::MeasuredFlow measured_pressures(const std::vector<double>& velocity,
                                       const std::vector<double>& pressure_drop) {
  setup::MeasuredFlow measured;
  measured.superficial_velocity = velocity;
  measured.pressure_drop = pressure_drop;
  return measured;
}

class Plots : public testing::Test {
 protected:
  [[nodiscard]] std::vector<RunData> read() const { return {read_run(run_.path(), units_)}; }
  test::SmallRun run_;
  UnitSystem units_;
};

const Curve& curve(const Plot& plot, const std::string& label) {
  const auto found = std::ranges::find(plot.curves, label, &Curve::label);
  if (found == plot.curves.end()) throw std::out_of_range("no curve " + label);
  return *found;
}

TEST(Branches, ShareTheTurningPointAndAscend) {
  const auto all = branches(plateaus_at({1, 2, 3, 2, 1, 4}));

  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].name, "up");
  EXPECT_THAT(all[0].plateaus, ElementsAre(0U, 1U, 2U));
  EXPECT_EQ(all[1].name, "down");
  EXPECT_THAT(all[1].plateaus, ElementsAre(4U, 3U, 2U));
  EXPECT_EQ(all[2].name, "up 2");
  EXPECT_THAT(all[2].plateaus, ElementsAre(4U, 5U));
}

TEST(Branches, OfOneOrNoPlateauAreOneOrNone) {
  EXPECT_EQ(branches(plateaus_at({1})).size(), 1U);
  EXPECT_EQ(branches(plateaus_at({1, 1})).size(), 1U);
  EXPECT_THAT(branches({}), IsEmpty());
  EXPECT_THAT(shown_branches({}), IsEmpty());
  EXPECT_EQ(shown_branches(plateaus_at({1, 2, 1, 2})).size(), 3U);
  const auto some = shown_branches(plateaus_at({1, 9, 1, 9, 1, 9, 1, 9, 1, 9}));  // nine branches
  ASSERT_EQ(some.size(), 6U);
  EXPECT_EQ(some[3].name, "down 2");
  EXPECT_EQ(some[4].name, "down 4");
  EXPECT_EQ(some[5].name, "up 5");
}

TEST(Spread, TakesTheFirstAndTheLastOne) {
  EXPECT_THAT(spread(10, 3), ElementsAre(0U, 4U, 9U));
  EXPECT_THAT(spread(10, 1), ElementsAre(9U));
  EXPECT_THAT(spread(1, 3), ElementsAre(0U));
  EXPECT_THAT(spread(2, 3), ElementsAre(0U, 1U));
  EXPECT_THAT(spread(0, 3), IsEmpty());
}

TEST_F(Plots, OfFlowAreInLabUnits) {
  const auto group = flow_plots(read());

  const auto& up = curve(group.plots.at(0), "up");
  EXPECT_THAT(up.x, ElementsAre(DoubleNear(360.0, 1e-9), DoubleNear(720.0, 1e-9)));
  EXPECT_THAT(up.y, ElementsAre(DoubleNear(1e-3, 1e-12), DoubleNear(2e-3, 1e-12)));
  EXPECT_EQ(curve(group.plots.at(2), "down").y.at(0), 100.0 * 0.015);
}

TEST_F(Plots, DrawTheKozenyCarmanLineOfTheSettledBed) {
  const auto group = flow_plots(read());

  // 180 mu u (1 - eps)^2 / (eps^3 d32^2) with eps = 0.4, d32 = 90 um, u = 2 mm/s, mu = 1 mPa s, by hand:
  // 180 * 1e-3 * 2e-3 * 0.36 / (0.064 * 8.1e-9) = 250 000 Pa/m.
  const auto& per_height = curve(group.plots.at(1), "Kozeny-Carman");
  EXPECT_NEAR(per_height.x.back(), 720.0, 1e-9);
  EXPECT_NEAR(per_height.y.back(), 2.5, 1e-12);
  EXPECT_NEAR(curve(group.plots.at(0), "Kozeny-Carman").y.back(), 2.5 * 0.008, 1e-12);
}

TEST_F(Plots, TakeTheBeadsOutOfTheGrainsOfABeadFile) {
  auto runs = read();
  const auto of_resin = *kozeny_carman_resistance(runs[0]);
  runs[0].values["beads"]["csv"] = "grains.csv";

  EXPECT_NEAR(*kozeny_carman_resistance(runs[0]), 9.0 * of_resin, 1e-9 * of_resin);
}

TEST_F(Plots, LayMeasuredPointsOverTheCurvesInTheOrderOfTheirVelocities) {
  auto runs = read();
  runs[0].measured = measured_pressures({2e-3, 1e-3, 2e-3}, {300, 100, 200});

  const auto group = flow_plots(runs);

  const auto& points = curve(group.plots.at(0), "measured");
  EXPECT_THAT(points.x,
              ElementsAre(DoubleNear(360, 1e-9), DoubleNear(720, 1e-9), DoubleNear(720, 1e-9)));
  EXPECT_THAT(points.y, ElementsAre(DoubleNear(1e-3, 1e-12), DoubleNear(3e-3, 1e-12),
                                    DoubleNear(2e-3, 1e-12)));
  EXPECT_EQ(group.plots.at(1).curves.size(), 3U) << "no gradient was measured";
}

TEST_F(Plots, OfSeveralRunsNameTheRunAndShowSharedMeasurementsOnce) {
  auto runs = read();
  runs[0].measured = measured_pressures({1e-3}, {100});
  runs.push_back(runs[0]);
  runs[0].label = "a";
  runs[1].label = "b";

  const auto plot = flow_plots(runs).plots.at(0);

  EXPECT_EQ(plot.curves.size(), 7U);  // up, down and Kozeny-Carman of each, one measured
  EXPECT_NO_THROW(curve(plot, "a, up"));
  EXPECT_NO_THROW(curve(plot, "b, Kozeny-Carman"));
  EXPECT_NO_THROW(curve(plot, "measured"));
}

TEST_F(Plots, OfSectionsTakeTheRowsOfThePlateaus) {
  const auto group = section_plots(read());

  const auto& plateau = curve(group.plots.at(0), "720 cm/h up");
  EXPECT_THAT(plateau.x, ElementsAre(1, 2, 3, 4, 5, 6, 7));
  EXPECT_DOUBLE_EQ(plateau.y.at(6), 7.0);
  EXPECT_DOUBLE_EQ(curve(group.plots.at(1), "1 (top) down").y.at(0), 1.0);
}

TEST_F(Plots, OfChecksShowTheSizeOfTheBudgetError) {
  const auto group = check_plots(read());

  EXPECT_EQ(group.plots.at(0).title, "Budget error");
  EXPECT_EQ(group.plots.at(0).curves.at(0).y.at(1), 1e-5);
}

TEST_F(Plots, AreLeftOutWhereThereIsNothingToDraw) {
  run_.write("series.csv", "time_s,stage,kinetic_energy_J\n0,0,1e-12\n1e-5,1,2e-12\n");
  run_.remove("sections.csv");
  run_.remove("profiles/z_000001.csv");

  const auto runs = read();

  EXPECT_THAT(flow_plots(runs).plots, IsEmpty());
  EXPECT_THAT(time_plots(runs).plots, IsEmpty());
  EXPECT_THAT(section_plots(runs).plots, IsEmpty());
  EXPECT_THAT(profile_plots(runs).plots, IsEmpty());
  ASSERT_EQ(check_plots(runs).plots.size(), 1U);
  EXPECT_EQ(check_plots(runs).plots[0].x.label, "time [us]");
}

TEST_F(Plots, OfPlateausUseTheirProfiles) {
  run_.write(
      "profiles/plateau_z_000002.csv",
      "z_low_m,z_high_m,porosity,superficial_velocity_m_s,pressure_Pa\n0,0.002,0.4,0.002,200\n");
  run_.write("profiles/plateau_radius_000002.csv",
             "radius_low_m,radius_high_m,porosity,superficial_velocity_m_s\n0,0.001,0.4,0.005\n");

  const auto plots = profile_plots(read()).plots;

  ASSERT_EQ(plots.size(), 5U);  // porosity at the end of stage 1, two along z, two across
  EXPECT_EQ(curve(plots[2], "720 cm/h up").y.at(0), 200 * per_bar);
  EXPECT_EQ(curve(plots[3], "720 cm/h up").x.at(0), 0.5);
}

TEST_F(Plots, OfManyStagesHaveEachColorOnce) {
  for (int stage = 1; stage <= 20; ++stage) {
    run_.write(fmt::format("profiles/z_{:06}.csv", stage),
               "z_low_m,z_high_m,porosity\n0,0.004,0.5\n0.004,0.008,0.25\n");
  }
  const auto plots = profile_plots(read()).plots;

  ASSERT_EQ(plots.front().curves.size(), 8U);
  for (int k = 0; k < 8; ++k) EXPECT_EQ(plots.front().curves[k].color, k);
}

TEST(PlotData, HasSixDigitsAndNullForWhatCannotBeDrawn) {
  Plot plot{.title = "t", .x = {"x"}, .y = {.label = "y", .logarithmic = true}, .curves = {}};
  plot.add({.label = "empty", .x = {1, 2}, .y = {unknown, -1.0}});
  plot.add({.label = "c", .x = {1, 2, 3}, .y = {1.0 / 3.0, 0.0, unknown}});

  const auto json = to_json(plot);

  ASSERT_EQ(json["curves"].size(), 1U);
  EXPECT_EQ(json["curves"][0]["y"].dump(), "[0.333333,null,null]");
  EXPECT_EQ(json["shared_x"].dump(), "[1.0,2.0,3.0]");
}

}  // namespace
}  // namespace packbed::report
