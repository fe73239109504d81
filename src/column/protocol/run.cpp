// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/run.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::column {

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

void RunStage::begin(dem::Dem& dem) {
  dem.set_step(plan_.step);
  if (!force_step_ && plan_.steps > 0) check_stable(dem, plan_.step);
}

After RunStage::advance(dem::Dem& dem) {
  const auto to_output = plan_.output_every - done_ % plan_.output_every;
  const auto now = std::min({steps_per_slice(dem.bead_count()), to_output, plan_.steps - done_});
  dem.run(now);
  done_ += now;
  const bool ends = done_ >= plan_.steps;
  if (!ends && now < to_output) return After::goes_on;
  if (plan_.steps == 0) return After::end;
  dem.check_overlaps();
  if (!force_step_) check_stable(dem, plan_.step);
  return ends ? After::end : After::output;
}

double RunStage::share_done(const dem::Dem& /*dem*/) const {
  return plan_.steps > 0 ? static_cast<double>(done_) / static_cast<double>(plan_.steps) : 1.0;
}

std::string RunStage::result(const dem::Dem& /*dem*/) const {
  return fmt::format("{} steps of {:.6g} s", plan_.steps, plan_.step);
}

nlohmann::ordered_json RunStage::save() const { return {{"done", done_}}; }

void RunStage::load(const nlohmann::ordered_json& saved) { done_ = saved.at("done"); }

}  // namespace packbed::column
