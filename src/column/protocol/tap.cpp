// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/tap.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "column/protocol/weight.hpp"
#include "core/error.hpp"

namespace packbed::column {
namespace {

constexpr std::int64_t pieces_per_tap = 40;  // in each of which the weight is constant
constexpr double rounding = 1e-9;            // a piece of 100 steps is not one of 101

}  // namespace

double tap_strength(const TapOptions& options) {
  const double omega = 2.0 * std::numbers::pi * options.frequency;
  return options.amplitude * omega * omega / options.gravity;
}

bool Tap::advance(dem::Dem& dem) {
  if (state_.done != 0) return false;
  choose_step(options_.stepping, dem);
  if (state_.resting != 0) {
    rest(dem);
  } else {
    shake(dem);
  }
  return state_.done == 0;
}

// A whole number of equal steps for each piece, none longer than the one chosen.
void Tap::shake(dem::Dem& dem) {
  const double piece = 1.0 / (options_.frequency * static_cast<double>(pieces_per_tap));
  const double longest = dem.options().step;
  const double steps = std::max(1.0, std::ceil(piece / longest - rounding));
  const double phase =
      (static_cast<double>(state_.pieces) + 0.5) / static_cast<double>(pieces_per_tap);
  weigh(1.0 + tap_strength(options_) * std::sin(2.0 * std::numbers::pi * phase), dem);
  dem.set_step(piece / steps);
  dem.run(static_cast<std::int64_t>(steps));
  dem.check_overlaps();
  if (++state_.pieces < pieces_per_tap) return;
  weigh(1.0, dem);
  state_.pieces = 0;
  state_.rest_slices = 0;
  state_.resting = 1;
}

void Tap::rest(dem::Dem& dem) {
  if (state_.rest_slices == options_.most_slices) {
    throw DivergenceError(
        fmt::format("step {}, time {:.6g} s: the bed does not come to rest after tap {}: the "
                    "unbalanced force is "
                    "{:.3g} of the contact force; give a smaller numerics.step",
                    dem.steps(), dem.time(), state_.taps, state_.unbalanced));
  }
  if (state_.mean_diameter == 0.0) {
    state_.mean_diameter = look_at_bed(dem, options_.area).mean_diameter;
  }
  dem.set_background_damping(1.0 / falling_time(state_.mean_diameter, options_.gravity, dem));
  dem.run(options_.slice);
  dem.check_overlaps();
  ++state_.rest_slices;
  const auto bed = look_at_bed(dem, options_.area);
  const auto rest = rest_of(dem);
  state_.height_before = state_.bed_height;
  state_.bed_height = bed.height;
  state_.porosity = bed.porosity;
  state_.unbalanced = rest.unbalanced;
  state_.coordination = rest.coordination;
  const bool last = state_.taps == options_.count;
  const double limit = last ? options_.unbalanced_limit : options_.rest_limit;
  if (!is_steady(state_.bed_height, state_.height_before, bed.mean_diameter) ||
      rest.unbalanced >= limit || (last && rest.speed >= options_.speed_limit)) {
    return;
  }
  dem.set_background_damping(options_.damping_after);
  if (last) {
    state_.done = 1;
  } else {
    ++state_.taps;
    state_.resting = 0;
  }
}

void Tap::weigh(double factor, dem::Dem& dem) const {
  dem.set_weights([&](const auto& bead) {
    return factor * weight_of(bead, options_.gravity, options_.liquid_density);
  });
}

}  // namespace packbed::column
