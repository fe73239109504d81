// SPDX-License-Identifier: BSD-3-Clause
#include "study/collapse.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace packbed::study {
namespace {

constexpr int points = 200;

// Deviation between the curves, curve k being read at axis * stretch_k.
double spread_of(const std::vector<Relaxation>& curves, const std::vector<double>& stretch) {
  double low = 0.0;
  double high = 1e300;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    low = std::max(low, curves[k].shortest / stretch[k]);
    high = std::min(high, curves[k].duration / stretch[k]);
  }
  if (!(high > low)) throw ValueError("the curves have no range of time / a^2 in common");
  double sum = 0.0;
  for (int i = 0; i < points; ++i) {
    const double axis = low * std::pow(high / low, i / (points - 1.0));
    double mean = 0.0;
    double square = 0.0;
    for (std::size_t k = 0; k < curves.size(); ++k) {
      const double value = curves[k].normalized(axis * stretch[k]);
      mean += value;
      square += value * value;
    }
    const auto n = static_cast<double>(curves.size());
    sum += std::max(0.0, (square - mean * mean / n) / (n - 1.0));
  }
  return std::sqrt(sum / points);
}

}  // namespace

double Relaxation::normalized(double t) const {
  double at_once = 0.0;
  double now = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    at_once += amplitudes[i];
    now += amplitudes[i] * std::exp(-t / times[i]);
  }
  return now / at_once;
}

Collapse collapse(const std::vector<Relaxation>& curves) {
  if (curves.size() < 2) throw ValueError("two curves or more are needed");
  const auto [least, most] = std::ranges::minmax(curves, {}, &Relaxation::contact_radius);
  if (most.contact_radius < 1.1 * least.contact_radius) {
    throw ValueError(
        "the curves have nearly the same contact radius; compress to different depths");
  }
  const std::vector<double> same(curves.size(), 1.0);
  std::vector<double> area;
  area.reserve(curves.size());
  for (const auto& c : curves) area.push_back(c.contact_radius * c.contact_radius);
  return {spread_of(curves, same), spread_of(curves, area)};
}

}  // namespace packbed::study
