// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Builders for tests of the liquid.

#include <cmath>
#include <functional>
#include <vector>

#include "fluid/fluid.hpp"

namespace packbed::test {

using mesh::Boundary;

struct BoxCase {
  std::array<double, 3> size;
  std::array<std::int32_t, 3> cells;
  std::array<Boundary, 3> boundaries{Boundary::wall, Boundary::wall, Boundary::wall};

  [[nodiscard]] mesh::ColumnMesh mesh() const {
    return {mesh::Box{.size = size, .boundaries = boundaries},
            {.x = cells[0], .y = cells[1], .layers = cells[2]}};
  }
};

/// On all cells, one rank.
inline fluid::Fluid make_fluid(const fluid::FluidOptions& options, const mesh::ColumnMesh& mesh) {
  return {options, mesh, mesh::CellPartition(mesh.cell_count(), 1), Ranks::alone()};
}

/// A field from a function of the cell's center.
template <class Function>
auto field(const fluid::Fluid& fluid, Function function) {
  std::vector<decltype(function(Vec3{}))> values;
  for (std::size_t c = 0; c < fluid.domain().own(); ++c) {
    values.push_back(function(fluid.domain().part.center[c]));
  }
  return values;
}

/// Root of the mean square over the volume of the own cells.
template <class Function>
double l2_norm(const fluid::Fluid& fluid, Function of_cell) {
  double sum = 0.0;
  double volume = 0.0;
  for (std::size_t c = 0; c < fluid.domain().own(); ++c) {
    const double value = of_cell(c);
    sum += fluid.domain().part.volume[c] * value * value;
    volume += fluid.domain().part.volume[c];
  }
  return std::sqrt(sum / volume);
}

/// 2-norm of the difference of the velocity from an exact one.
template <class Function>
double velocity_error(const fluid::Fluid& fluid, Function exact) {
  return l2_norm(fluid, [&](std::size_t c) {
    return norm(fluid.u()[c] - exact(fluid.domain().part.center[c]));
  });
}

/// The same of the dynamic pressure, means taken out.
template <class Function>
double pressure_error(const fluid::Fluid& fluid, Function exact) {
  const auto& d = fluid.domain();
  double mean = 0.0;
  double volume = 0.0;
  const auto difference = [&](std::size_t c) {
    return fluid.dynamic_pressure()[c] - exact(d.part.center[c]);
  };
  for (std::size_t c = 0; c < d.own(); ++c) {
    mean += d.part.volume[c] * difference(c);
    volume += d.part.volume[c];
  }
  mean /= volume;
  return l2_norm(fluid, [&](std::size_t c) { return difference(c) - mean; });
}

/// Slope of log(error) over log(spacing), by least squares.
inline double fitted_order(const std::vector<double>& spacing, const std::vector<double>& error) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  const auto n = static_cast<double>(spacing.size());
  for (std::size_t k = 0; k < spacing.size(); ++k) {
    const double x = std::log(spacing[k]);
    const double y = std::log(error[k]);
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// Steps until the velocity changes by less than `change`, relative to its largest, in a step; whether it does.
inline bool run_to_rest(
    fluid::Fluid& fluid, double dt, const fluid::Bed& bed, double change, int most_steps) {
  for (int k = 0; k < most_steps; ++k) {
    const auto before = fluid.u();
    fluid.step(dt, bed);
    double largest = 0.0;
    double moved = 0.0;
    for (std::size_t c = 0; c < fluid.domain().own(); ++c) {
      largest = std::max(largest, norm(fluid.u()[c]));
      moved = std::max(moved, norm(fluid.u()[c] - before[c]));
    }
    if (moved <= change * largest) return true;
  }
  return false;
}

}  // namespace packbed::test
