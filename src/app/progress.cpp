// SPDX-License-Identifier: BSD-3-Clause
#include "app/progress.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>
#include <unistd.h>

namespace packbed::app {
namespace {

std::string as_time(double seconds) {
  if (seconds < 100.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 6000.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

}  // namespace

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void Progress::show(const dem::Dem& dem, const State& state) {
  static const bool terminal =
      isatty(STDERR_FILENO) == 1 || std::getenv("PACKBED_PROGRESS") != nullptr;
  const double spent = seconds_since(start_);
  if (first_share_ < 0.0) first_share_ = state.share;
  if (!terminal || (spent - shown_ < 0.5 && state.share < 1.0)) return;
  shown_ = spent;
  const double rate = static_cast<double>(dem.steps() - steps_before_) *
                      static_cast<double>(dem.bead_count()) / std::max(spent, 1e-9);
  const double gained = state.share - first_share_;
  const auto left = gained > 0.0 ? as_time(spent * (1.0 - state.share) / gained) : "?";
  const auto height =
      state.bed_height > 0.0 ? fmt::format("  bed {:.2f} mm", 1e3 * state.bed_height) : "";
  fmt::print(stderr, "\r\033[K[{}/{}] {}  {:.0f} %  {:.4g} s{}  {:.3g} M particle-steps/s  {} left",
             state.stage, state.stages, state.name, 100.0 * state.share, dem.time(), height,
             rate * 1e-6, left);
  open_ = true;
}

void Progress::end() {
  if (open_) fmt::print(stderr, "\n");
  open_ = false;
}

}  // namespace packbed::app
