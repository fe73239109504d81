// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/settle.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "column/protocol/settle_beads.hpp"
#include "column/protocol/settled_porosity.hpp"
#include "column/protocol/tipping.hpp"
#include "column/protocol/weight.hpp"
#include "core/error.hpp"
#include "dem/step_choice.hpp"

namespace packbed::column {
namespace {

// By which a bed is settled looser than it should be: the first time, and the second.
constexpr double loose_margin = 0.004;
constexpr double looser_margin = 0.010;
constexpr double landed_speed = 0.3;  // of a bead that falls no more / sqrt(g d / inertia scale)
constexpr std::int32_t most_falls = 2;
constexpr std::int32_t most_count_changes = 6;
constexpr std::int32_t most_corrections = 3;
constexpr std::int64_t most_pushes = 100;
constexpr double fall_time = 8.0;       // damping time of the fall / falling time: decision 10
constexpr double near_height = 0.5;     // distance from the height asked for / mean diameter
constexpr double height_limit = 1e-2;   // unbalanced / contact force from which on a height counts
constexpr double tipping_speed = 0.1;   // of a bead that tips over / sqrt(g d / inertia scale)
constexpr double wetting_swings = 2.0;  // of the bed, in which the liquid comes to bear its share
// Densification. Friction fades slowly, and waits where the bed gives way, so that the bed follows
// from balance to balance and stands as soon as friction comes back. Times are falling times.
constexpr std::int64_t look_every = 100;  // steps between looks at the porosity
constexpr double creep_damping = 0.1;     // time in which beads slow down
constexpr double fading_time = 4.0;       // in which friction falls by a factor e
constexpr double gives_way = 5e-4;        // loss of porosity in a time
constexpr double near_aim = 4e-3;         // porosity above the aim from where all goes slower,
constexpr double slower = 4.0;            // by this factor
constexpr double least_sag = 3e-4;
constexpr double stands = 1e-5;           // likewise, of a bed that gives way no more
constexpr double least_looseness = 0.01;  // below it there is no friction
constexpr double aim_below = 0.25;        // of the tolerance, under the target

}  // namespace

const char* name(SettlePhase phase) {
  constexpr const char* names[] = {"start", "fall", "rest", "densify", "submerge", "done"};
  return names[static_cast<std::size_t>(phase)];
}

bool Settle::advance(dem::Dem& dem) {
  if (state_.phase == SettlePhase::done) return false;
  if (state_.phase == SettlePhase::start) begin(dem);
  choose_step(options_.stepping, dem);
  if (state_.phase == SettlePhase::submerge) wet(dem);
  run_slice(dem);
  look(dem);
  switch (state_.phase) {
    case SettlePhase::fall:
      if (has_landed(dem)) enter_rest(SettlePhase::rest, dem);
      break;
    case SettlePhase::rest:
      if (is_at_rest(options_.rest_limit)) {
        after_rest(dem);
      } else if (options_.bed_height && !options_.porosity && is_at_rest(height_limit)) {
        has_height(near_height, dem);
      }
      break;
    case SettlePhase::densify:
      after_densify(dem);
      break;
    case SettlePhase::submerge:
      if (is_wet(dem) && rests_for_good(dem)) after_submerge(dem);
      break;
    default:
      break;
  }
  return state_.phase != SettlePhase::done;
}

void Settle::begin(dem::Dem& dem) {
  if (dem.bead_count() == 0) throw ConfigError("step \"settle\": there are no beads to settle");
  if (options_.lid) place_plunger(lid_away, dem);
  bed_ = look_at_bed(dem, area());
  state_.friction = options_.friction.value_or(options_.resin_friction);
  if (options_.porosity) {
    state_.aim = *options_.porosity - aim_below * options_.porosity_tolerance;
    state_.friction =
        settling_friction(*options_.porosity + loose_margin, options_.resin_rolling_friction);
  }
  fall(dem);
  ++state_.falls;
}

void Settle::weigh(double liquid_density, dem::Dem& dem) const {
  dem.set_weights(
      [&](const auto& bead) { return weight_of(bead, options_.gravity, liquid_density); });
}

void Settle::fall(dem::Dem& dem) {
  weigh(0.0, dem);
  dem.set_friction(state_.friction);
  dem.set_rolling_friction(options_.resin_rolling_friction);
  enter_fall(dem);
}

void Settle::enter_fall(dem::Dem& dem) {
  const double time = options_.fall_damping.value_or(
      fall_time * falling_time(bed_.mean_diameter, options_.gravity, dem));
  dem.set_background_damping(1.0 / time);
  enter(SettlePhase::fall, dem);
}

void Settle::run_slice(dem::Dem& dem) {
  if (state_.phase_slices >= options_.most_slices) {
    throw DivergenceError(fmt::format(
        "step {}, time {:.6g} s: the bed does not come to rest: after {} time steps of the phase "
        "\"{}\" the unbalanced force is {:.3g} of the contact force; give a smaller numerics.step "
        "or a shorter numerics.background_damping",
        dem.steps(), dem.time(), state_.phase_slices * options_.slice, name(state_.phase),
        state_.unbalanced));
  }
  if (state_.phase == SettlePhase::densify) {
    run_densifying(dem);
  } else {
    const auto tail = std::min(look_every, options_.slice);
    dem.run(options_.slice - tail);
    if (may_tip()) before_ = dem.snapshot();
    dem.run(tail);
  }
  dem.check_overlaps();
  ++state_.slices;
  ++state_.phase_slices;
}

// Stops at the porosity, whenever it comes; early enough for the bed to sink on to it.
void Settle::run_densifying(dem::Dem& dem) {
  for (std::int64_t done = 0; done < options_.slice; done += look_every) {
    dem.run(std::min(look_every, options_.slice - done));
    if (middle_porosity(dem, area()) <= state_.aim + state_.sag) return;
  }
}

// In a bed that rests but for single beads. Sooner, pushes would keep it moving.
bool Settle::may_tip() const { return state_.resting_since >= 0.0 && state_.pushes < most_pushes; }

void Settle::look(dem::Dem& dem) {
  bed_ = look_at_bed(dem, area());
  rest_ = rest_of(dem);
  push_tipping(dem);
  state_.height_before = state_.bed_height;
  state_.porosity_before = state_.porosity;
  state_.bed_height = bed_.height;
  state_.porosity = bed_.porosity;
  state_.unbalanced = rest_.unbalanced;
  state_.coordination = rest_.coordination;
  state_.max_overlap = rest_.max_overlap;
  state_.speed = rest_.speed;
}

void Settle::push_tipping(dem::Dem& dem) {
  if (!before_) return;
  const double fall = bed_.mean_diameter / falling_time(bed_.mean_diameter, options_.gravity, dem);
  const auto pushed =
      push_tipping_beads(*before_, dem.snapshot(),
                         {.slowest = options_.speed_limit, .speed = tipping_speed * fall}, dem);
  before_.reset();
  state_.pushes += pushed;
  if (pushed > 0) state_.resting_since = dem.time();
}

void Settle::enter(SettlePhase phase, const dem::Dem& dem) {
  state_.phase = phase;
  state_.phase_slices = 0;
  state_.phase_start = dem.time();
  state_.resting_since = -1.0;
}

void Settle::enter_rest(SettlePhase phase, dem::Dem& dem) {
  const double time = falling_time(bed_.mean_diameter, options_.gravity, dem);
  dem.set_background_damping(1.0 / time);
  enter(phase, dem);
}

// Where a bead would be fast if it still fell, none is.
bool Settle::has_landed(const dem::Dem& dem) const {
  const double time = falling_time(bed_.mean_diameter, options_.gravity, dem);
  const double speed = bed_.mean_diameter / time;
  return dem.time() - state_.phase_start > time && rest_.fastest < landed_speed * speed;
}

// A bead on two others may roll through its saddle for ever, ever slower; it bears nothing.
bool Settle::rests_for_good(const dem::Dem& dem) {
  if (!is_at_rest(options_.unbalanced_limit)) {
    state_.resting_since = -1.0;
    return false;
  }
  if (rest_.speed < options_.speed_limit) return true;
  if (state_.resting_since < 0.0) state_.resting_since = dem.time();
  return dem.time() - state_.resting_since >
         options_.patience * falling_time(bed_.mean_diameter, options_.gravity, dem);
}

bool Settle::is_at_rest(double unbalanced) const {
  return rest_.unbalanced < unbalanced &&
         is_steady(state_.bed_height, state_.height_before, bed_.mean_diameter);
}

double Settle::working_friction() const {
  return std::min(state_.friction, options_.resin_friction);
}

void Settle::after_rest(dem::Dem& dem) {
  if (options_.porosity && !has_porosity(dem)) return;
  if (options_.bed_height && !has_height(near_height, dem)) return;
  dem.set_friction(options_.resin_friction);
  dem.set_rolling_friction(options_.resin_rolling_friction);
  enter_rest(SettlePhase::submerge, dem);
  state_.wetting_time = wetting_time();
}

// Little by little: a bed that loses most of its weight at once throws up its grains. It swings once in about
// 7 H/d contact times.
double Settle::wetting_time() const {
  const double contact_time = options_.stepping.longest_step * dem::fewest_steps_per_contact;
  return wetting_swings * 7.0 * bed_.height / bed_.mean_diameter * contact_time;
}

void Settle::wet(dem::Dem& dem) const {
  const double t = std::min((dem.time() - state_.phase_start) / state_.wetting_time, 1.0);
  weigh(t * t * (3.0 - 2.0 * t) * options_.liquid_density, dem);
}

bool Settle::is_wet(const dem::Dem& dem) const {
  const double slice = static_cast<double>(options_.slice) * dem.options().step;
  // The last slice bore the final weight.
  return dem.time() - state_.phase_start > state_.wetting_time + slice;
}

// Whether the bed has the porosity asked for; if not, what brings it there is begun.
bool Settle::has_porosity(dem::Dem& dem) {
  // What settled at more friction than the resin has must stand with the resin's.
  if (dem.options().model.friction > working_friction()) {
    dem.set_friction(working_friction());
    enter(SettlePhase::rest, dem);
    return false;
  }
  // How much it still sank when friction came back tells where to stop next time.
  if (state_.stopped_at > 0.0)
    state_.sag = std::max(least_sag, state_.stopped_at - state_.porosity);
  state_.stopped_at = 0.0;
  const double excess = state_.porosity - state_.aim - aim_below * options_.porosity_tolerance;
  if (excess > 0.5 * options_.porosity_tolerance) {
    loosen(dem);
    return false;
  }
  if (excess >= -options_.porosity_tolerance) return true;
  fall_again(dem);
  return false;
}

void Settle::loosen(dem::Dem& dem) {
  set_looseness(state_.looseness, dem);
  dem.set_background_damping(
      1.0 / (creep_damping * falling_time(bed_.mean_diameter, options_.gravity, dem)));
  enter(SettlePhase::densify, dem);
}

void Settle::set_looseness(double looseness, dem::Dem& dem) {
  dem.set_friction(looseness * working_friction());
  dem.set_rolling_friction(looseness * options_.resin_rolling_friction);
}

void Settle::after_densify(dem::Dem& dem) {
  if (state_.porosity <= state_.aim + state_.sag) {
    state_.stopped_at = state_.porosity;
    set_looseness(1.0, dem);
    enter_rest(SettlePhase::rest, dem);
    return;
  }
  const double times = static_cast<double>(options_.slice) * dem.options().step /
                       falling_time(bed_.mean_diameter, options_.gravity, dem);
  const double loss = (state_.porosity_before - state_.porosity) / times;
  if (state_.looseness == 0.0 && loss < stands && state_.phase_slices > 1) {
    refuse_porosity("is too dense: without any friction between beads this one packs to");
  }
  const bool is_near = state_.porosity < state_.aim + state_.sag + near_aim;
  const double pace = is_near ? 1.0 / slower : 1.0;
  if (loss > pace * gives_way) return;
  state_.looseness *= std::exp(-pace * times / fading_time);
  if (state_.looseness < least_looseness) state_.looseness = 0.0;
  set_looseness(state_.looseness, dem);
}

void Settle::fall_again(dem::Dem& dem) {
  const double expected = settled_porosity(state_.friction, options_.resin_rolling_friction);
  const double deviation = state_.porosity - expected;
  const double friction = settling_friction(*options_.porosity + looser_margin - deviation,
                                            options_.resin_rolling_friction);
  if (state_.falls >= most_falls || friction <= state_.friction) {
    refuse_porosity("is too loose: with all the friction that helps this one settles to");
  }
  state_.friction = friction;
  state_.looseness = 1.0;
  make_new_cloud(options_, static_cast<std::uint64_t>(state_.falls), dem);
  fall(dem);
  ++state_.falls;
}

void Settle::refuse_porosity(std::string_view why) const {
  throw ConfigError(
      fmt::format("step \"settle\": a bed of porosity {:.4g} {} {:.4g}; ask for a porosity on the "
                  "other side of that, or change resin.friction or resin.rolling_friction",
                  *options_.porosity, why, state_.porosity));
}

// Whether the bed is within `near` mean diameters of its height; if not, beads are added or removed.
bool Settle::has_height(double near, dem::Dem& dem) {
  const double excess = state_.bed_height - *options_.bed_height;
  if (std::abs(excess) <= near * bed_.mean_diameter) return true;
  if (state_.count_changes == most_count_changes) {
    if (std::abs(excess) <= bed_.mean_diameter) return true;
    throw DivergenceError(fmt::format(
        "step \"settle\": the bed is {:.4g} mm high after {} changes of the number of beads, not "
        "{:.4g} mm; give [beads] count instead of bed_height",
        1e3 * state_.bed_height, most_count_changes, 1e3 * *options_.bed_height));
  }
  ++state_.count_changes;
  const double volume = std::abs(excess) * area() * (1.0 - state_.porosity);
  if (excess > 0.0) {
    remove_highest(volume, dem);
    enter_rest(SettlePhase::rest, dem);
  } else {
    state_.next_id = add_beads(options_, bed_.top, volume, state_.next_id, dem);
    enter_fall(dem);
  }
  return false;
}

// In the liquid the bed has risen a little; where that takes it out of its limits it is dried again.
void Settle::after_submerge(dem::Dem& dem) {
  const double excess = options_.porosity ? state_.porosity - *options_.porosity : 0.0;
  const bool dense_enough = std::abs(excess) <= options_.porosity_tolerance;
  const bool high_enough = !options_.bed_height ||
                           std::abs(state_.bed_height - *options_.bed_height) <= bed_.mean_diameter;
  if (dense_enough && high_enough) return finish(dem);
  if (!dense_enough && ++state_.corrections > most_corrections) {
    refuse_porosity("cannot be met within its tolerance by this bed, which has");
  }
  state_.aim -= excess;
  weigh(0.0, dem);
  dem.set_friction(std::min(dem.options().model.friction, working_friction()));
  enter_rest(SettlePhase::rest, dem);
}

void Settle::finish(dem::Dem& dem) {
  if (options_.lid) {
    if (bed_.top > *options_.lid) {
      throw ConfigError(
          fmt::format("step \"settle\": the settled bed reaches up to {:.4g} mm, above the lid of "
                      "the column at "
                      "{:.4g} mm; make the column higher, or take fewer beads",
                      1e3 * bed_.top, 1e3 * *options_.lid));
    }
    place_plunger(*options_.lid, dem);
  }
  dem.set_background_damping(options_.damping_after);
  enter(SettlePhase::done, dem);
}

}  // namespace packbed::column
