// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// A step of the protocol while it is carried out. It is advanced slice by slice, so that a run can
/// write outputs and checkpoints between two slices and go on from there with the same bits.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "column/protocol/plateau.hpp"
#include "dem/dem.hpp"

namespace packbed::column {

/// What a slice ended with.
enum class After {
  goes_on,  ///< nothing to tell
  output,   ///< a row of the outputs is due
  end       ///< the stage is over; a row is due as well
};

class Stage {
 public:
  Stage() = default;
  virtual ~Stage() = default;
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
  Stage(Stage&&) = delete;
  Stage& operator=(Stage&&) = delete;

  [[nodiscard]] virtual std::string_view name() const = 0;
  /// Called once, before the first slice; not when a run is resumed.
  virtual void begin(dem::Dem& dem) = 0;
  /// A slice: a number of time steps that depends on nothing but the state. All ranks call it.
  /// Throws DivergenceError, and ConfigError where the target of a stage cannot be reached.
  virtual After advance(dem::Dem& dem) = 0;
  /// Called once, after the last slice and its outputs: takes back what held for this stage alone.
  virtual void leave(dem::Dem& /*dem*/) const {}
  /// The plateau that ended with the last slice, if one did.
  [[nodiscard]] virtual std::optional<Plateau> finished_plateau() const { return {}; }
  /// Share of the stage that is done, from 0 to 1, as far as it can be told: for progress lines.
  [[nodiscard]] virtual double share_done(const dem::Dem& dem) const = 0;
  /// What it is doing, for progress lines: "falling".
  [[nodiscard]] virtual std::string doing() const { return {}; }
  /// What it came to, in words for the log, once it is over.
  [[nodiscard]] virtual std::string result(const dem::Dem& dem) const = 0;

  /// Everything that advance() depends on besides the beads; numbers come back to the last bit.
  [[nodiscard]] virtual nlohmann::ordered_json save() const = 0;
  virtual void load(const nlohmann::ordered_json& saved) = 0;
};

/// Time steps of a slice: few enough that outputs, checkpoints and stop signals do not wait long,
/// by a count that is the same on any computer.
std::int64_t steps_per_slice(std::int64_t beads);

/// Whether the time of the next output has come; `next` then moves on by whole intervals. All in s.
bool output_is_due(double time, double interval, double& next);

/// Throws DivergenceError if `step` [s] is above the stable one of the present contacts.
void check_stable(const dem::Dem& dem, double step);

}  // namespace packbed::column
