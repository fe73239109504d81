// SPDX-License-Identifier: BSD-3-Clause
#include "io/series.hpp"

#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/message_of.hpp"
#include "tests/support/temporary_folder.hpp"

namespace packbed::io {
namespace {

using test::message_of;
using test::TemporaryFolder;
using testing::HasSubstr;

const std::vector<std::string> columns = {"time_s", "step", "stage"};

TEST(Series, CountsItsBytes) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "series.csv";
  SeriesWriter series(file, columns);
  EXPECT_EQ(series.bytes(), 18);
  series.row({0.1, std::int64_t{7}, "fill"});
  series.sync();

  EXPECT_EQ(read_text_file(file), "time_s,step,stage\n0.1,7,fill\n");
  EXPECT_EQ(series.bytes(), 29);
}

TEST(Series, GoesOnWhereACheckpointWasWritten) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "series.csv";
  std::int64_t bytes = 0;
  {
    SeriesWriter series(file, columns);
    series.row({0.1, std::int64_t{1}, "fill"});
    bytes = series.bytes();
    series.row({0.2, std::int64_t{2}, "fill"});
  }
  std::ofstream(file, std::ios::app) << "0.3,3,fi";  // as a killed program may leave it

  auto series = SeriesWriter::resume(file, columns, bytes);
  series.row({0.25, std::int64_t{2}, "settle"});

  EXPECT_EQ(read_text_file(file), "time_s,step,stage\n0.1,1,fill\n0.25,2,settle\n");
  EXPECT_EQ(series.bytes(), static_cast<std::int64_t>(std::filesystem::file_size(file)));
}

TEST(Series, GoesOnAfterItsHeader) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "series.csv";
  { const SeriesWriter series(file, columns); }

  SeriesWriter::resume(file, columns, 18).row({0.0, std::int64_t{0}, "x"});

  EXPECT_EQ(read_text_file(file), "time_s,step,stage\n0,0,x\n");
}

TEST(Series, SaysWhyItCannotGoOn) {
  const TemporaryFolder folder;
  const auto file = folder.file("series.csv", "time_s,step,stage\n0.1,1,fill\n");
  const auto message = [&](const std::vector<std::string>& names, std::int64_t bytes) {
    return message_of([&] { SeriesWriter::resume(file, names, bytes); });
  };

  EXPECT_THAT(message({"time_s", "step"}, 18),
              HasSubstr("begins with \"time_s,step,stage\", not with \"time_s,step\""));
  EXPECT_THAT(message(columns, 40), HasSubstr("29 bytes are there, but 40 were when"));
  for (const std::int64_t bytes : {0, 17, 20, 28}) {
    EXPECT_THAT(message(columns, bytes), HasSubstr("no row ends after")) << bytes;
  }
  EXPECT_EQ(std::filesystem::file_size(file), 29U);  // nothing was cut
  std::filesystem::remove(file);
  EXPECT_THAT(message(columns, 18), HasSubstr("cannot be opened (No such file or directory)"));
}

TEST(Series, EndsWithAWholeRowWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "series.csv";
  const auto child = ::fork();
  if (child == 0) {
    SeriesWriter series(file, columns);
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{.rlim_cur = 40, .rlim_max = 40};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    series.row({0.1, std::int64_t{1}, "fill"});
    for (int attempt = 0; attempt < 2; ++attempt) {
      const auto told = message_of([&] { series.row({0.2, std::int64_t{2}, "long stage"}); });
      if (told.find("cannot be written (File too large)") == std::string::npos) ::_exit(1);
    }
    series.row({0.3, std::int64_t{3}, "f"});  // one that fits
    ::_exit(series.bytes() == 37 ? 0 : 2);
  }
  int status = 0;
  ::waitpid(child, &status, 0);

  EXPECT_EQ(status, 0);
  EXPECT_EQ(read_text_file(file), "time_s,step,stage\n0.1,1,fill\n0.3,3,f\n");
}

}  // namespace
}  // namespace packbed::io
