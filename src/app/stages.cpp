// SPDX-License-Identifier: BSD-3-Clause
#include "app/stages.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "column/protocol/flow_stage.hpp"
#include "column/protocol/plunger_stage.hpp"
#include "column/protocol/run.hpp"
#include "column/protocol/settle_stage.hpp"
#include "column/protocol/tap_stage.hpp"
#include "setup/any_flow.hpp"
#include "setup/make_liquid.hpp"
#include "setup/make_packing.hpp"
#include "setup/make_settle.hpp"

namespace packbed::app {
namespace {

using Steps = std::vector<setup::ProtocolStep>;

constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();

std::int64_t count(const Steps& steps);

std::int64_t times(std::int64_t a, std::int64_t b) { return a > most / b ? most : a * b; }

/// Stages of a step.
std::int64_t count(const setup::ProtocolStep& step) {
  if (std::holds_alternative<setup::FlowPack>(step.what)) return 3;
  if (const auto* cycle = std::get_if<setup::Cycle>(&step.what)) return times(cycle->count, 2);
  const auto* repeat = std::get_if<setup::Repeat>(&step.what);
  return repeat == nullptr ? 1 : times(repeat->count, count(repeat->steps));
}

std::int64_t count(const Steps& steps) {
  std::int64_t sum = 0;
  for (const auto& step : steps) {
    const auto here = count(step);
    sum = here > most - sum ? most : sum + here;
  }
  return sum;
}

/// A stage: part k of a step.
struct Part {
  const setup::ProtocolStep& step;
  std::int64_t k = 0;
};

Part find(const Steps& steps, std::int64_t k) {
  for (const auto& step : steps) {
    const auto here = count(step);
    if (k >= here) {
      k -= here;
      continue;
    }
    const auto* repeat = std::get_if<setup::Repeat>(&step.what);
    return repeat == nullptr ? Part{step, k} : find(repeat->steps, k % count(repeat->steps));
  }
  assert(false && "no such stage");
  return {steps.back()};
}

Part part(const setup::Case& c, std::int64_t k) { return find(c.protocol, k); }

// Measured: beds of 8 to 31 mm take about so many from the cloud to rest.
constexpr double steps_of_a_settling = 2.5e5;
constexpr double steps_of_a_tap = 5e4;
constexpr double steps_longer_in_a_flow = 30.0;  // inertia is scaled by some 1000
constexpr double usual_plateau = 0.5;            // until steady [s]
constexpr double usual_way = 0.1;                // of the plunger, over the height of the column

double steps_of(const setup::Case& c, const setup::ProtocolStep& step, double dt) {
  const double flow_step = steps_longer_in_a_flow * dt;
  const auto plateau = [&](const std::optional<double>& hold) {
    return hold.value_or(usual_plateau) / flow_step;
  };
  const auto move = [&](double speed) {
    return usual_way * mesh::height(c.column.shape) / (speed * flow_step);
  };
  if (const auto* run = std::get_if<setup::Run>(&step.what)) {
    return static_cast<double>(column::plan_run(run->duration, dt, c.output.interval).steps);
  }
  if (const auto* tap = std::get_if<setup::Tap>(&step.what)) {
    return steps_of_a_tap * static_cast<double>(tap->count + 1);
  }
  if (const auto* ramp = std::get_if<setup::FlowRamp>(&step.what)) {
    return static_cast<double>(ramp->steps) * plateau(ramp->hold);
  }
  if (const auto* hold = std::get_if<setup::Hold>(&step.what)) return hold->duration / flow_step;
  if (const auto* compress = std::get_if<setup::Compress>(&step.what)) {
    return move(compress->move.speed);
  }
  if (const auto* relax = std::get_if<setup::Relax>(&step.what)) return move(relax->move.speed);
  if (const auto* pack = std::get_if<setup::FlowPack>(&step.what)) {
    return static_cast<double>(pack->steps + 1) * plateau(pack->hold) / 3.0;  // of three stages
  }
  if (const auto* cycle = std::get_if<setup::Cycle>(&step.what)) {
    return 0.5 * (plateau(cycle->high_duration) + plateau(cycle->low_duration));
  }
  if (std::holds_alternative<setup::Store>(step.what)) return plateau(std::nullopt);
  return steps_of_a_settling;
}

double steps_of_all(const setup::Case& c, const Steps& steps, double dt) {
  double total = 0.0;
  for (const auto& step : steps) {
    const auto* repeat = std::get_if<setup::Repeat>(&step.what);
    total += repeat == nullptr
                 ? static_cast<double>(count(step)) * steps_of(c, step, dt)
                 : static_cast<double>(repeat->count) * steps_of_all(c, repeat->steps, dt);
  }
  return total;
}

/// Velocity with which stage k begins [m/s].
double flow_before(const setup::Case& c, std::int64_t k) {
  for (--k; k >= 0; --k) {
    const auto [step, n] = part(c, k);
    if (const auto* ramp = std::get_if<setup::FlowRamp>(&step.what)) return ramp->to;
    if (const auto* cycle = std::get_if<setup::Cycle>(&step.what)) {
      return n % 2 == 0 ? cycle->high : cycle->low;
    }
    if (const auto* compress = std::get_if<setup::Compress>(&step.what)) return compress->move.flow;
    if (const auto* relax = std::get_if<setup::Relax>(&step.what)) return relax->move.flow;
    const auto* hold = std::get_if<setup::Hold>(&step.what);
    if (hold != nullptr && hold->flow) return *hold->flow;
    if (hold == nullptr) return 0.0;  // other steps end without a flow
  }
  return 0.0;
}

}  // namespace

std::int64_t stage_count(const setup::Case& c) { return count(c.protocol); }

bool has_flow(const setup::Case& c) { return setup::any_flow(c.protocol, c.liquid.has_value()); }

// A column that stands still after a step with a flow stays wet: its bed comes to rest in the liquid.
bool has_flow(const setup::Case& c, std::int64_t k) {
  const auto& step = part(c, k).step;
  if (setup::makes_flow(step, c.liquid.has_value())) return true;
  return std::holds_alternative<setup::Hold>(step.what) && k > 0 && has_flow(c, k - 1);
}

bool moves_plunger(const setup::Case& c, std::int64_t k) {
  const auto [step, n] = part(c, k);
  return std::holds_alternative<setup::Compress>(step.what) ||
         std::holds_alternative<setup::Relax>(step.what) ||
         (std::holds_alternative<setup::FlowPack>(step.what) && n == 1);
}

bool any_plunger(const setup::Case& c) {
  const auto any = [](const auto& self, const Steps& steps) -> bool {
    return std::ranges::any_of(steps, [&](const setup::ProtocolStep& step) {
      const auto* repeat = std::get_if<setup::Repeat>(&step.what);
      return std::holds_alternative<setup::Compress>(step.what) ||
             std::holds_alternative<setup::Relax>(step.what) ||
             std::holds_alternative<setup::FlowPack>(step.what) ||
             (repeat != nullptr && self(self, repeat->steps));
    });
  };
  return any(any, c.protocol);
}

namespace {

std::unique_ptr<column::Stage> make_pack(const setup::Case& c,
                                         const setup::FlowPack& pack,
                                         std::int64_t n,
                                         const setup::PackedBed& bed,
                                         const dem::StepChoice& step,
                                         column::CoupledBed* liquid) {
  if (n == 0) {
    return std::make_unique<column::FlowStage>(setup::packing_flow(c, pack, bed, step), *liquid);
  }
  if (n == 1) {
    return std::make_unique<column::PlungerStage>(setup::packing_plunger(c, pack, bed, step),
                                                  liquid);
  }
  return std::make_unique<column::FlowStage>(setup::packing_end(c, pack, step), *liquid);
}

}  // namespace

std::unique_ptr<column::Stage> make_stage(const setup::Case& c,
                                          std::int64_t k,
                                          const setup::PackedBed& bed,
                                          const dem::StepChoice& step,
                                          column::CoupledBed* liquid) {
  const auto [protocol_step, n] = part(c, k);
  const auto& what = protocol_step.what;
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
  if (const auto* compress = std::get_if<setup::Compress>(&what)) {
    return std::make_unique<column::PlungerStage>(
        setup::plunger_options(c, compress->move, false, bed, step), liquid);
  }
  if (const auto* relax = std::get_if<setup::Relax>(&what)) {
    auto options = setup::plunger_options(c, relax->move, true, bed, step);
    options.withdraws = relax->withdraw;
    return std::make_unique<column::PlungerStage>(options, liquid);
  }
  if (const auto* pack = std::get_if<setup::FlowPack>(&what)) {
    return make_pack(c, *pack, n, bed, step, liquid);
  }
  if (const auto* cycle = std::get_if<setup::Cycle>(&what)) {
    return std::make_unique<column::FlowStage>(setup::cycle_options(c, *cycle, n % 2 == 0, step),
                                               *liquid);
  }
  if (const auto* store = std::get_if<setup::Store>(&what)) {
    return std::make_unique<column::FlowStage>(setup::store_options(c, *store, step), *liquid);
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
  return steps_of(c, part(c, k).step, step);
}

bool can_simulate(const setup::Case& c) {
  return (c.beads.csv || c.beads.run || setup::makes_beads(c));
}

}  // namespace packbed::app
