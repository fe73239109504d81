// SPDX-License-Identifier: BSD-3-Clause
#include "core/csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/message_of.hpp"
#include "tests/support/temporary_folder.hpp"

namespace packbed {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

class Csv : public testing::Test {
 protected:
  CsvTable read(std::string_view text) const { return CsvTable(folder_.file("data.csv", text)); }
  std::string refusal(std::string_view text) const {
    return test::message_of([&] { read(text); });
  }
  test::TemporaryFolder folder_;
};

TEST_F(Csv, ReadsCellsByColumnName) {
  const auto table = read("a,b\n1,2\n 3 , 4\n");

  EXPECT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.number(1, table.find("b")), 4.0);
  EXPECT_EQ(table.find("c"), -1);
}

TEST_F(Csv, TakesByteOrderMarkCrLfBlankLinesAndComments) {
  const auto table = read("\xEF\xBB\xBF# beads\r\n\r\na,b\r\n1,2\r\n# more\r\n3,4\r\n");

  EXPECT_EQ(table.find("a"), 0);
  EXPECT_EQ(table.number(1, 1), 4.0);
  EXPECT_THAT(table.place(1), EndsWith("data.csv:6"));
}

TEST_F(Csv, NamesTheLineOfABadRow) {
  EXPECT_THAT(
      refusal("a,b\n1,2\n1,2,3\n"),
      EndsWith(
          "data.csv:3: cells in this row: 3, in the header: 2; decimals need points, not commas"));
}

TEST_F(Csv, RefusesOtherSeparatorsSayingWhich) {
  EXPECT_THAT(refusal("a;b\n1,5;2\n"), HasSubstr("not by semicolons"));
  EXPECT_THAT(refusal("a\tb\n1\t2\n"), HasSubstr("not by tabs"));
}

TEST_F(Csv, RefusesAMissingHeaderARepeatedColumnAndAnEmptyTable) {
  EXPECT_THAT(refusal("1,2\n3,4\n"), HasSubstr("the first row must be a header"));
  EXPECT_THAT(refusal("a,a\n1,2\n"), HasSubstr("column \"a\" is there twice"));
  EXPECT_THAT(refusal("a,b\n"), HasSubstr("it has no rows"));
  EXPECT_THAT(refusal(""), HasSubstr("it has no rows"));
}

TEST_F(Csv, NamesTheCellThatIsNoNumber) {
  const auto table = read("a,b\n1,nan\n");

  const auto message = test::message_of([&] { (void)table.number(0, 1); });

  EXPECT_THAT(message, EndsWith("data.csv:2: b = \"nan\" is not a finite number"));
}

TEST(ColumnNames, AreSplitFromTheirUnits) {
  EXPECT_EQ(split_column_name("diameter [um]").name, "diameter");
  EXPECT_EQ(split_column_name("diameter [um]").unit, "um");
  EXPECT_EQ(split_column_name("share").unit, "");
}

}  // namespace
}  // namespace packbed
