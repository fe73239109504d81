// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Checkpoints of a run: beads, the stage that is under way, how far the outputs go, and the case that
/// they belong to.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "column/coupled_bed.hpp"
#include "dem/dem.hpp"
#include "setup/case.hpp"
#include "setup/make_packing.hpp"

namespace packbed::app {

/// Where a run is.
struct RunState {
  std::int64_t stage = 0;              ///< that is under way or comes next, from 0
  nlohmann::ordered_json stage_state;  ///< null: it has not begun
  nlohmann::ordered_json outputs;      ///< Outputs::save()
  std::vector<std::string> warnings;   ///< so far
  setup::PackedBed bed;                ///< as the stage began
};

/// Writes checkpoints/STEP.h5 in the run's folder and takes all but the last two away. All ranks call.
/// Throws DataError if it cannot be written; earlier checkpoints are then left as they are.
std::filesystem::path write_checkpoint(const setup::Case& c,
                                       const std::filesystem::path& folder,
                                       const dem::Dem& dem,
                                       const column::CoupledBed* liquid,
                                       const RunState& state,
                                       int keep);

/// Takes all but the last `keep` away. All ranks call.
void prune_checkpoints(const std::filesystem::path& folder, int keep);

/// Calls `read`, which takes values from the texts of a checkpoint. Throws DataError, with the file's name, if they have
/// other names or types than this build of the program gives them.
void as_this_build_writes(const std::filesystem::path& file, const std::function<void()>& read);

struct LoadedCheckpoint {
  std::filesystem::path file;
  dem::DemState beads;                      ///< of all ranks
  std::optional<fluid::FluidState> liquid;  ///< likewise, where there is a flow
  RunState state;
};

/// A bed at the end of another run.
struct TakenBed {
  std::filesystem::path file;
  dem::DemState beads;
  std::optional<double> plunger;   ///< where it stood [m]
  nlohmann::ordered_json outputs;  ///< Outputs::save() of that run
};

/// The bed at the end of the run `c.beads.run`, as the start of this case: beads where they are, with their springs;
/// laws, walls and properties are those of the case. Throws ConfigError if column or sizes of beads differ,
/// naming the key; DataError if the checkpoint is truncated, altered or of another build.
TakenBed take_bed(const setup::Case& c, double step);

/// The last checkpoint in the run's folder. Throws ConfigError if there is none, or if it belongs to
/// another case (naming the first key that differs) or another version of the program; DataError
/// if it is truncated, altered or of another build.
LoadedCheckpoint read_checkpoint(const setup::Case& c, const std::filesystem::path& folder);

}  // namespace packbed::app
