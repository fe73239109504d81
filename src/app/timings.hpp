// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Where the wall time of a run goes, stage by stage, by the clock of the first rank. No result depends on it.
/// It is kept beside the checkpoints and not in them: equal runs have equal checkpoints.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/progress.hpp"
#include "column/coupled_bed.hpp"
#include "core/stopwatch.hpp"

namespace packbed::app {

/// Wall times [s] of one stage, of all runs that had a part in it.
struct StageTimings {
  std::int64_t stage = 0;  ///< from 1
  std::string name{};
  double beads = 0.0;     ///< their motion, and what a stage looks at to lead it
  double coupling = 0.0;  ///< weights, fields of the beads, drag
  double liquid = 0.0;
  double outputs = 0.0;  ///< checkpoints included
  double wall = 0.0;     ///< all of it
};

/// Wall times of a stage while it is under way.
class StageClock {
 public:
  /// `before`: what earlier runs had spent on the stage. `liquid` lives as long as the clock; null where there
  /// is none.
  StageClock(StageTimings before, const column::CoupledBed* liquid);

  Stopwatch advance;  ///< the stage itself
  Stopwatch outputs;
  [[nodiscard]] StageTimings now() const;

 private:
  StageTimings before_;
  const column::CoupledBed* liquid_;
  double coupling_start_ = 0.0;
  double liquid_start_ = 0.0;
  Clock::time_point start_ = Clock::now();
};

/// "stage 2 took 12.3 s: beads 8.1, coupling 1.2, liquid 2.5, outputs 0.4"
std::string in_words(const StageTimings& t);

/// As in summary.json.
nlohmann::ordered_json to_json(const std::vector<StageTimings>& timings);

/// Writes and reads checkpoints/timings.json of the run's folder. Reading: nothing where the file is missing;
/// throws DataError if it is broken.
void write_timings(const std::filesystem::path& folder, const std::vector<StageTimings>& timings);
std::vector<StageTimings> read_timings(const std::filesystem::path& folder);

/// The entry of a stage, made if there is none; those of later stages are taken away.
StageTimings& entry_of(std::vector<StageTimings>& timings,
                       std::int64_t stage,
                       std::string_view name);

}  // namespace packbed::app
