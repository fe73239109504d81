// SPDX-License-Identifier: BSD-3-Clause
#include "app/run_folder.hpp"

#include <algorithm>
#include <cerrno>
#include <string_view>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "core/error.hpp"

namespace packbed::app {
namespace {

namespace fs = std::filesystem;

/// Names of files that a run writes, as a beginning and an end.
struct Pattern {
  const char* folder;  ///< below that of the run
  std::string_view begin;
  std::string_view end;
};

constexpr Pattern patterns[] = {{"", "summary.json", ""},
                                {"", "series.csv", ""},
                                {"", "sections.csv", ""},
                                {"", "plateaus.csv", ""},
                                {"", "case.toml", ""},
                                {"", "run.log", ""},
                                {"", "measured.csv", ""},
                                {"", "report.html", ""},
                                {"frames", "beads_", ".csv"},
                                {"frames", "beads_", ".hdf"},
                                {"frames", "contacts_", ".hdf"},
                                {"frames", "liquid_", ".hdf"},
                                {"frames", "beads", ".series"},
                                {"frames", "contacts", ".series"},
                                {"frames", "liquid", ".series"},
                                {"profiles", "x_", ".csv"},
                                {"profiles", "y_", ".csv"},
                                {"profiles", "z_", ".csv"},
                                {"profiles", "wall_distance_", ".csv"},
                                {"profiles", "plateau_z_", ".csv"},
                                {"profiles", "plateau_x_", ".csv"},
                                {"profiles", "plateau_radius_", ".csv"},
                                {"analysis", "analysis.csv", ""},
                                {"analysis", "rearrangement.csv", ""},
                                {"analysis", "forces_", ".csv"},
                                {"analysis", "angles_", ".csv"},
                                {"analysis", "stress_", ".csv"},
                                {"analysis", "wall_porosity_", ".csv"},
                                {"analysis", "wall_velocity_", ".csv"},
                                {"checkpoints", "checkpoint_", ".h5"},
                                {"checkpoints", "timings.json", ""}};

bool matches(std::string name, const Pattern& pattern) {
  if (name.ends_with(".part")) name.resize(name.size() - 5);
  return pattern.end.empty() ? name == pattern.begin
                             : name.starts_with(pattern.begin) && name.ends_with(pattern.end);
}

/// What runs have written in `folder`: nothing of it may stand beside what the next one writes.
std::vector<fs::path> results_in(const fs::path& folder) {
  std::vector<fs::path> results;
  std::error_code none;
  for (const auto* below : {"", "frames", "profiles", "analysis", "checkpoints"}) {
    for (const auto& entry : fs::directory_iterator(folder / below, none)) {
      const auto is_ours = [&](const Pattern& p) {
        return std::string_view(p.folder) == below && matches(entry.path().filename().string(), p);
      };
      if (std::ranges::any_of(patterns, is_ours)) results.push_back(entry.path());
    }
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

FolderLock::FolderLock(const fs::path& folder)
    : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ < 0 || flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  const bool is_taken = errno == EWOULDBLOCK;
  close(descriptor_);
  descriptor_ = -1;
  if (!is_taken) return;  // a file system without locks
  throw ConfigError(
      fmt::format("{}: another run is writing there; wait until it has ended, or take another "
                  "folder with -o DIR",
                  folder.string()));
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace packbed::app
