// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Time steps that follow the stable step of the bed.

#include <optional>

#include "dem/dem.hpp"

namespace packbed::column {

struct SteppingOptions {
  double longest_step = 0.0;         ///< a tenth of the shortest contact, say [s]
  std::optional<double> fixed_step;  ///< given by the user [s]
  bool force_step = false;           ///< take it even above the stable step
};

/// Gives the beads the step for the next slice: 0.8 of the stable step of the contacts that there are,
/// and no longer than the longest. It follows the bed at once downwards, and upwards only by a tenth
/// or more. Depends on the bed alone, never on time. Throws DivergenceError for a fixed step above the
/// stable one, unless forced.
void choose_step(const SteppingOptions& options, dem::Dem& dem);

}  // namespace packbed::column
