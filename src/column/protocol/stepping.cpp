// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/stepping.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::column {
namespace {

constexpr double safety = 0.8;
constexpr double worth_a_change = 1.1;

void check_fixed(const SteppingOptions& options,
                 const dem::Dem& dem,
                 const dem::StableStep& limit) {
  if (options.force_step || *options.fixed_step <= limit.step) return;
  throw DivergenceError(
      fmt::format("step {}, time {:.6g} s: the time step {:.4g} s is above the stable one, {:.4g} "
                  "s, which bead "
                  "{} at ({:.6g}, {:.6g}, {:.6g}) mm with {} contacts sets; give a smaller "
                  "numerics.step, leave "
                  "it out, or set numerics.force_step = true",
                  dem.steps(), dem.time(), *options.fixed_step, limit.step, limit.bead,
                  1e3 * limit.x.x, 1e3 * limit.x.y, 1e3 * limit.x.z, limit.contacts));
}

}  // namespace

void choose_step(const SteppingOptions& options, dem::Dem& dem) {
  const auto limit = dem.stable();
  const double now = dem.options().step;
  double wanted = std::min(options.longest_step, safety * limit.step);
  if (options.fixed_step) {
    check_fixed(options, dem, limit);
    wanted = *options.fixed_step;
  }
  const bool changes = options.fixed_step ? wanted != now
                                          : wanted < now || wanted > worth_a_change * now ||
                                                (wanted == options.longest_step && wanted > now);
  if (changes) dem.set_step(wanted);
}

}  // namespace packbed::column
