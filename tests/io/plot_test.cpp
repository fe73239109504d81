// SPDX-License-Identifier: BSD-3-Clause
#include "io/plot.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/message_of.hpp"

namespace packbed::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

PlotPanel line(std::vector<double> x, std::vector<double> y) {
  return {.title = "force & time",
          .x = {"time [s]"},
          .y = {"force [uN]"},
          .series = {{.label = "bead <1>", .x = std::move(x), .y = std::move(y)}}};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Plot, TicksAreRoundNumbers) {
  EXPECT_THAT(linear_ticks(0.0, 1.0, 5), ElementsAre(0.0, 0.2, 0.4, 0.6000000000000001, 0.8, 1.0));
  EXPECT_THAT(linear_ticks(-3.0, 7.0, 5), ElementsAre(-2.0, 0.0, 2.0, 4.0, 6.0));
}

TEST(Plot, IsOneFileThatAsksForNothing) {
  const auto svg = plot_svg({line({0, 1, 2}, {0, 1, 4})});

  EXPECT_THAT(svg, HasSubstr("time [s]"));
  EXPECT_THAT(svg, HasSubstr("force &amp; time"));
  EXPECT_THAT(svg, HasSubstr("bead &lt;1&gt;"));
  EXPECT_THAT(svg, Not(HasSubstr("href")));
  EXPECT_EQ(count(svg, "http"), 1U);  // the name space
}

TEST(Plot, DrawsTheEndsOfTheDataAtTheEndsOfTheAxis) {
  auto panel = line({0, 2}, {0, 4});
  panel.y.range = {0.0, 4.0};
  // Left edge of the axes 78, width 400; bottom 330, height 290.
  EXPECT_THAT(plot_svg({panel}), HasSubstr("M78.00 330.00L478.00 40.00"));
}

TEST(Plot, BreaksTheLineWhereThereIsNoNumber) {
  const auto none = std::numeric_limits<double>::quiet_NaN();
  const auto svg = plot_svg({line({0, 1, 2, 3, 4}, {0, 1, none, 3, 4})});
  const auto path = svg.substr(svg.find("stroke-width=\"2\" d="), 120);
  EXPECT_EQ(count(path, "M"), 2U);
}

TEST(Plot, LeavesOutWhatALogarithmicAxisCannotShow) {
  auto panel = line({0.0, 1.0, 10.0}, {1, 2, 3});
  panel.x.logarithmic = true;
  const auto svg = plot_svg({panel});
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

TEST(Plot, OfNothingIsRefused) {
  EXPECT_EQ(test::message_of([] { plot_svg({line({}, {})}); }),
            "the plot \"force & time\" has no point to draw");
}

}  // namespace
}  // namespace packbed::io
