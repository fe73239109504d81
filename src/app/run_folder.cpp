// SPDX-License-Identifier: BSD-3-Clause
#include "app/run_folder.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::app {
namespace {

namespace fs = std::filesystem;

bool is_frame(const fs::path& file) {
  const auto name = file.filename().string();
  return name.starts_with("beads_") && (name.ends_with(".csv") || name.ends_with(".csv.part"));
}

/// What runs have written in `folder`: nothing of it may stand beside what the next one writes.
std::vector<fs::path> results_in(const fs::path& folder) {
  std::vector<fs::path> results;
  std::error_code none;
  for (const auto* name : {"summary.json", "series.csv", "case.toml", "run.log"}) {
    if (fs::exists(folder / name, none)) results.push_back(folder / name);
  }
  for (const auto& entry : fs::directory_iterator(folder / "frames", none)) {
    if (is_frame(entry.path())) results.push_back(entry.path());
  }
  return results;
}

}  // namespace

void make_run_folder(const fs::path& folder, bool overwrite, const std::vector<fs::path>& inputs) {
  const auto results = results_in(folder);
  std::error_code failed;
  for (const auto& result : results) {
    for (const auto& input : inputs) {
      if (!fs::equivalent(result, input, failed)) continue;
      throw ConfigError(fmt::format(
          "{}: the run reads this file and would replace it; take another folder with -o DIR",
          result.string()));
    }
  }
  if (!overwrite && !results.empty()) {
    throw ConfigError(
        fmt::format("{}: there are results of an earlier run; take another folder "
                    "with -o DIR, or replace them with --overwrite",
                    folder.string()));
  }
  for (const auto& result : results) {
    if (fs::remove(result, failed) || !failed) continue;
    throw DataError(
        fmt::format("{}: cannot be taken away ({})", result.string(), failed.message()));
  }
  fs::create_directories(folder, failed);
  if (failed) {
    throw DataError(
        fmt::format("{}: the folder cannot be made ({})", folder.string(), failed.message()));
  }
}

}  // namespace packbed::app
