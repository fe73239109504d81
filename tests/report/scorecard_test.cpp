// SPDX-License-Identifier: BSD-3-Clause
#include "report/scorecard.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/page.hpp"
#include "tests/report/analyzed_run.hpp"

namespace packbed::report {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class Scores : public testing::Test {
 protected:
  void SetUp() override {
    test::add_analysis(even_, 0.01);
    test::add_analysis(uneven_, 0.05);
  }
  [[nodiscard]] std::vector<RunData> read() const {
    std::vector<RunData> runs = {read_run(even_.path(), units_), read_run(uneven_.path(), units_)};
    tell_apart(runs);
    return runs;
  }
  static std::size_t place(const Scorecard& card, const std::string& key) {
    const auto found = std::ranges::find(card.criteria, key, &Criterion::key);
    EXPECT_NE(found, card.criteria.end()) << key;
    return static_cast<std::size_t>(found - card.criteria.begin());
  }
  static double value(const Scorecard& card, std::size_t run, const std::string& key) {
    return card.values[run][place(card, key)];
  }

  test::SmallRun even_{"even, and \"quoted\""};
  test::SmallRun uneven_{"uneven"};
  UnitSystem units_;
};

TEST_F(Scores, TakeTheStateAfterPackingAndTheLastOne) {
  const auto card = scorecard(read());

  EXPECT_EQ(value(card, 0, "packed_S_mean"), 0.01);
  EXPECT_EQ(value(card, 1, "packed_S_mean"), 0.05);
  EXPECT_NEAR(value(card, 0, "end_S_mean"), 0.012, 1e-12);
  EXPECT_EQ(value(card, 0, "end_S_init"), 0.002);
  EXPECT_EQ(value(card, 0, "D_over_d_eff"), 20.0);
  EXPECT_THAT(card.warnings, IsEmpty());
}

TEST_F(Scores, CompareLiquidsAtTheHighestFlowOfAll) {
  auto runs = read();
  EXPECT_EQ(scorecard(runs).flow, 0.002);
  // sigma_z2 of the frame at 2 mm/s alone, the pressure drop of the last plateau there.
  EXPECT_NEAR(value(scorecard(runs), 0, "sigma_z2_m2_s2"), 2e-6, 1e-15);
  EXPECT_EQ(value(scorecard(runs), 0, "pressure_drop_Pa"), 200.0);
}

TEST_F(Scores, TakeTheFlowThatAllHaveReached) {
  auto runs = read();
  std::erase_if(runs[1].plateaus, [](const Plateau& p) { return p.velocity > 0.0015; });

  const auto card = scorecard(runs);
  EXPECT_EQ(card.flow, 0.001);
  EXPECT_NEAR(value(card, 0, "sigma_z2_m2_s2"), 3e-6, 1e-15);
  EXPECT_EQ(value(card, 0, "pressure_drop_Pa"), 110.0);  // on the way down
  EXPECT_THAT(scorecard_text(card), HasSubstr("at 360 cm/h"));

  runs[1].plateaus.clear();
  EXPECT_TRUE(std::isnan(scorecard(runs).flow));
  EXPECT_THAT(scorecard_text(scorecard(runs)), HasSubstr("No flow is common"));
}

TEST_F(Scores, MarkTheLowestUnlessAllAreAlike) {
  const auto card = scorecard(read());

  const auto spread = place(card, "packed_S_mean");
  EXPECT_TRUE(card.is_best(0, spread));
  EXPECT_FALSE(card.is_best(1, spread));
  const auto alike = place(card, "end_IPD_absolute_d");
  EXPECT_FALSE(card.is_best(0, alike) || card.is_best(1, alike));
  EXPECT_EQ(card.shown(0, place(card, "packed_share_above_6")), "0.2");
  EXPECT_FALSE(card.is_best(0, place(card, "packed_bed_height_m")));
}

TEST_F(Scores, TellWhatCannotBeCompared) {
  test::add_analysis(uneven_, 0.05, 40.0);
  auto runs = read();
  EXPECT_THAT(scorecard(runs).warnings,
              ElementsAre(HasSubstr("20.0 to 40.0 grain diameters wide")));

  even_.remove("analysis/analysis.csv");
  runs = read();
  const auto card = scorecard(runs);
  EXPECT_THAT(card.warnings, ElementsAre(HasSubstr("were not analyzed; `packbed analyze ")));
  EXPECT_TRUE(std::isnan(value(card, 0, "packed_S_mean")));
  EXPECT_EQ(card.shown(0, place(card, "packed_S_mean")), "");
  EXPECT_FALSE(card.is_best(1, place(card, "packed_S_mean")));
  EXPECT_EQ(value(card, 0, "pressure_drop_Pa"), 200.0);
}

TEST_F(Scores, AreATableInSI) {
  const auto runs = read();

  const auto csv = to_csv(scorecard(runs), runs);

  EXPECT_THAT(csv, StartsWith("run,folder,flow_m_s,packed_S_mean,end_S_mean,end_S_init,"));
  EXPECT_THAT(csv, HasSubstr("\"even, and \"\"quoted\"\"\"," + even_.path().string() +
                             ",0.002,0.01,0.012"));
}

TEST_F(Scores, StandOnThePageOfSeveralRuns) {
  const auto html = page(read(), units_);
  EXPECT_THAT(html, AllOf(HasSubstr("<section id=\"scores\">"), HasSubstr("class=\"best\">0.01<")));
  EXPECT_THAT(html, HasSubstr("even, and &quot;quoted&quot;"));
  EXPECT_THAT(page({read()[0]}, units_), Not(HasSubstr("<section id=\"scores\">")));
  even_.remove("analysis/analysis.csv");
  uneven_.remove("analysis/analysis.csv");
  EXPECT_THAT(page(read(), units_), Not(HasSubstr("<section id=\"scores\">")));
}

}  // namespace
}  // namespace packbed::report
