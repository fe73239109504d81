// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

#include "dem/dem.hpp"

namespace packbed::app {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start);

/// The line on standard error that tells how far a run is; only on a terminal.
class Progress {
 public:
  /// Steps that the simulation had behind it when this process began.
  explicit Progress(std::int64_t steps_before) : steps_before_(steps_before) {}

  struct State {
    std::int64_t stage;   ///< from 1
    std::int64_t stages;  ///< in all
    std::string name;     ///< "settle: falling"
    double share;         ///< of the whole run that is done
    double bed_height;    ///< [m]; 0 where there is no bed
  };
  void show(const dem::Dem& dem, const State& state);
  /// Ends the line, so that a message can follow.
  void end();

 private:
  std::int64_t steps_before_;
  double first_share_ = -1.0;
  double shown_ = -1.0;
  bool open_ = false;
  Clock::time_point start_ = Clock::now();
};

}  // namespace packbed::app
