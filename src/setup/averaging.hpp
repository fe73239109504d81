// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "setup/case.hpp"

namespace packbed::setup {

/// Of the averaging kernel, where the case does not say: its reach over a mean grain diameter.
inline constexpr double reach_in_diameters = 3.0;

/// Sizes of the grains of a case, and of the beads that they stand for.
struct GrainSizes {
  double mean = 0.0;         ///< diameter of the grains [m]
  double bead_sauter = 0.0;  ///< Sauter mean of the beads [m]
  double inertia = 0.0;      ///< root of mean cube over mean, of the grains [m]
};
GrainSizes grain_sizes(const Case& c);

/// Reach of the averaging kernel of a case with a liquid: as asked for, or three mean grain diameters, but at
/// least a cell [m].
double averaging_reach(const Case& c);

/// The most that a kernel may reach: half of the shortest periodic side that the liquid sees; infinite
/// without such a side [m].
double most_averaging_reach(const Case& c);

}  // namespace packbed::setup
