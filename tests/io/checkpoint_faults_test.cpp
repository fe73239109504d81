// SPDX-License-Identifier: BSD-3-Clause
// What may happen to a checkpoint and its folder: damage, another program, a full disk, kill -9.
#include <csignal>
#include <fstream>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/version.hpp"
#include "io/checkpoint.hpp"
#include "io/checkpoint_seal.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/temporary_folder.hpp"

namespace packbed::io {
namespace {

using test::message_of;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<std::int32_t> some = {3, 1, 4, 1, 5};

std::filesystem::path write(const std::filesystem::path& folder, std::int64_t number) {
  CheckpointWriter writer(folder, number, Ranks::alone());
  writer.array("some", some);
  return writer.commit();
}

void open(const std::filesystem::path& file) {
  const CheckpointReader reader(file, Ranks::alone());
}

std::vector<std::string> names(const std::filesystem::path& folder) {
  std::vector<std::string> all;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    all.push_back(entry.path().filename().string());
  }
  std::ranges::sort(all);
  return all;
}

/// Runs an act in a process of its own and returns the signal that ended it, or else its exit code.
int in_another_process(const std::function<void()>& act) {
  const auto child = ::fork();
  if (child == 0) {
    act();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
}

/// From here on this process writes no file longer than this.
void limit_files_to(rlim_t bytes) {
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{.rlim_cur = bytes, .rlim_max = bytes};
  ::setrlimit(RLIMIT_FSIZE, &limit);
}

TEST(CheckpointFaults, EveryFlippedBitIsNoticed) {
  const TemporaryFolder folder;
  const auto file = write(folder.path(), 1);
  auto text = read_text_file(file);
  std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
  const auto put = [&](std::size_t k) {
    stream.seekp(static_cast<std::streamoff>(k)).put(text[k]).flush();
  };
  for (std::size_t k = 0; k < text.size(); ++k) {
    const auto flipped = static_cast<char>(1U << (k % 8));
    text[k] = static_cast<char>(text[k] ^ flipped);
    put(k);
    ASSERT_THAT(message_of([&] { open(file); }), HasSubstr(k < 19 ? "damaged" : "altered"))
        << "byte " << k;
    text[k] = static_cast<char>(text[k] ^ flipped);
    put(k);
  }
  open(file);
}

TEST(CheckpointFaults, EveryTruncationIsNoticed) {
  const TemporaryFolder folder;
  const auto file = write(folder.path(), 1);
  std::ofstream(file, std::ios::app) << 'x';
  EXPECT_THAT(message_of([&] { open(file); }), HasSubstr("has grown"));

  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 1);
  open(file);
  for (auto length = std::filesystem::file_size(file); length-- > 0;) {
    std::filesystem::resize_file(file, length);
    ASSERT_THAT(message_of([&] { open(file); }), HasSubstr("truncated")) << length << " bytes";
  }
}

TEST(CheckpointFaults, AnotherFormatIsNamed) {
  const TemporaryFolder folder;
  const auto file = write(folder.path(), 1);
  seal(file, checkpoint_format + 1);

  EXPECT_THAT(message_of([&] { open(file); }),
              HasSubstr("the checkpoint has format " + std::to_string(checkpoint_format + 1) +
                        ", written by packbed " + version + "; packbed " + version +
                        " reads format " + std::to_string(checkpoint_format)));
}

TEST(CheckpointFaults, ForeignFilesAreNamed) {
  const TemporaryFolder folder;
  const auto foreign = folder.file("beads.hdf", "\x89HDF\r\n and more");

  EXPECT_THAT(message_of([&] { open(foreign); }),
              HasSubstr(foreign.string() + ": it is no checkpoint of packbed"));
  EXPECT_THAT(message_of([&] { open(folder.path()); }), HasSubstr("a folder, not a checkpoint"));
  EXPECT_THAT(message_of([&] { open(folder.path() / "none.h5"); }),
              HasSubstr("none.h5: cannot be opened (No such file or directory)"));
}

TEST(CheckpointFaults, OldOnesArePrunedByNumber) {
  const TemporaryFolder folder;
  for (const std::int64_t number : {20L, 3L, 1000000000000L, 100L}) write(folder.path(), number);
  static_cast<void>(folder.file("checkpoint_mine.h5", "not ours"));

  prune_checkpoints(folder.path());

  EXPECT_THAT(names(folder.path()),
              ElementsAre("checkpoint_000000000100.h5", "checkpoint_1000000000000.h5",
                          "checkpoint_mine.h5"));
  EXPECT_EQ(latest_checkpoint(folder.path()), checkpoint_file(folder.path(), 1000000000000));
  EXPECT_EQ(latest_checkpoint(folder.path() / "none"), std::nullopt);
}

TEST(CheckpointFaults, WithoutCommitNothingIsLeft) {
  const TemporaryFolder folder;
  {
    CheckpointWriter writer(folder.path(), 5, Ranks::alone());
    writer.array("some", some);
  }
  EXPECT_THAT(names(folder.path()), IsEmpty());
}

TEST(CheckpointFaults, AKilledWriterLeavesTheOldOne) {
  const TemporaryFolder folder;
  const auto old = write(folder.path(), 1);
  for (int arrays = 0; arrays < 4; ++arrays) {
    const auto killed = in_another_process([&] {
      CheckpointWriter writer(folder.path(), 2, Ranks::alone());
      for (int k = 0; k < arrays; ++k) writer.array(std::to_string(k), some);
      ::raise(SIGKILL);
    });
    ASSERT_EQ(killed, SIGKILL);
    ASSERT_THAT(names(folder.path()),
                ElementsAre(old.filename(), "checkpoint_000000000002.h5.part"));
    ASSERT_EQ(latest_checkpoint(folder.path()), old);
    open(old);
  }

  const auto next = write(folder.path(), 3);

  EXPECT_THAT(names(folder.path()), ElementsAre(old.filename(), next.filename()));
}

TEST(CheckpointFaults, KilledAtAnyTimeThereIsAWholeOne) {
  const TemporaryFolder folder;
  write(folder.path(), 0);
  for (int turn = 0; turn < 20; ++turn) {
    const auto child = ::fork();
    if (child == 0) {
      for (std::int64_t number = 1;; ++number) {
        write(folder.path(), number);
        prune_checkpoints(folder.path());
      }
    }
    ::usleep(static_cast<useconds_t>(1000 + 1700 * turn));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const auto latest = latest_checkpoint(folder.path());
    ASSERT_TRUE(latest.has_value());
    open(*latest);
  }
}

TEST(CheckpointFaults, AFullDiskIsToldAndTheOldOneStays) {
  const TemporaryFolder folder;
  const auto old = write(folder.path(), 1);
  const std::vector<double> much(200000);
  const auto message_when_full = [&](rlim_t bytes, const std::function<void()>& act) {
    const auto told = folder.path() / "told";
    EXPECT_EQ(in_another_process([&] {
                const auto message = message_of([&] {
                  limit_files_to(bytes);
                  act();
                });
                write_text_file(told, message);
                std::exit(0);  // NOLINT(concurrency-mt-unsafe): with all that is done at the end
              }),
              0);
    const auto message = read_text_file(told);
    std::filesystem::remove(told);
    EXPECT_THAT(names(folder.path()), ElementsAre(old.filename()));
    open(old);
    return message;
  };

  // No room to begin, none for the array.
  for (const rlim_t bytes : {10000UL, 1200000UL}) {
    EXPECT_THAT(message_when_full(bytes,
                                  [&] {
                                    CheckpointWriter writer(folder.path(), 2, Ranks::alone());
                                    writer.array("much", much);
                                  }),
                HasSubstr("checkpoint_000000000002.h5.part: cannot be written (File too large)"));
  }
  // And one that HDF5 meets itself, when it closes the file.
  EXPECT_THAT(message_when_full(1'000'000'000,
                                [&] {
                                  CheckpointWriter writer(folder.path(), 2, Ranks::alone());
                                  writer.array("much", much);
                                  limit_files_to(1000);
                                  writer.commit();
                                }),
              HasSubstr("checkpoint_000000000002.h5.part: writing failed (File too large)"));
}

TEST(CheckpointFaults, AFolderThatCannotBeWrittenIsTold) {
  const TemporaryFolder folder;
  const auto file = folder.file("checkpoints", "a file where the folder should be");

  EXPECT_THAT(message_of([&] { CheckpointWriter(file, 1, Ranks::alone()); }),
              HasSubstr(file.string() + ": the folder cannot be made"));
  EXPECT_THAT(message_of([&] { CheckpointWriter("/proc", 1, Ranks::alone()); }),
              HasSubstr("/proc/checkpoint_000000000001.h5.part: cannot be written ("));
}

}  // namespace
}  // namespace packbed::io
