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

/// Width of the bins of a wall profile that `wall_deviation` is meant for, in bead diameters.
inline constexpr double deviation_bin = 0.05;

/// The same of a wall profile, as the thesis gives it (section 10.2.2).
struct WallDeviation {
  double bulk_from = 0.0;                 ///< the bulk begins so far from the wall [m]
  double bulk = 0.0;                      ///< its porosity
  PorosityDeviation wall;                 ///< from one wall to the axis or middle [m]
  PorosityDeviation across;               ///< from wall to wall: twice that [m]
  PorosityDeviation wall_in_diameters;    ///< over the bead diameter
  PorosityDeviation across_in_diameters;  ///< likewise
};

/// Of a `wall_profile` and a bead diameter d [m]; both lengths above 0. The bulk begins 4 d from the wall, or
/// half-way to the middle where that is nearer: a column below 16 d has no 4 d of bulk.
WallDeviation wall_deviation(const Profile& wall_profile, double diameter);

/// The same with a bulk porosity that is known.
WallDeviation wall_deviation(const Profile& wall_profile, double diameter, double bulk);

}  // namespace packbed::analysis
