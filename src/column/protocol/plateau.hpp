// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// What a step with a flow tells of a plateau, and how restless the pressure drop was on it.

#include <optional>
#include <vector>

namespace packbed::column {

/// A velocity that was held, with the way to it.
struct Plateau {
  double start = 0.0;           ///< simulated time, of the beads [s]
  double end = 0.0;             ///< [s]
  std::optional<double> noise;  ///< pressure_noise() of the pressure drop
  bool is_steady = false;       ///< bed height and pressure drop change slowly at its end
};

/// A figure at instants, in the order of time.
struct Samples {
  std::vector<double> time{};  ///< [s]
  std::vector<double> value{};
  void add(double t, double v) {
    time.push_back(t);
    value.push_back(v);
  }
};

inline constexpr std::size_t fewest_noise_samples = 5;

/// Standard deviation over mean of the samples from `from` on [s], a parabola taken out (three degrees of
/// freedom less): what a bed that still consolidates does slowly is no noise. Nothing
/// for fewer than `fewest_noise_samples`, or a mean of zero.
std::optional<double> pressure_noise(const Samples& samples, double from);

}  // namespace packbed::column
