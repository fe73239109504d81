// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The protocol step "run": beads move for a time under what is there.

#include <cstdint>
#include <functional>

#include "dem/dem.hpp"

namespace packbed::column {

/// How a duration is cut into steps: all equal and a whole number of them, none longer than asked.
struct RunPlan {
  std::int64_t steps;
  double step;                ///< [s]
  std::int64_t output_every;  ///< steps between outputs
};

/// `duration`, `step`, `interval` in s; no steps for no duration.
RunPlan plan_run(double duration, double step, double interval);

/// Steps through the plan and calls `output` after every `output_every` steps and at the end.
/// Throws DivergenceError, at the start and at an output, for overlaps beyond the limit, and unless `force_step` for a
/// step above the stable one of the contacts that there are.
void run_step(dem::Dem& dem,
              const RunPlan& plan,
              bool force_step,
              const std::function<void()>& output);

}  // namespace packbed::column
