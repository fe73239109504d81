// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "continuum/bead/viscoelastic.hpp"
#include "core/error.hpp"
#include "study/curve_fit.hpp"

namespace packbed::study {
namespace {

constexpr double held_share = 0.98;  // of the largest displacement: held, but for noise

}  // namespace

double ramp_correction(RampCorrection kind, double x) {
  switch (kind) {
    case RampCorrection::exact:
      return continuum::ramp_remainder(x);
    case RampCorrection::mattice:
      return x == 0.0 ? 1.0 : -std::expm1(-x) / x;
    case RampCorrection::thesis:
      return x == 0.0 ? 1.0 : std::expm1(x) / x;
    case RampCorrection::none:
      break;
  }
  return 1.0;
}

Ramp find_ramp(const continuum::BeadCurve& curve) {
  const auto& d = curve.approach;
  const double top = *std::ranges::max_element(d);
  Ramp ramp;
  if (!(top > 0.0)) throw ValueError("the displacement never becomes positive");
  ramp.end = static_cast<std::size_t>(
      std::ranges::find_if(d, [&](double v) { return v >= held_share * top; }) - d.begin());
  // A straight line through the rows between a tenth and nine tenths of the depth.
  double n = 0.0, st = 0.0, sd = 0.0, stt = 0.0, std = 0.0;
  for (std::size_t i = 0; i <= ramp.end; ++i) {
    if (d[i] < 0.1 * top || d[i] > 0.9 * top) continue;
    const double t = curve.time[i] - curve.time.front();
    n += 1.0;
    st += t;
    sd += d[i];
    stt += t * t;
    std += t * d[i];
  }
  if (n < 3.0) {
    throw ValueError(
        "fewer than three rows rise from a tenth to nine tenths of the largest displacement, so "
        "its speed is not known");
  }
  ramp.speed = (n * std - st * sd) / (n * stt - st * st);
  if (!(ramp.speed > 0.0)) throw ValueError("the displacement does not rise with time");
  ramp.touch = curve.time.front() + (st - sd / ramp.speed) / n;
  // Rows within 2 % below the top may still be rising; held ones follow after the line has met the top.
  double sum = 0.0, held = 0.0;
  for (std::size_t i = ramp.end; i < d.size() && d[i] >= held_share * top; ++i) {
    if (curve.time[i] < ramp.touch + top / ramp.speed) continue;
    sum += d[i];
    held += 1.0;
  }
  ramp.depth = held > 0.0 ? sum / held : top;
  for (std::size_t i = 0; i < ramp.end; ++i) {
    if (curve.time[i] < ramp.touch) continue;
    const double line = ramp.speed * (curve.time[i] - ramp.touch);
    ramp.deviation = std::max(ramp.deviation, std::abs(d[i] - line) / ramp.depth);
  }
  return ramp;
}

}  // namespace packbed::study
