// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/porosity_deviation.hpp"

#include <algorithm>
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

namespace {

PorosityDeviation operator*(double s, const PorosityDeviation& d) {
  return {.with_sign = s * d.with_sign, .absolute = s * d.absolute};
}

double start_of_bulk(const Profile& wall_profile, double diameter) {
  return std::min(4.0 * diameter, 0.5 * wall_profile.edges.back());
}

}  // namespace

WallDeviation wall_deviation(const Profile& wall_profile, double diameter) {
  constexpr double rounding = 1e-9;  // a bin that begins there belongs to the bulk
  const double from = (1.0 - rounding) * start_of_bulk(wall_profile, diameter);
  return wall_deviation(wall_profile, diameter, porosity_beyond(wall_profile, from));
}

WallDeviation wall_deviation(const Profile& wall_profile, double diameter, double bulk) {
  assert(diameter > 0.0);
  WallDeviation w;
  w.bulk_from = start_of_bulk(wall_profile, diameter);
  w.bulk = bulk;
  w.wall = integral_porosity_deviation(wall_profile.edges, wall_profile.porosities(), bulk);
  w.across = 2.0 * w.wall;
  w.wall_in_diameters = (1.0 / diameter) * w.wall;
  w.across_in_diameters = (1.0 / diameter) * w.across;
  return w;
}

}  // namespace packbed::analysis
