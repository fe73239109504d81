// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The superficial velocity at the inlet in time: steps and linear ramps.

#include <vector>

namespace packbed::fluid {

/// A velocity [m/s] that is linear between points in time [s], constant before the first and after
/// the last. Two points of one time make a step: from that time on the second counts.
class FlowProgram {
 public:
  struct Point {
    double time;      ///< [s]
    double velocity;  ///< [m/s]
    bool operator==(const Point&) const = default;
  };

  /// No flow.
  FlowProgram() = default;
  /// The same velocity at all times.
  static FlowProgram steady(double velocity);
  /// Throws ValueError if times fall, if three points have one time, or if a number is not finite.
  static FlowProgram through(std::vector<Point> points);

  [[nodiscard]] double at(double time) const;
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  bool operator==(const FlowProgram&) const = default;

 private:
  std::vector<Point> points_;
};

}  // namespace packbed::fluid
