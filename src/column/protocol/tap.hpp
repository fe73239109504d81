// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The protocol step "tap": the column is shaken up and down, one period of a sine of acceleration per
/// tap, and the bed comes to rest after each. Seen from the column, the weights change with time: walls
/// stay where they are. docs/theory/settling.md, section 6.

#include <cstdint>

#include "column/protocol/bed_look.hpp"
#include "column/protocol/stepping.hpp"
#include "dem/dem.hpp"

namespace packbed::column {

struct TapOptions {
  double amplitude = 0.0;       ///< A of the acceleration A (2 pi f)^2 sin(2 pi f t) [m]
  double frequency = 0.0;       ///< f [1/s]
  std::int64_t count = 1;       ///< taps
  double area = 0.0;            ///< cross-section of the column [m2]
  double gravity = 9.81;        ///< [m/s2]
  double liquid_density = 0.0;  ///< 0: dry [kg/m3]

  SteppingOptions stepping;
  double damping_after = 0.0;  ///< background damping while shaking and in the end; 0: none [1/s]
  double rest_limit = 1e-5;    ///< unbalanced / contact force at which the next tap comes
  double unbalanced_limit = 1e-6;    ///< the same after the last
  double speed_limit = 1e-6;         ///< of the fastest bead after the last, rattlers too [m/s]
  std::int64_t slice = 500;          ///< time steps, at rest
  std::int64_t most_slices = 20000;  ///< of a rest, before it is given up
};

/// Largest acceleration / gravity: above 1 beads lose their weight for a moment.
double tap_strength(const TapOptions& options);

/// Everything that the next slices depend on, beside the beads; a plain record for checkpoints.
struct TapState {
  std::int64_t taps = 0;         ///< begun
  std::int64_t pieces = 0;       ///< of the tap under way, done
  std::int64_t rest_slices = 0;  ///< done after the last tap
  std::int32_t resting = 1;      ///< whether the bed comes to rest
  std::int32_t done = 0;
  double mean_diameter = 0.0;  ///< [m]; 0 before the first slice
  // Figures of the last slice.
  double bed_height = 0.0;  ///< [m]
  double height_before = 0.0;
  double porosity = 1.0;  ///< of the middle half
  double unbalanced = 1.0;
  double coordination = 0.0;
};

class Tap {
 public:
  explicit Tap(const TapOptions& options, const TapState& state = {})
      : options_(options), state_(state) {}

  /// A part of a tap, or a slice of rest. Returns whether there is more to do. All ranks call it.
  /// Throws DivergenceError where the bed does not come to rest.
  bool advance(dem::Dem& dem);

  [[nodiscard]] const TapState& state() const { return state_; }

 private:
  void shake(dem::Dem& dem);
  void rest(dem::Dem& dem);
  void weigh(double factor, dem::Dem& dem) const;

  TapOptions options_;
  TapState state_;
};

}  // namespace packbed::column
