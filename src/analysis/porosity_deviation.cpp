// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/porosity_deviation.hpp"

#include <cassert>
#include <cmath>

#include "core/error.hpp"

namespace packbed::analysis {

double porosity_beyond(const Profile& profile, double from) {
  double solid = 0.0;
  double volume = 0.0;
  for (std::size_t k = 0; k < profile.size(); ++k) {
    if (profile.edges[k] < from) continue;
    solid += profile.solid[k];
    volume += profile.volume[k];
  }
  if (!(volume > 0.0)) throw ValueError("no bin of the profile lies beyond the distance asked for");
  return 1.0 - solid / volume;
}

PorosityDeviation integral_porosity_deviation(std::span<const double> edges,
                                              std::span<const double> porosity,
                                              double bulk) {
  assert(edges.size() == porosity.size() + 1);
  PorosityDeviation d;
  for (std::size_t k = 0; k < porosity.size(); ++k) {
    const double term = (porosity[k] - bulk) * (edges[k + 1] - edges[k]);
    d.with_sign += term;
    d.absolute += std::abs(term);
  }
  return d;
}

}  // namespace packbed::analysis
