// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/stage.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::column {

std::int64_t steps_per_slice(std::int64_t beads) {
  constexpr std::int64_t bead_steps = 4'000'000;  // a fraction of a second
  return std::clamp<std::int64_t>(bead_steps / std::max<std::int64_t>(beads, 1), 10, 1000);
}

bool output_is_due(double time, double interval, double& next) {
  if (time < next) return false;
  while (next <= time) next += interval;
  return true;
}

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

}  // namespace packbed::column
