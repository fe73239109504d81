// SPDX-License-Identifier: BSD-3-Clause
// What a step leaves: how well cells are closed, and how far the liquid goes.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "fluid/fluid_step.hpp"
#include "fluid/momentum.hpp"

namespace packbed::fluid {

/// Volume per time that must leave each own cell through its faces [m3/s].
std::vector<double> Fluid::displaced(const Step& s) const {
  std::vector<double> all(domain_.own());
  for (std::size_t c = 0; c < all.size(); ++c) {
    const double volume = domain_.part.volume[c];
    // eps V less its old value, in a form that is 0 to the last bit where nothing has changed.
    const double gained =
        (eps_[c] - s.eps_old[c]) * volume + s.eps_old[c] * (volume - s.volume_old[c]);
    all[c] = s.bed.source[c] * volume - gained / s.dt;
  }
  return all;
}

/// What each own cell lacks to be closed, from the fluxes alone [m3/s].
std::vector<double> Fluid::continuity_errors(const Step& s) const {
  auto all = displaced(s);
  all.resize(domain_.cells(), 0.0);
  for (std::size_t f = 0; f < domain_.faces(); ++f) {
    all[domain_.owner(f)] -= flux_[f];
    if (f < domain_.inner()) all[domain_.neighbor(f)] += flux_[f];
  }
  all.resize(domain_.own());
  return all;
}

void Fluid::report(Step& s) const {
  const auto errors = continuity_errors(s);
  const auto through = throughflow(domain_, flux_);
  std::array<double, 3> largest{};
  for (std::size_t c = 0; c < domain_.own(); ++c) {
    largest[0] = std::max(largest[0], std::abs(errors[c]));
    largest[1] = std::max(largest[1], through[c]);
    largest[2] = std::max(largest[2], s.dt * through[c] / (eps_[c] * domain_.part.volume[c]));
    if (!std::isfinite(errors[c])) largest[0] = errors[c];
  }
  domain_.ranks.max(largest);
  const double size = norm_of(domain_.ranks, through);
  const auto over = [](double a, double b) { return b > 0.0 ? a / b : a; };
  s.report.continuity_error = over(norm_of(domain_.ranks, errors), size);
  s.report.largest_error = over(largest[0], largest[1]);
  s.report.courant = largest[2];
  if (!std::isfinite(largest[0]) || !std::isfinite(largest[2])) {
    throw DivergenceError(
        fmt::format("the liquid has velocities that are not finite after the step of {} s to {} s",
                    s.dt, time_));
  }
}

}  // namespace packbed::fluid
