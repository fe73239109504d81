// SPDX-License-Identifier: BSD-3-Clause
#include "fluid/figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/exact_sum.hpp"

namespace packbed::fluid {

double mean_pressure(const Fluid& fluid, mesh::Patch patch) {
  const auto& d = fluid.domain();
  std::vector<double> weighted;
  std::vector<double> areas;
  for (std::size_t b = 0; b < fluid.border().size(); ++b) {
    if (fluid.border().patch[b] != patch) continue;
    const double area = d.geometry.area[d.inner() + b];
    weighted.push_back(area * fluid.border_pressure()[b]);
    areas.push_back(area);
  }
  return order_independent_sum(weighted, d.ranks) / order_independent_sum(areas, d.ranks);
}

double pressure_drop(const Fluid& fluid) {
  return mean_pressure(fluid, mesh::Patch::inlet) - mean_pressure(fluid, mesh::Patch::outlet);
}

Vec3 wall_shear(const Fluid& fluid) {
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> z;
  for (std::size_t b = 0; b < fluid.border().size(); ++b) {
    const Vec3 force = fluid.wall_shear(b);
    x.push_back(force.x);
    y.push_back(force.y);
    z.push_back(force.z);
  }
  const auto& ranks = fluid.domain().ranks;
  return {order_independent_sum(x, ranks), order_independent_sum(y, ranks),
          order_independent_sum(z, ranks)};
}

std::vector<double> level_fluxes(const Fluid& fluid) {
  const auto& d = fluid.domain();
  const auto upward = [&](std::size_t f) {
    return d.geometry.area[f] * d.geometry.normal[f].z * fluid.q()[f];
  };
  double largest = 0.0;
  for (std::size_t f = 0; f < d.faces(); ++f) largest = std::max(largest, std::abs(upward(f)));
  largest = d.ranks.max(largest);
  const auto levels = static_cast<std::size_t>(d.mesh.layers()) + 1;
  if (!(largest > 0.0)) return std::vector<double>(levels, 0.0);
  ExactSums sums(levels, largest);
  for (std::size_t f = 0; f < d.faces(); ++f) {
    const auto& source = d.part.source[f];
    if (source.kind != mesh::FaceSource::Kind::level || !d.is_own(d.owner(f))) continue;
    sums.add(static_cast<std::size_t>(source.layer), upward(f));
    // Where z is periodic, the lowest level is the top one too.
    if (source.layer == 0 && d.mesh.is_periodic_in_z()) sums.add(levels - 1, upward(f));
  }
  return sums.totals(d.ranks);
}

double courant_rate(const Fluid& fluid, double superficial) {
  constexpr double unevenness = 1.5;
  const auto& d = fluid.domain();
  std::vector<double> flux(d.faces());  // in space, not relative to faces that move
  for (std::size_t f = 0; f < flux.size(); ++f) flux[f] = d.geometry.area[f] * fluid.q()[f];
  const auto through = throughflow(d, flux);
  std::array<double, 2> largest{};  // now, 1 / eps
  for (std::size_t c = 0; c < d.own(); ++c) {
    largest[0] = std::max(largest[0], through[c] / (d.part.volume[c] * fluid.eps()[c]));
    largest[1] = std::max(largest[1], 1.0 / fluid.eps()[c]);
  }
  d.ranks.max(largest);
  const double coming = std::abs(superficial) * d.mesh.layers() / d.mesh.top() * largest[1];
  return largest[0] >= coming ? largest[0] : unevenness * coming;
}

double next_step(const StepControl& control, double dt, double courant) {
  const double wanted = courant > 0.0 ? dt * control.courant / courant : control.largest;
  return std::min({wanted, control.growth * dt, control.largest});
}

}  // namespace packbed::fluid
