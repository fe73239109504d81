// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Carries out the protocol of a case, stage by stage, and writes its results.

#include <filesystem>
#include <string>
#include <vector>

#include "app/outputs.hpp"
#include "app/timings.hpp"
#include "setup/case.hpp"

namespace packbed::app {

/// What a run came to.
struct RunSummary {
  double simulated_time = 0.0;  ///< [s]
  std::int64_t steps = 0;
  std::int64_t renewals = 0;
  double step = 0.0;           ///< of the beads, the last one [s]
  double inertia_scale = 1.0;  ///< the last one
  std::int64_t beads = 0;      ///< at the end
  bool has_flow = false;
  bool has_plunger = false;  ///< one that moves
  RowFigures figures;
  std::vector<std::string> warnings;
  std::vector<StageTimings> timings;
  double wall_time = 0.0;  ///< of this process [s]
};

/// Runs it in `folder`, which exists. With `resume` it goes on from the last checkpoint there.
/// Throws Stopped after a signal, once a checkpoint is written. Progress goes to standard error.
RunSummary simulate(const setup::Case& c, const std::filesystem::path& folder, bool resume);

}  // namespace packbed::app
