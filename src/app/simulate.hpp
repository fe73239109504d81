// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Carries out the protocol of a case and writes its results.

#include <filesystem>
#include <string>

#include "setup/case.hpp"

namespace packbed::app {

/// What a run came to.
struct RunSummary {
  double simulated_time = 0.0;  ///< [s]
  std::int64_t steps = 0;
  std::int64_t renewals = 0;
  double step = 0.0;           ///< of the beads [s]
  double inertia_scale = 1.0;  ///< "auto" is 1 here: beads of a step "run" move freely
  double kinetic_to_elastic = 0.0;
  double unbalanced_force = 0.0;  ///< mean unbalanced / mean contact force
  double max_overlap_ratio = 0.0;
  double coordination_number = 0.0;
  double wall_time = 0.0;  ///< [s]
};

/// Whether this version can carry the whole protocol out: beads from a file, steps "run" only.
bool can_simulate(const setup::Case& c);

/// Runs it in `folder`, which exists: series.csv, run.log and, where asked for, frames/beads_N.csv.
/// Progress goes to standard error.
RunSummary simulate(const setup::Case& c, const std::filesystem::path& folder);

}  // namespace packbed::app
