// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Height and porosity of a bed that stands on z = 0.

#include <span>

#include "analysis/bead.hpp"

namespace packbed::analysis {

/// Bed height H [m]; 0 without beads. With S(z) the solid fraction of the 0.3 mm between z - 0.15 mm and
/// z + 0.15 mm, and S_bulk that of the middle half of the bed, H/4 to 3H/4:
///   S(H) = S_bulk / 2, the uppermost such place
/// found on bins of 0.1 mm, three of them the 0.3 mm, then solved between two of them to 1e-12 m with the
/// exact shares of the spheres. In a bed of less than 0.6 mm the window is half its height. A few loose
/// beads on top do not fill half a cross-section and do not count.
double bed_height(std::span<const Bead> beads, const Ranks& ranks);

/// From a quarter to three quarters of a height: free of floor and top.
constexpr Range middle_half(double height) { return {0.25 * height, 0.75 * height}; }

/// Of a column of this cross-section [m2] between two heights; what beads stick into walls counts as
/// in the column. 1 for an empty range.
double mean_porosity(std::span<const Bead> beads,
                     double cross_section,
                     const Range& z,
                     const Ranks& ranks);

/// The figures of a bed that every output wants.
struct BedFigures {
  double height = 0.0;           ///< [m]
  double mean_porosity = 1.0;    ///< of 0 to height
  double middle_porosity = 1.0;  ///< of the middle half; after settling: settled porosity
};
BedFigures bed_figures(std::span<const Bead> beads, double cross_section, const Ranks& ranks);

}  // namespace packbed::analysis
