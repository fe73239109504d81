// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/run_step.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::column {
namespace {

void check_stable(const dem::Dem& dem, double step) {
  const auto limit = dem.stable();
  if (step <= limit.step) return;
  throw DivergenceError(fmt::format(
      "step {}, time {:.6g} s: the time step {:.4g} s is above the stable one, {:.4g} s, which "
      "bead {} "
      "at ({:.6g}, {:.6g}, {:.6g}) mm with {} contacts sets ({}); give a smaller numerics.step, or "
      "numerics.force_step = true",
      dem.steps(), dem.time(), step, limit.step, limit.bead, 1e3 * limit.x.x, 1e3 * limit.x.y,
      1e3 * limit.x.z, limit.contacts,
      limit.of_all ? "all of them together" : "by the stiffest of them alone"));
}

}  // namespace

RunPlan plan_run(double duration, double step, double interval) {
  if (duration <= 0.0) return {.steps = 0, .step = step, .output_every = 1};
  constexpr double rounding = 1e-9;    // 10 us at 10 ns are 1000 steps, not 1001
  constexpr double most_steps = 9e15;  // whole numbers of a double
  if (duration / step > most_steps) {
    throw ConfigError(fmt::format(
        "a step \"run\" of {:.4g} s takes {:.3g} time steps of {:.4g} s, more than can be "
        "counted; give a shorter duration",
        duration, duration / step, step));
  }
  const auto steps =
      std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(duration / step - rounding)));
  const double dt = duration / static_cast<double>(steps);
  const auto every = std::max<std::int64_t>(1, std::llround(std::min(interval / dt, most_steps)));
  return {.steps = steps, .step = dt, .output_every = every};
}

void run_step(dem::Dem& dem,
              const RunPlan& plan,
              bool force_step,
              const std::function<void()>& output) {
  dem.set_step(plan.step);
  if (!force_step && plan.steps > 0) check_stable(dem, plan.step);
  for (std::int64_t done = 0; done < plan.steps;) {
    const auto now = std::min(plan.output_every, plan.steps - done);
    dem.run(now);
    done += now;
    dem.check_overlaps();
    if (!force_step) check_stable(dem, plan.step);
    output();
  }
}

}  // namespace packbed::column
