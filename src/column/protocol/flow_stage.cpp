// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/flow_stage.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "column/protocol/bed_look.hpp"
#include "fluid/figures.hpp"

namespace packbed::column {
namespace {

constexpr double look_every = 0.1;         // between looks at how steady a plateau is [s]
constexpr double looks_per_plateau = 0.2;  // or this share of a short plateau
constexpr double usual_ramp = 0.1;         // to a plateau that is held until steady [s]
constexpr double ramp_share = 0.25;        // of a plateau that is held for a time
constexpr double least_drop = 1.0;         // a smaller one is none [Pa]
constexpr double cm_h = 0.01 / 3600.0;
constexpr double rounding = 1e-9;

double middle(double a, double b) { return 0.5 * (a + b); }

/// Names and values of the state, in one place for both directions.
template <class State, class Visit>
void visit(State& s, Visit value) {
  value("from", s.from);
  value("plateau", s.plateau);
  value("started", s.started);
  value("started_of_run", s.started_of_run);
  value("window_started", s.window_started);
  value("height", s.height);
  value("pressure_drop", s.pressure_drop);
  value("next_output", s.next_output);
  value("unsteady", s.unsteady);
  value("inertia_scale", s.inertia_scale);
  value("interval", s.interval);
  value("drop_times", s.drops.time);
  value("drops", s.drops.value);
}

}  // namespace

FlowStage::FlowStage(const FlowOptions& options, CoupledBed& liquid)
    : options_(options), liquid_(liquid) {}

// Plateau -1 is what the stage comes from.
double FlowStage::velocity(std::int64_t plateau) const {
  const double share = static_cast<double>(plateau + 1) / static_cast<double>(options_.steps);
  return state_.from + share * (options_.to - state_.from);
}

double FlowStage::ramp_time() const {
  if (!options_.ramps) return 0.0;
  return options_.hold ? ramp_share * *options_.hold : std::min(usual_ramp, options_.hold_limit);
}

void FlowStage::begin(dem::Dem& dem) {
  state_.from = options_.from.value_or(liquid_.flow());
  follow_rules(dem);
  if (!dem.particles().in_liquid) liquid_.start(dem);
  state_.next_output = dem.time() + options_.interval;
  start_plateau(dem);
}

// A bed that is pressed together drags more and may be scaled further; one that is let go, less.
void FlowStage::follow_rules(dem::Dem& dem) {
  const bool is_given = options_.inertia_scale && options_.coupling_interval;
  const auto bed = is_given ? std::nullopt : bed_state(options_, dem);
  double interval = std::min(longest_interval, interval_of_plateau * options_.hold.value_or(1.0));
  double scale = 1.0;
  if (bed) {
    const bool presses = state_.from >= 0.0 && options_.to >= 0.0;
    const auto dragged =
        dragged_bed(*bed, options_.grains, presses, options_.hold.value_or(look_every));
    scale = dem::dragged_inertia_scale(dragged).scale;
    interval = std::min(interval, interval_of_consolidation * dem::consolidation_time(dragged));
  }
  scale_inertia(options_, options_.inertia_scale.value_or(scale), dem);
  state_.inertia_scale = std::max(state_.inertia_scale, dem.options().inertia_scale);
  state_.interval = options_.coupling_interval.value_or(interval);
}

void FlowStage::start_plateau(const dem::Dem& dem) {
  state_.started = liquid_.time();
  state_.started_of_run = dem.time();
  state_.drops = {};
  state_.window_started = state_.started;
  state_.height = 0.0;
  set_flow();
}

void FlowStage::set_flow() {
  const double before = velocity(state_.plateau - 1);
  const double after = velocity(state_.plateau);
  const double time = ramp_time();
  if (time > 0.0) {
    liquid_.set_flow(
        fluid::FlowProgram::through({{state_.started, before}, {state_.started + time, after}}));
  } else {
    liquid_.set_flow(fluid::FlowProgram::steady(after));
  }
}

// An interval holds a whole number of steps of the beads, and ends where a plateau ends.
After FlowStage::advance(dem::Dem& dem) {
  finished_.reset();
  if (options_.hold && *options_.hold <= 0.0) return After::end;
  choose_step(options_, dem);
  double interval = liquid_.interval_within_limit(state_.interval, velocity(state_.plateau));
  if (options_.hold) {
    const double left = state_.started + *options_.hold - liquid_.time();
    interval = left / std::max(1.0, std::ceil(left / interval - 1e-9));
  }
  liquid_.advance(dem, cut_into_steps(interval, dem));
  dem.check_overlaps();
  watch_drop();
  const bool is_reached = is_low_enough(dem);
  const auto look = look_at_plateau(dem);
  if (!look.is_over && !is_reached) {
    return output_is_due(dem.time(), options_.interval, state_.next_output) ? After::output
                                                                            : After::goes_on;
  }
  end_plateau(dem, look.is_steady);
  if (state_.plateau >= options_.steps || is_reached) return After::end;
  follow_rules(dem);
  start_plateau(dem);
  return After::output;
}

// Of a plateau whose end is known the second half of its constant part counts; else its end may come at once.
void FlowStage::watch_drop() {
  const double past = liquid_.time() - state_.started;
  const double constant = ramp_time();
  const double from = options_.hold ? middle(constant, *options_.hold) : constant;
  if (past >= from * (1.0 - rounding))
    state_.drops.add(past, fluid::pressure_drop(liquid_.fluid()));
}

void FlowStage::end_plateau(const dem::Dem& dem, bool is_steady) {
  const double past = liquid_.time() - state_.started;
  const double from = middle(ramp_time(), past) * (1.0 - rounding);
  const bool flows = velocity(state_.plateau) != 0.0;
  finished_ = {.start = state_.started_of_run,
               .end = dem.time(),
               .noise = flows ? pressure_noise(state_.drops, from) : std::nullopt,
               .is_steady = is_steady};
  if (!is_steady) ++state_.unsteady;
  ++state_.plateau;
}

bool FlowStage::is_low_enough(const dem::Dem& dem) const {
  return options_.until_height && look_at_bed(dem, options_.area).height <= *options_.until_height;
}

FlowStage::Look FlowStage::look_at_plateau(const dem::Dem& dem) {
  const double past = liquid_.time() - state_.started;
  const double limit = options_.hold.value_or(options_.hold_limit);
  const bool is_late = past >= limit * (1.0 - rounding);
  const double look = std::min(look_every, looks_per_plateau * limit);
  const bool may_look =
      liquid_.time() - state_.window_started >= look * (1.0 - rounding) || is_late;
  const bool is_steady = may_look && past > ramp_time() && looks_steady(dem);
  return {.is_over = is_late || (is_steady && !options_.hold), .is_steady = is_steady};
}

// Compares with the last look.
bool FlowStage::looks_steady(const dem::Dem& dem) {
  const double time = liquid_.time() - state_.window_started;
  const double height = look_at_bed(dem, options_.area).height;
  const double drop = liquid_.figures().pressure_drop;
  const bool had_look = state_.height > 0.0;
  const bool is_steady = had_look &&
                         std::abs(height - state_.height) < steady_height_rate * time * height &&
                         std::abs(drop - state_.pressure_drop) <=
                             steady_rate * time * std::max(std::abs(drop), least_drop);
  state_.height = height;
  state_.pressure_drop = drop;
  state_.window_started = liquid_.time();
  return is_steady;
}

double FlowStage::share_done(const dem::Dem& /*dem*/) const {
  const double limit = options_.hold.value_or(options_.hold_limit);
  const double here = std::clamp((liquid_.time() - state_.started) / limit, 0.0, 1.0);
  return std::min(
      1.0, (static_cast<double>(state_.plateau) + here) / static_cast<double>(options_.steps));
}

std::string FlowStage::doing() const {
  const auto plateau = std::min(state_.plateau, options_.steps - 1);
  return fmt::format("{:.4g} cm/h, {} of {}", velocity(plateau) / cm_h, plateau + 1,
                     options_.steps);
}

std::string FlowStage::result(const dem::Dem& dem) const {
  const auto f = liquid_.figures();
  const double height = look_at_bed(dem, options_.area).height;
  auto text = fmt::format(
      "{:.4g} cm/h, pressure drop {:.5g} bar ({:.4g} bar/m), bed height {:.4f} mm, inertia scale "
      "up to {:.4g}, exchanges every {:.3g} ms",
      f.superficial_velocity / cm_h, 1e-5 * f.pressure_drop,
      height > 0.0 ? 1e-5 * f.pressure_drop / height : 0.0, 1e3 * height, state_.inertia_scale,
      1e3 * state_.interval);
  if (liquid_.options().coupling.overlap == coupling::OverlapRule::merged) {
    text += fmt::format("; {} pairs of contacts of a bead take the same part of it",
                        dem.meeting_lenses());
  }
  if (state_.unsteady > 0) {
    text += fmt::format("; {} of {} plateaus were not steady at their end", state_.unsteady,
                        options_.steps);
  }
  return text;
}

nlohmann::ordered_json FlowStage::save() const {
  nlohmann::ordered_json saved;
  visit(state_, [&](const char* key, const auto& value) { saved[key] = value; });
  return saved;
}

void FlowStage::load(const nlohmann::ordered_json& saved) {
  visit(state_, [&](const char* key, auto& value) { saved.at(key).get_to(value); });
  set_flow();
}

}  // namespace packbed::column
