// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// How far the porosity near a wall is from that of the bulk.

#include <span>

#include "analysis/profile.hpp"

namespace packbed::analysis {

/// Porosity of all bins from the distance `from` on.
double porosity_beyond(const Profile& profile, double from);

/// Integral of eps - eps_bulk over the coordinate [m], with its sign and as absolute value; the
/// integral porosity deviation (IPD) of thesis eq. 3.64 is the first as printed. A wall profile covers
/// one wall: over the diameter it is twice that. `edges` has one entry more than `porosity`.
struct PorosityDeviation {
  double with_sign = 0.0;
  double absolute = 0.0;
};
PorosityDeviation integral_porosity_deviation(std::span<const double> edges,
                                              std::span<const double> porosity,
                                              double bulk);

}  // namespace packbed::analysis
