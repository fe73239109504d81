// SPDX-License-Identifier: BSD-3-Clause
#include "io/checkpoint.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/support/message_of.hpp"
#include "tests/support/temporary_folder.hpp"

namespace packbed::io {
namespace {

using test::message_of;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;

const std::vector<double> reals = {0.1,       -0.0, 1e-310, std::numeric_limits<double>::infinity(),
                                   1.0 / 3.0, 2e300};
const std::vector<std::int64_t> longs = {-1, std::numeric_limits<std::int64_t>::max(), 0};
const std::vector<std::int32_t> ints = {7, std::numeric_limits<std::int32_t>::min()};
const std::vector<std::int8_t> shifts = {-1, 0, 1, 127, -128, 3};
const std::vector<std::uint8_t> flags = {0, 1, 255};
const std::vector<Vec3> vectors = {{1, 2, 3}, {-4, 5, 1e-9}};
constexpr const char* json = "{\"stage\": \"µm\"}\n";

std::filesystem::path write(const std::filesystem::path& folder, std::int64_t number) {
  CheckpointWriter writer(folder, number, Ranks::alone());
  writer.array("dem/reals", reals, 2);
  writer.array("dem/longs", longs);
  writer.array("ints", ints);
  writer.array("shifts", shifts, 3);
  writer.array("flags", flags);
  writer.array("dem/vectors", vectors);
  writer.array("nothing", std::vector<double>{}, 3);
  writer.number("time_s", 0.1);
  writer.integer("step", number);
  writer.text("case", json);
  writer.text("empty", "");
  return writer.commit();
}

CheckpointReader open(const std::filesystem::path& file) { return {file, Ranks::alone()}; }

TEST(Checkpoint, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  const auto reader = open(write(folder.path() / "new" / "folder", 3));

  EXPECT_EQ(reader.read<double>("dem/reals"), reals);
  EXPECT_TRUE(std::signbit(reader.read<double>("dem/reals")[1]));
  EXPECT_EQ(reader.read<std::int64_t>("dem/longs"), longs);
  EXPECT_EQ(reader.read<std::int32_t>("ints"), ints);
  EXPECT_EQ(reader.read<std::int8_t>("shifts"), shifts);
  EXPECT_EQ(reader.read<std::uint8_t>("flags"), flags);
  EXPECT_EQ(reader.read<Vec3>("dem/vectors"), vectors);
  EXPECT_EQ(reader.read<double>("nothing"), std::vector<double>{});
  EXPECT_EQ(reader.number("time_s"), 0.1);
  EXPECT_EQ(reader.integer("step"), 3);
  EXPECT_EQ(reader.text("case"), json);
  EXPECT_EQ(reader.text("empty"), "");
  EXPECT_EQ(reader.rows("dem/reals"), 3);
  EXPECT_EQ(reader.width("dem/reals"), 2U);
  EXPECT_EQ(reader.width("nothing"), 3U);
  EXPECT_TRUE(reader.has_array("shifts"));
  EXPECT_FALSE(reader.has_array("not/there"));
  EXPECT_THAT(reader.arrays(), ElementsAre("dem/longs", "dem/reals", "dem/vectors", "flags", "ints",
                                           "nothing", "shifts"));
}

TEST(Checkpoint, IsReadInPieces) {
  const TemporaryFolder folder;
  const auto reader = open(write(folder.path(), 3));

  std::vector<std::int8_t> all;
  std::vector<std::int64_t> firsts;
  reader.for_each_chunk<std::int8_t>("shifts", 1,
                                     [&](std::int64_t first, std::span<const std::int8_t> values) {
                                       firsts.push_back(first);
                                       all.insert(all.end(), values.begin(), values.end());
                                     });

  EXPECT_EQ(all, shifts);
  EXPECT_THAT(firsts, ElementsAre(0, 1));
  EXPECT_THAT(reader.read<double>("dem/reals", 1, 1), ElementsAre(reals[2], reals[3]));
}

TEST(Checkpoint, SaysWhatIsNotInIt) {
  const TemporaryFolder folder;
  const auto file = write(folder.path(), 3);
  const auto reader = open(file);

  EXPECT_THAT(message_of([&] { static_cast<void>(reader.read<double>("mass")); }),
              HasSubstr(file.string() + ": there is no \"arrays/mass\" in it"));
  EXPECT_THAT(message_of([&] { static_cast<void>(reader.read<double>("ints")); }),
              HasSubstr("array \"ints\" holds 1 x int32 in a row, not 1 x float64"));
  EXPECT_THAT(message_of([&] { static_cast<void>(reader.read<Vec3>("dem/reals")); }),
              HasSubstr("holds 2 x float64 in a row, not 3 x float64"));
  EXPECT_THAT(message_of([&] { static_cast<void>(reader.read<std::int32_t>("ints", 1, 2)); }),
              HasSubstr("array \"ints\" has 2 rows; 2 from row 1 on are not there"));
  EXPECT_THAT(message_of([&] { static_cast<void>(reader.integer("time_s")); }),
              HasSubstr("\"numbers/time_s\" is no single int64"));
  EXPECT_THAT(message_of([&] { static_cast<void>(reader.number("date")); }),
              HasSubstr("there is no \"numbers/date\" in it"));
  EXPECT_THAT(message_of([&] { static_cast<void>(reader.text("title")); }),
              HasSubstr("there is no \"texts/title\" in it"));
}

TEST(Checkpoint, RefusesANameTwice) {
  const TemporaryFolder folder;
  CheckpointWriter writer(folder.path(), 1, Ranks::alone());
  writer.array("x", ints);

  EXPECT_THAT(message_of([&] { writer.array("x", ints); }),
              HasSubstr("making array \"arrays/x\" failed"));
}

TEST(Checkpoint, OfEqualContentHasEqualBytes) {
  const TemporaryFolder folder;
  const auto first = read_text_file(write(folder.path() / "a", 3));
  ::sleep(1);  // so that a time in the file would show
  EXPECT_EQ(first, read_text_file(write(folder.path() / "b", 3)));
  EXPECT_NE(first, read_text_file(write(folder.path() / "c", 4)));
}

}  // namespace
}  // namespace packbed::io
