// SPDX-License-Identifier: BSD-3-Clause
#include "report/rose.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/page.hpp"
#include "report/plots.hpp"
#include "tests/report/analyzed_run.hpp"

namespace packbed::report {
namespace {

using testing::AllOf;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(Rose, GoesOnceAroundInAllQuadrants) {
  Rose rose{.title = "a & b", .radius = "r"};
  rose.curves.push_back({.label = "<x>", .x = {0.0, 90.0}, .y = {1.0, 2.0}});
  rose.curves.back().color = 9;

  const auto html = rose_figure(rose);

  // Of a picture whose largest circle, 2, is 130 units wide: right, up, up, left, left, down, down, right.
  EXPECT_THAT(html, HasSubstr("points=\"65.0,-0.0 0.0,-130.0 -0.0,-130.0 -65.0,-0.0 -65.0,0.0 "
                              "-0.0,130.0 0.0,130.0 65.0,0.0 \""));
  EXPECT_THAT(html, AllOf(HasSubstr("var(--c1)"), HasSubstr("a &amp; b"), HasSubstr("&lt;x&gt;")));
}

TEST(Rose, IsLeftOutWithoutACurve) {
  EXPECT_EQ(rose_figure({.title = "t", .radius = "r"}), "");
  Rose rose{.title = "t", .radius = "r"};
  rose.curves.push_back(
      {.label = "c", .x = {10.0}, .y = {std::numeric_limits<double>::quiet_NaN()}});
  EXPECT_EQ(rose_figure(rose), "");
}

TEST(Rose, ShowsDirectionsOfContactsAndForcesOnThePage) {
  const test::SmallRun run;
  test::add_analysis(run, 0.01);
  const UnitSystem units;
  const std::vector<RunData> runs = {read_run(run.path(), units)};

  const auto roses = direction_roses(runs);

  ASSERT_EQ(roses.size(), 2U);
  ASSERT_EQ(roses[1].curves.size(), 3U);
  EXPECT_THAT(roses[1].curves[0].x, ElementsAre(22.5, 67.5));
  EXPECT_THAT(roses[1].curves[0].y, ElementsAre(DoubleEq(1.1 * 0.9), DoubleEq(0.9 * 1.1)));
  EXPECT_THAT(page(runs, units), HasSubstr("class=\"rose\""));
  const test::SmallRun bare;
  EXPECT_THAT(page({read_run(bare.path(), units)}, units), Not(HasSubstr("class=\"rose\"")));
}

}  // namespace
}  // namespace packbed::report
