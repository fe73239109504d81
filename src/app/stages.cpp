// SPDX-License-Identifier: BSD-3-Clause
#include "app/stages.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "column/protocol/flow_stage.hpp"
#include "column/protocol/run.hpp"
#include "column/protocol/settle_stage.hpp"
#include "column/protocol/tap_stage.hpp"
#include "setup/any_flow.hpp"
#include "setup/make_liquid.hpp"
#include "setup/make_settle.hpp"

namespace packbed::app {
namespace {

using Steps = std::vector<setup::ProtocolStep>;

constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();

std::int64_t count(const Steps& steps);

std::int64_t count(const setup::ProtocolStep& step) {
  const auto* repeat = std::get_if<setup::Repeat>(&step.what);
  if (repeat == nullptr) return 1;
  const auto inner = count(repeat->steps);
  return inner > most / repeat->count ? most : inner * repeat->count;
}

std::int64_t count(const Steps& steps) {
  std::int64_t sum = 0;
  for (const auto& step : steps) {
    const auto here = count(step);
    sum = here > most - sum ? most : sum + here;
  }
  return sum;
}

const setup::ProtocolStep& find(const Steps& steps, std::int64_t k) {
  for (const auto& step : steps) {
    const auto here = count(step);
    if (k >= here) {
      k -= here;
      continue;
    }
    const auto* repeat = std::get_if<setup::Repeat>(&step.what);
    return repeat == nullptr ? step : find(repeat->steps, k % count(repeat->steps));
  }
  assert(false && "no such stage");
  return steps.back();
}

// Measured: beds of 8 to 31 mm take about so many from the cloud to rest.
constexpr double steps_of_a_settling = 2.5e5;
constexpr double steps_of_a_tap = 5e4;
constexpr double steps_longer_in_a_flow = 30.0;  // inertia is scaled by some 1000
constexpr double usual_plateau = 0.5;            // until steady [s]

double steps_of(const setup::Case& c, const setup::ProtocolStep& step, double dt) {
  if (const auto* run = std::get_if<setup::Run>(&step.what)) {
    return static_cast<double>(column::plan_run(run->duration, dt, c.output.interval).steps);
  }
  if (const auto* tap = std::get_if<setup::Tap>(&step.what)) {
    return steps_of_a_tap * static_cast<double>(tap->count + 1);
  }
  const double flow_step = steps_longer_in_a_flow * dt;
  if (const auto* ramp = std::get_if<setup::FlowRamp>(&step.what)) {
    return static_cast<double>(ramp->steps) * ramp->hold.value_or(usual_plateau) / flow_step;
  }
  if (const auto* hold = std::get_if<setup::Hold>(&step.what)) return hold->duration / flow_step;
  return steps_of_a_settling;
}

double steps_of_all(const setup::Case& c, const Steps& steps, double dt) {
  double total = 0.0;
  for (const auto& step : steps) {
    const auto* repeat = std::get_if<setup::Repeat>(&step.what);
    total += repeat == nullptr
                 ? steps_of(c, step, dt)
                 : static_cast<double>(repeat->count) * steps_of_all(c, repeat->steps, dt);
  }
  return total;
}

/// Velocity with which stage k begins [m/s].
double flow_before(const setup::Case& c, std::int64_t k) {
  for (--k; k >= 0; --k) {
    const auto& what = protocol_step(c, k).what;
    if (const auto* ramp = std::get_if<setup::FlowRamp>(&what)) return ramp->to;
    const auto* hold = std::get_if<setup::Hold>(&what);
    if (hold != nullptr && hold->flow) return *hold->flow;
    if (hold == nullptr) return 0.0;  // other steps are without a flow
  }
  return 0.0;
}

bool are_known(const Steps& steps) {
  return std::ranges::all_of(steps, [](const auto& s) {
    const auto* repeat = std::get_if<setup::Repeat>(&s.what);
    return std::holds_alternative<setup::Run>(s.what) ||
           std::holds_alternative<setup::Settle>(s.what) ||
           std::holds_alternative<setup::Tap>(s.what) ||
           std::holds_alternative<setup::FlowRamp>(s.what) ||
           std::holds_alternative<setup::Hold>(s.what) ||
           (repeat != nullptr && are_known(repeat->steps));
  });
}

}  // namespace

std::int64_t stage_count(const setup::Case& c) { return count(c.protocol); }

const setup::ProtocolStep& protocol_step(const setup::Case& c, std::int64_t k) {
  return find(c.protocol, k);
}

bool has_flow(const setup::Case& c) { return setup::any_flow(c.protocol); }

bool has_flow(const setup::Case& c, std::int64_t k) {
  const auto& what = protocol_step(c, k).what;
  if (std::holds_alternative<setup::FlowRamp>(what)) return true;
  const auto* hold = std::get_if<setup::Hold>(&what);
  return hold != nullptr && hold->flow.value_or(flow_before(c, k)) != 0.0;
}

std::unique_ptr<column::Stage> make_stage(const setup::Case& c,
                                          std::int64_t k,
                                          const dem::StepChoice& step,
                                          column::CoupledBed* liquid) {
  const auto& what = protocol_step(c, k).what;
  const double interval = c.output.interval;
  if (const auto* settle = std::get_if<setup::Settle>(&what)) {
    const bool first = k == 0 && setup::makes_beads(c) && setup::settles_first(c);
    return std::make_unique<column::SettleStage>(setup::settle_options(c, *settle, step, first),
                                                 interval);
  }
  if (const auto* tap = std::get_if<setup::Tap>(&what)) {
    return std::make_unique<column::TapStage>(setup::tap_options(c, *tap, step), interval);
  }
  if (const auto* ramp = std::get_if<setup::FlowRamp>(&what)) {
    return std::make_unique<column::FlowStage>(setup::flow_options(c, *ramp, step), *liquid);
  }
  const auto* hold = std::get_if<setup::Hold>(&what);
  if (hold != nullptr && has_flow(c, k)) {
    return std::make_unique<column::FlowStage>(
        setup::flow_options(c, *hold, flow_before(c, k), step), *liquid);
  }
  const double duration = hold != nullptr ? hold->duration : std::get<setup::Run>(what).duration;
  return std::make_unique<column::RunStage>(column::plan_run(duration, step.step, interval),
                                            c.numerics.force_step);
}

double expected_steps(const setup::Case& c, double step) {
  return steps_of_all(c, c.protocol, step);
}

double expected_steps(const setup::Case& c, std::int64_t k, double step) {
  return steps_of(c, protocol_step(c, k), step);
}

bool can_simulate(const setup::Case& c) {
  return (c.beads.csv || c.beads.run || setup::makes_beads(c)) && are_known(c.protocol);
}

}  // namespace packbed::app
