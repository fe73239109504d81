// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "continuum/packed_bed.hpp"
#include "continuum/wall_support/wall_support.hpp"

namespace packbed::continuum::detail {

/// The right-hand side of thesis eq. 7.6 for one law of the modulus.
template <class Law>
struct BedBalance {
  const CompressibleBed& bed;
  const WallSupportColumn& column;
  const Law& law;

  [[nodiscard]] double porosity(double lambda) const {
    return (bed.eps0 - lambda) / (1.0 - lambda);
  }
  /// -dp/dz of 1 m/s [Pa s/m2]; eq. 7.10, Kozeny-Carman. Infinite where the pores are closed.
  [[nodiscard]] double resistance(double lambda) const {
    return kozeny_carman_gradient(porosity(lambda), bed.diameter, column.mu_f, 1.0);
  }
  /// What the wall takes, per height [Pa/m].
  [[nodiscard]] double wall(double sigma) const {
    return 4.0 / column.diameter * bed.wall_friction * bed.poisson / (1.0 - bed.poisson) * sigma;
  }
  [[nodiscard]] double weight(double lambda) const {
    return bed.density_difference * (1.0 - porosity(lambda)) * column.gravity;
  }
  /// d sigma/dz.
  [[nodiscard]] double rise(double lambda, double sigma, double u) const {
    return resistance(lambda) * u - wall(sigma) + weight(lambda);
  }
  /// dz/d(depth given): 1 - lambda if the depth is that of the settled bed.
  [[nodiscard]] double shrink(double lambda) const {
    return column.reading == Reading::material ? 1.0 - lambda : 1.0;
  }
};

}  // namespace packbed::continuum::detail
