// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/plunger_stage.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "column/plunger.hpp"
#include "column/protocol/bed_look.hpp"
#include "column/protocol/weight.hpp"
#include "core/error.hpp"

namespace packbed::column {
namespace {

constexpr double approach_speed = 0.05;  // through free liquid [m/s]
constexpr double least_strain = 0.01;    // elastic strain from which on a bed counts as static
constexpr double change_of_scale = 1.5;  // before it is worth it
constexpr std::int64_t slices_per_choice = 20;  // of the inertia scale, in a liquid; each without
constexpr double memory_of_stiffness = 0.95;    // from slice to slice
constexpr double least_way = 0.01;            // of a slice that tells a stiffness, over the longest
constexpr double share_of_error = 0.1;        // of the force, that the servo closes per slice
constexpr double force_tolerance = 0.002;     // of the target
constexpr double share_that_is_loose = 0.05;  // of the force that a bed is relieved from
constexpr double share_that_is_free = 0.005;  // of the force that a bed is relieved from
constexpr double least_slice = 1e-6;          // a shorter rest of a phase is none
constexpr double rounding = 1e-9;

/// Names and values of the state, in one place for both directions.
template <class State, class Visit>
void visit(State& s, Visit value) {
  value("phase", s.phase);
  value("phase_start", s.phase_start);
  value("next_output", s.next_output);
  value("goal", s.goal);
  value("flow", s.flow);
  value("start", s.start);
  value("force", s.force);
  value("force_at_start", s.force_at_start);
  value("stiffness", s.stiffness);
  value("work", s.work);
  value("interval", s.interval);
  value("inertia_scale", s.inertia_scale);
  value("slices", s.slices);
}

double position(const dem::Dem& dem) { return *plunger_position(dem.walls()); }

}  // namespace

PlungerStage::PlungerStage(const PlungerOptions& options, CoupledBed* liquid)
    : options_(options), liquid_(liquid) {}

void PlungerStage::begin(dem::Dem& dem) {
  const auto at = plunger_position(dem.walls());
  if (!at) throw ConfigError(fmt::format("step \"{}\": this column has no plunger", options_.name));
  if (options_.friction) dem.set_friction(*options_.friction);
  if (options_.drained) {
    dem.set_weights([&](const auto& bead) { return weight_of(bead, options_.gravity, 0.0); });
  }
  state_.next_output = dem.time() + options_.interval;
  state_.interval = options_.coupling_interval.value_or(longest_interval_of_plunger);
  if (liquid_ != nullptr) {
    state_.flow = options_.flow.value_or(liquid_->flow());
    if (!dem.particles().in_liquid) liquid_->start(dem);
  }
  state_.force = state_.force_at_start = plunger_force(dem);
  choose_inertia(dem);
  const double top = look_at_bed(dem, options_.area).top;
  if (options_.touches_only) options_.value = std::min(top, *at);
  state_.goal = options_.target == PlungerTarget::height ? std::max(top, options_.value) : top;
  const bool is_away = options_.speed > 0.0 && *at > state_.goal;
  if (is_away && liquid_ == nullptr) place_plunger(state_.goal, dem);
  enter(is_away && liquid_ != nullptr ? PlungerPhase::approach : PlungerPhase::move, dem);
}

void PlungerStage::enter(PlungerPhase phase, dem::Dem& dem) {
  state_.phase = static_cast<int>(phase);
  state_.phase_start = dem.time();
  if (phase == PlungerPhase::move) {
    state_.start = position(dem);
    const double way =
        options_.speed > 0.0 ? state_.start - options_.value : options_.value - state_.start;
    if (options_.target == PlungerTarget::height && way < -rounding * options_.value) {
      throw ConfigError(fmt::format(
          "step \"{}\": the plunger is at {:.5g} mm and moves {}, away from its target of {:.5g} "
          "mm{}",
          options_.name, 1e3 * state_.start, options_.speed > 0.0 ? "down" : "up",
          1e3 * options_.value,
          options_.speed > 0.0 ? "; give a lower one, or take \"relax\" to move it up"
                               : "; give a higher one, or take \"compress\" to move it down"));
    }
  }
}

// A dry bed counts as static by its speed and strain; one in a liquid must not swing either.
void PlungerStage::choose_inertia(dem::Dem& dem) {
  double scale = options_.inertia_scale.value_or(1.0);
  const bool is_given =
      options_.inertia_scale && (liquid_ == nullptr || options_.coupling_interval);
  if (!is_given) {
    const auto bed = bed_state(options_, dem);
    if (!bed) {
      scale_inertia(options_, scale, dem);
      return;
    }
    // Where walls carry a part, the bed is strained less than at the plunger.
    const double force = std::min(state_.force, 0.5 * (state_.force + floor_force(dem)));
    const double strain = std::max(least_strain, force / (options_.area * bed->modulus));
    double by_rule = dem::driven_inertia_scale({.speed = std::abs(options_.speed),
                                                .modulus = bed->modulus,
                                                .bulk_density = bed->bulk_density,
                                                .strain = strain})
                         .scale;
    if (liquid_ != nullptr) {
      const bool presses = state_.force > share_that_is_loose * state_.force_at_start ||
                           (options_.speed > 0.0 && phase() != PlungerPhase::withdraw);
      const auto dragged = dragged_bed(*bed, options_.grains, presses, longest_interval_of_plunger);
      by_rule = std::min(by_rule, dem::dragged_inertia_scale(dragged).scale);
      if (!options_.coupling_interval) {
        state_.interval = std::min(longest_interval_of_plunger,
                                   interval_of_consolidation * dem::consolidation_time(dragged));
      }
    }
    if (!options_.inertia_scale) scale = by_rule;
  }
  const double now = dem.options().inertia_scale;
  const bool changes =
      state_.slices == 0 || scale > change_of_scale * now || scale * change_of_scale < now;
  if (changes) scale_inertia(options_, scale, dem);
  state_.inertia_scale = std::max(state_.inertia_scale, dem.options().inertia_scale);
}

double PlungerStage::slice_time(const dem::Dem& dem) const {
  if (liquid_ != nullptr) {
    const bool displaces = phase() == PlungerPhase::move || phase() == PlungerPhase::hold;
    const double coming = std::abs(state_.flow) + (displaces ? std::abs(options_.speed) : 0.0);
    return liquid_->interval_within_limit(state_.interval, coming);
  }
  return static_cast<double>(steps_per_slice(dem.bead_count())) * dem.options().step;
}

// Downwards. The servo closes a share of the error per slice by the stiffness that it saw, so that the force
// comes near its target without passing it.
double PlungerStage::wanted_speed(double time, const dem::Dem& dem) const {
  if (phase() == PlungerPhase::approach) return approach_speed;
  if (phase() == PlungerPhase::withdraw) return -approach_speed;
  if (options_.target == PlungerTarget::height) {
    return phase() == PlungerPhase::move ? options_.speed : 0.0;
  }
  if (options_.value <= 0.0) return phase() == PlungerPhase::move ? options_.speed : 0.0;
  const double error = options_.value - state_.force;
  const double floor = options_.value / (0.5 * position(dem));  // half of the bed for the target
  const double speed = share_of_error * error / (std::max(state_.stiffness, floor) * time);
  const double most = std::abs(options_.speed);
  return std::clamp(speed, -most, most);
}

// Liquid above the bed passes a plunger that goes through it.
void PlungerStage::set_flow(double plunger_speed) {
  if (liquid_ == nullptr) return;
  const bool passes = phase() == PlungerPhase::approach || phase() == PlungerPhase::withdraw;
  liquid_->set_flow(fluid::FlowProgram::steady(state_.flow - (passes ? plunger_speed : 0.0)));
}

void PlungerStage::step(double speed, double time, dem::Dem& dem) {
  const double before = position(dem);
  const double force = state_.force;
  set_plunger_speed(-speed, dem);
  const auto count = cut_into_steps(time, dem);
  if (liquid_ != nullptr) {
    set_flow(speed);
    liquid_->advance(dem, count);
  } else {
    dem.run(count);
  }
  dem.check_overlaps();
  state_.force = plunger_force(dem);
  const double way = before - position(dem);
  state_.work += 0.5 * (force + state_.force) * way;
  // A bed is stiffer at first than once its liquid has left: the stiffest of late counts.
  if (std::abs(way) > least_way * std::abs(options_.speed) * time) {
    state_.stiffness =
        std::max(memory_of_stiffness * state_.stiffness, (state_.force - force) / way);
  }
  ++state_.slices;
}

// Until the phase ends, if that can be told.
std::optional<double> PlungerStage::time_left(double speed, const dem::Dem& dem) const {
  const double z = position(dem);
  switch (phase()) {
    case PlungerPhase::approach:
      return (z - state_.goal) / speed;
    case PlungerPhase::withdraw:
      return (options_.column_height - z) / -speed;
    case PlungerPhase::hold:
      return state_.phase_start + options_.hold - dem.time();
    default:
      if (options_.target == PlungerTarget::height) return (z - options_.value) / speed;
      if (speed < 0.0) return (options_.column_height - z) / -speed;
      return std::nullopt;
  }
}

After PlungerStage::advance(dem::Dem& dem) {
  if (liquid_ == nullptr || state_.slices % slices_per_choice == 0) choose_inertia(dem);
  choose_step(options_, dem);
  const double slice = slice_time(dem);
  double time = slice;
  const double speed = wanted_speed(time, dem);
  const auto left = time_left(speed, dem);
  if (left) time = *left / std::max(1.0, std::ceil(*left / time - rounding));  // none is very short
  const bool is_there = left && *left <= least_slice * slice;
  if (!is_there) step(speed, time, dem);
  end_phase_if_due(is_there, dem);
  if (phase() == PlungerPhase::done) {
    end(dem);
    return After::end;
  }
  return output_is_due(dem.time(), options_.interval, state_.next_output) ? After::output
                                                                          : After::goes_on;
}

// `is_there`: nothing is left of the present phase.
void PlungerStage::end_phase_if_due(bool is_there, dem::Dem& dem) {
  const double z = position(dem);
  const bool at_upper_end = z >= options_.column_height * (1.0 - rounding);
  const auto reached = [&](double aim) { return is_there || std::abs(z - aim) <= rounding * aim; };
  switch (phase()) {
    case PlungerPhase::approach:
      if (reached(state_.goal)) enter(PlungerPhase::move, dem);
      return;
    case PlungerPhase::move:
      if (!has_reached_target(reached(options_.value), at_upper_end)) return;
      enter(PlungerPhase::hold, dem);
      if (options_.hold <= 0.0) leave_hold(dem);
      return;
    case PlungerPhase::hold:
      if (is_there || dem.time() >= state_.phase_start + options_.hold - rounding * dem.time()) {
        leave_hold(dem);
      }
      return;
    case PlungerPhase::withdraw:
      if (is_there || at_upper_end) enter(PlungerPhase::done, dem);
      return;
    case PlungerPhase::done:
      return;
  }
}

bool PlungerStage::has_reached_target(bool is_at_height, bool at_upper_end) const {
  if (options_.target == PlungerTarget::height) return is_at_height;
  if (options_.speed > 0.0) return state_.force >= options_.value * (1.0 - force_tolerance);
  const double free = share_that_is_free * state_.force_at_start;
  return at_upper_end || state_.force <= std::max(options_.value * (1.0 + force_tolerance), free);
}

void PlungerStage::leave_hold(dem::Dem& dem) {
  enter(options_.withdraws ? PlungerPhase::withdraw : PlungerPhase::done, dem);
  if (!options_.withdraws || liquid_ != nullptr) return;
  place_plunger(options_.column_height, dem);
  enter(PlungerPhase::done, dem);
}

void PlungerStage::end(dem::Dem& dem) {
  set_plunger_speed(0.0, dem);
  set_flow(0.0);
}

// After the outputs of the end, which show the bed as it was pressed.
void PlungerStage::leave(dem::Dem& dem) const {
  if (options_.friction) dem.set_friction(options_.resin_friction);
  if (!options_.drained) return;
  dem.set_weights(
      [&](const auto& bead) { return weight_of(bead, options_.gravity, options_.liquid_density); });
}

double PlungerStage::share_done(const dem::Dem& dem) const {
  if (phase() == PlungerPhase::approach) return 0.0;
  if (phase() != PlungerPhase::move) return 0.95;
  const bool by_height = options_.target == PlungerTarget::height;
  const double now = by_height ? position(dem) - state_.start : state_.force;
  const double all = by_height ? options_.value - state_.start : options_.value;
  return all != 0.0 ? std::clamp(now / all, 0.0, 0.95) : 0.5;
}

std::string PlungerStage::doing() const {
  constexpr std::array words = {"approaching", "moving", "holding", "withdrawing", "done"};
  const auto* word = words.at(static_cast<std::size_t>(state_.phase));
  return fmt::format("{}, {:.3g} bar", word, 1e-5 * state_.force / options_.area);
}

std::string PlungerStage::result(const dem::Dem& dem) const {
  const double z = position(dem);
  auto text = fmt::format("plunger at {:.4f} mm", 1e3 * z);
  if (options_.settled_height > 0.0) {
    text += fmt::format(" (compression {:.4f})", 1.0 - z / options_.settled_height);
  }
  text += fmt::format(", {:.5g} N = {:.4g} bar on it, work {:.4g} mJ, inertia scale up to {:.3g}",
                      state_.force, 1e-5 * state_.force / options_.area, 1e3 * state_.work,
                      state_.inertia_scale);
  if (liquid_ != nullptr) text += fmt::format(", exchanges every {:.3g} ms", 1e3 * state_.interval);
  return text;
}

nlohmann::ordered_json PlungerStage::save() const {
  nlohmann::ordered_json saved;
  visit(state_, [&](const char* key, const auto& value) { saved[key] = value; });
  return saved;
}

void PlungerStage::load(const nlohmann::ordered_json& saved) {
  visit(state_, [&](const char* key, auto& value) { saved.at(key).get_to(value); });
  set_flow(0.0);
}

}  // namespace packbed::column
