// SPDX-License-Identifier: BSD-3-Clause
#include "fluid/flow_program.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::fluid {

FlowProgram FlowProgram::steady(double velocity) { return through({{0.0, velocity}}); }

FlowProgram FlowProgram::through(std::vector<Point> points) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto& p = points[k];
    if (!std::isfinite(p.time) || !std::isfinite(p.velocity)) {
      throw ValueError(fmt::format("point {} of the flow program is not finite: {} s, {} m/s",
                                   k + 1, p.time, p.velocity));
    }
    if (k > 0 && p.time < points[k - 1].time) {
      throw ValueError(
          fmt::format("point {} of the flow program is at {} s, before the one at "
                      "{} s; give points in the order of time",
                      k + 1, p.time, points[k - 1].time));
    }
    if (k > 1 && p.time == points[k - 2].time) {
      throw ValueError(
          fmt::format("three points of the flow program are at {} s; a step needs two", p.time));
    }
  }
  FlowProgram program;
  program.points_ = std::move(points);
  return program;
}

double FlowProgram::at(double time) const {
  if (points_.empty()) return 0.0;
  const auto later = std::ranges::upper_bound(points_, time, {}, &Point::time);
  if (later == points_.begin()) return points_.front().velocity;
  const auto& before = *(later - 1);
  if (later == points_.end()) return before.velocity;
  const double share = (time - before.time) / (later->time - before.time);
  return before.velocity + share * (later->velocity - before.velocity);
}

}  // namespace packbed::fluid
