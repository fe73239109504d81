// SPDX-License-Identifier: BSD-3-Clause
// Checkpoints on several ranks, under mpiexec:
//   checkpoint_ranks_test write FOLDER   writes FOLDER/RANKS/checkpoint_*.h5, and fails on a full disk
//   checkpoint_ranks_test read FOLDER    reads those of all numbers of ranks on this one
#include <csignal>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string>

#include <sys/resource.h>

#include "core/file.hpp"
#include "io/checkpoint.hpp"
#include "io/on_all.hpp"

namespace packbed::io {
namespace {

constexpr std::int64_t rows = 1000;
constexpr std::int64_t number = 42;

double real(std::int64_t row, std::size_t column) {
  return 1.0 / (1.0 + static_cast<double>(row)) + static_cast<double>(column);
}

/// Rows of this rank: unequal shares, the second rank has none.
std::pair<std::int64_t, std::int64_t> share(const Ranks& ranks) {
  const auto begin = [&](int rank) {
    const auto r =
        static_cast<std::int64_t>(rank == 1 ? 2 : rank);  // as much is before 1 as before 2
    return rank >= ranks.size() ? rows : rows * r * r / (ranks.size() * ranks.size());
  };
  return {begin(ranks.rank()), begin(ranks.rank() + 1)};
}

void write(const std::filesystem::path& folder, std::int64_t step, const Ranks& ranks) {
  const auto [first, end] = share(ranks);
  std::vector<double> reals;
  std::vector<std::int64_t> ids;
  std::vector<std::uint8_t> flags;
  for (std::int64_t row = first; row < end; ++row) {
    for (std::size_t column = 0; column < 3; ++column) reals.push_back(real(row, column));
    ids.push_back(rows - row);
    flags.push_back(static_cast<std::uint8_t>(row % 256));
  }
  CheckpointWriter writer(folder, step, ranks);
  writer.array("reals", reals, 3);
  writer.array("dem/ids", ids);
  writer.array("flags", flags);
  writer.array("nothing", std::vector<std::int32_t>{});
  // What differs between ranks: rank 0's counts.
  writer.number("time_s", 0.5 + ranks.rank());
  writer.integer("step", 7 + ranks.rank());
  writer.text("case", std::string(static_cast<std::size_t>(5 + ranks.rank()), 'x'));
  writer.commit();
}

/// Number of things that are wrong in a checkpoint.
int check(const CheckpointReader& reader) {
  int wrong = 0;
  const auto expect = [&](bool ok, const char* what) {
    if (ok) return;
    ++wrong;
    std::printf("%s: wrong\n", what);
  };
  expect(reader.rows("reals") == rows && reader.width("reals") == 3, "form of reals");
  expect(reader.rows("nothing") == 0, "an empty array");
  std::int64_t seen = 0;
  reader.for_each_chunk<double>("reals", 64,
                                [&](std::int64_t first, std::span<const double> values) {
                                  for (std::size_t k = 0; k < values.size(); ++k) {
                                    const auto row = first + static_cast<std::int64_t>(k / 3);
                                    if (values[k] == real(row, k % 3)) ++seen;
                                  }
                                });
  expect(seen == 3 * rows, "reals");
  const auto ids = reader.read<std::int64_t>("dem/ids");
  const auto flags = reader.read<std::uint8_t>("flags");
  for (std::int64_t row = 0; row < rows; ++row) {
    const auto k = static_cast<std::size_t>(row);
    expect(ids.at(k) == rows - row, "ids");
    expect(flags.at(k) == row % 256, "flags");
  }
  expect(reader.number("time_s") == 0.5, "a number");
  expect(reader.integer("step") == 7, "an integer");
  expect(reader.text("case") == "xxxxx", "a text");
  return wrong;
}

/// What a rank is told when no file may be longer than this from then on; "" if nothing.
template <class Act>
std::string told_when_limited_to(rlim_t bytes, Act act) {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit limit{.rlim_cur = bytes, .rlim_max = before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  std::string told;
  try {
    act();
  } catch (const DataError& error) {
    told = error.what();
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  return told;
}

/// A full disk: every rank gets the same message, the checkpoint before is as it was.
int check_full_disk(const std::filesystem::path& folder, const Ranks& ranks) {
  int wrong = 0;
  const std::vector<double> much(100000);
  const auto expect = [&](const std::string& told, const char* when) {
    if (told.find("File too large") != std::string::npos && told == first_said(ranks, told)) return;
    ++wrong;
    std::printf("rank %d: %s, it says \"%s\"\n", ranks.rank(), when, told.c_str());
  };
  expect(told_when_limited_to(1100000,
                              [&] {
                                CheckpointWriter writer(folder, number + 1, ranks);
                                writer.array("much", much);
                              }),
         "no room for an array");
  std::optional<CheckpointWriter> writer(std::in_place, folder, number + 1, ranks);
  writer->array("much", much);
  const auto told = told_when_limited_to(1000, [&] { writer->commit(); });
  writer.reset();
  if (told.find("h5.part: writing failed") == std::string::npos) ++wrong;
  expect(told_when_limited_to(10000, [&] { write(folder, number + 1, ranks); }), "no room at all");
  if (checkpoints(folder) != std::vector{checkpoint_file(folder, number)}) ++wrong;
  if (std::distance(std::filesystem::directory_iterator(folder), {}) != 1) ++wrong;
  return wrong + check(CheckpointReader(checkpoint_file(folder, number), ranks));
}

int check_damage(const std::filesystem::path& folder, const Ranks& ranks) {
  const auto file = folder / "altered.h5";
  on_first(ranks, [&] {
    auto text = read_text_file(checkpoint_file(folder / "1", number));
    text[text.size() / 2] ^= 4;
    write_text_file(file, text);
  });
  std::string told;
  try {
    const CheckpointReader reader(file, ranks);
  } catch (const DataError& error) {
    told = error.what();
  }
  return told.find("altered") != std::string::npos ? 0 : 1;
}

int write_all(const std::filesystem::path& folder, const Ranks& ranks) {
  const auto mine = folder / std::to_string(ranks.size());
  on_first(ranks, [&] { std::filesystem::remove_all(mine); });
  write(mine, number, ranks);
  return check_full_disk(mine, ranks);
}

int read_all(const std::filesystem::path& folder, const Ranks& ranks) {
  int wrong = check_damage(folder, ranks);
  const auto first = read_text_file(checkpoint_file(folder / "1", number));
  for (const auto* written_on : {"1", "2", "3"}) {
    const auto file = checkpoint_file(folder / written_on, number);
    wrong += check(CheckpointReader(file, ranks));
    if (read_text_file(file) != first) {
      std::printf("%s ranks wrote other bytes than one\n", written_on);
      ++wrong;
    }
  }
  return wrong;
}

}  // namespace
}  // namespace packbed::io

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const packbed::MpiSession session;
  const auto ranks = packbed::Ranks::all();
  std::vector<std::int64_t> wrong = {std::strcmp(argv[1], "write") == 0
                                         ? packbed::io::write_all(argv[2], ranks)
                                         : packbed::io::read_all(argv[2], ranks)};
  ranks.sum(wrong);
  if (ranks.is_first()) {
    std::printf("%d ranks: %lld differences\n", ranks.size(), static_cast<long long>(wrong[0]));
  }
  return wrong[0] == 0 ? 0 : 1;
}
