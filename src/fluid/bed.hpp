// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The bed as fields, as the liquid knows it.

#include <vector>

#include "core/vec3.hpp"
#include "fluid/domain.hpp"

namespace packbed::fluid {

/// What the beads are to the liquid, at the end of a step; one value per own cell. An empty field has its
/// default everywhere.
struct Bed {
  std::vector<double> eps{};  ///< void fraction, in (0, 1]; default 1
  std::vector<double>
      exchange{};               ///< of momentum: drag over slip, per volume; default 0 [kg/(m3 s)]
  std::vector<Vec3> u_solid{};  ///< velocity of the beads; default 0 [m/s]
  std::vector<double>
      source{};  ///< liquid that comes out of the beads, with their velocity, per volume;
                 ///< what goes into them (< 0) has that of the liquid; default 0 [1/s]
  std::vector<Vec3> force{};  ///< further force on the liquid, per volume; default 0 [N/m3]
};

/// `bed` with every field, each of `own` values. Throws ValueError for one of another length.
Bed filled(const Bed& bed, std::size_t own);

/// Throws DivergenceError, with the place, for void fractions or exchange coefficients that cannot be.
void check(const Bed& bed, const Domain& domain, double time);

}  // namespace packbed::fluid
