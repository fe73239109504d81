// SPDX-License-Identifier: BSD-3-Clause
#include "core/text.hpp"

#include <gtest/gtest.h>

namespace packbed {
namespace {

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(edit_distance("friction", "friction"), 0U);
  EXPECT_EQ(edit_distance("frction", "friction"), 1U);
  EXPECT_EQ(edit_distance("friiction", "friction"), 1U);
  EXPECT_EQ(edit_distance("frixtion", "friction"), 1U);
  EXPECT_EQ(edit_distance("firction", "friction"), 1U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(EditDistance, TakesBothCasesAlike) { EXPECT_EQ(edit_distance("SEP", "sep"), 0U); }

TEST(Nearest, FindsTheSlipAndLeavesOtherWordsAlone) {
  const std::vector<std::string> known = {"friction", "wall_friction", "density"};

  EXPECT_EQ(nearest("wall_fricton", known), "wall_friction");
  EXPECT_EQ(nearest("Density", known), "density");
  EXPECT_EQ(nearest("temperature", known), std::nullopt);
}

TEST(Nearest, OfNothingIsNothing) { EXPECT_EQ(nearest("a", {}), std::nullopt); }

TEST(ToNumber, TakesTheWholeTextOrNothing) {
  EXPECT_EQ(to_number(" 1.5e-3 "), 1.5e-3);
  EXPECT_EQ(to_number("+2"), 2.0);
  for (const auto* refused : {"", "1,5", "1.5 um", "++2", "nan", "inf", "-inf", "0x10", "1e999"}) {
    EXPECT_EQ(to_number(refused), std::nullopt) << refused;
  }
}

TEST(Shortest, ReadsBackToTheSameDouble) {
  for (const double value : {0.1, 8.69e-5, 1.0 / 3.0, 1e10, 4.9e-324, 0.007675}) {
    EXPECT_EQ(to_number(shortest(value)), value);
  }
}

TEST(EitherOf, ReadsAsASentence) {
  const std::vector<std::string> names = {"slice", "cylinder", "box"};
  EXPECT_EQ(either_of(names), "slice, cylinder or box");
}

}  // namespace
}  // namespace packbed
