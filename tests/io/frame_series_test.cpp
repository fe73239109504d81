// SPDX-License-Identifier: BSD-3-Clause
#include "io/frame_series.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/message_of.hpp"
#include "tests/support/temporary_folder.hpp"

namespace packbed::io {
namespace {

using nlohmann::json;
using test::message_of;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;

/// Frames at these times, each a file with its time in it.
FrameSeries series_of(const TemporaryFolder& folder, const std::vector<double>& times) {
  FrameSeries series(folder.path(), "beads");
  for (const double time : times) {
    write_text_file(series.next(), std::to_string(time));
    series.add(time);
  }
  return series;
}

TEST(FrameSeries, ListsFramesWithTheirTimes) {
  const TemporaryFolder folder;
  const auto series = series_of(folder, {0.0, 0.1, 1e-7 + 0.1});

  const json expected = {{"file-series-version", "1.0"},
                         {"files",
                          {{{"name", "beads_000000.hdf"}, {"time", 0.0}},
                           {{"name", "beads_000001.hdf"}, {"time", 0.1}},
                           {{"name", "beads_000002.hdf"}, {"time", 1e-7 + 0.1}}}}};
  EXPECT_EQ(series.list(), folder.path() / "beads.hdf.series");
  EXPECT_EQ(json::parse(read_text_file(series.list())), expected);
  EXPECT_EQ(series.next(), folder.path() / "beads_000003.hdf");
}

TEST(FrameSeries, GoesOnAfterACut) {
  const TemporaryFolder folder;
  const auto unbroken = read_text_file(series_of(folder, {0.0, 0.1, 0.2}).list());
  series_of(folder, {0.0, 0.1, 0.15, 0.19});
  static_cast<void>(folder.file("beads_000004.hdf", "written, not listed"));
  static_cast<void>(folder.file("beads_000005.hdf.part", "half written"));
  static_cast<void>(folder.file("beads_4.csv", "of something else"));
  static_cast<void>(folder.file("contacts_000003.hdf", "of another series"));

  auto series = FrameSeries::resume(folder.path(), "beads", 2);

  EXPECT_THAT(series.times(), ElementsAre(0.0, 0.1));
  for (const auto* gone :
       {"beads_000002.hdf", "beads_000003.hdf", "beads_000004.hdf", "beads_000005.hdf.part"}) {
    EXPECT_FALSE(std::filesystem::exists(folder.path() / gone)) << gone;
  }
  for (const auto* kept :
       {"beads_000000.hdf", "beads_000001.hdf", "beads_4.csv", "contacts_000003.hdf"}) {
    EXPECT_TRUE(std::filesystem::exists(folder.path() / kept)) << kept;
  }
  write_text_file(series.next(), "again");
  series.add(0.2);
  EXPECT_EQ(read_text_file(series.list()), unbroken);
}

TEST(FrameSeries, MayLeaveNumbersOutAndGoOnAfterThem) {
  const TemporaryFolder folder;
  FrameSeries series(folder.path(), "liquid");
  const auto add = [](FrameSeries& to, double time) {
    write_text_file(to.next(), std::to_string(time));
    to.add(time);
  };
  series.skip();
  series.skip();
  add(series, 0.2);
  add(series, 0.3);
  series.skip();
  EXPECT_EQ(series.extent().frames, 2U);
  EXPECT_EQ(series.extent().next_number, 5U);
  const auto extent = series.extent();
  add(series, 0.5);
  const auto unbroken = read_text_file(series.list());
  EXPECT_THAT(unbroken, HasSubstr("liquid_000005.hdf"));
  EXPECT_THAT(unbroken, testing::Not(HasSubstr("liquid_000004.hdf")));

  auto again = FrameSeries::resume(folder.path(), "liquid", extent);

  EXPECT_THAT(again.times(), ElementsAre(0.2, 0.3));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "liquid_000005.hdf"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "liquid_000003.hdf"));
  add(again, 0.5);
  EXPECT_EQ(read_text_file(again.list()), unbroken);
}

TEST(FrameSeries, MayGoOnBeforeItsFirstFrame) {
  const TemporaryFolder folder;
  EXPECT_EQ(FrameSeries::resume(folder.path(), "beads", 0).size(), 0U);
  EXPECT_EQ(FrameSeries::resume(folder.path() / "none", "beads", 0).size(), 0U);
  series_of(folder, {0.0});
  EXPECT_EQ(FrameSeries::resume(folder.path(), "beads", 0).size(), 0U);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "beads_000000.hdf"));
}

TEST(FrameSeries, SaysWhyItCannotGoOn) {
  const TemporaryFolder folder;
  const auto message = [&](std::size_t frames) {
    return message_of([&] { FrameSeries::resume(folder.path(), "beads", frames); });
  };
  EXPECT_THAT(message(1), HasSubstr("beads.hdf.series: cannot be opened"));
  series_of(folder, {0.0, 0.1});
  EXPECT_THAT(message(3), HasSubstr("it lists 2 frames, but 3 were written before the checkpoint"));
  std::filesystem::remove(folder.path() / "beads_000000.hdf");
  EXPECT_THAT(message(2), HasSubstr("beads_000000.hdf: this frame is missing"));
  static_cast<void>(folder.file("beads.hdf.series", "{\"files\": [{\"name\": 1}]}"));
  EXPECT_THAT(message(1), HasSubstr("beads.hdf.series: it is no list of frames"));
  static_cast<void>(
      folder.file("beads.hdf.series", "{\"files\": [{\"name\": \"x_1.hdf\", \"time\": 1}]}"));
  EXPECT_THAT(message(1), HasSubstr("it is no list of frames (\"x_1.hdf\""));
}

}  // namespace
}  // namespace packbed::io
