// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// What a protocol step looks at to know how far it is: the bed, and how near it is to rest. All
/// ranks call it and get the same bits.

#include "dem/dem.hpp"

namespace packbed::column {

/// A bed that stands on z = 0.
struct BedLook {
  double height = 0.0;         ///< analysis::bed_height [m]
  double porosity = 1.0;       ///< of the middle half of the height
  double top = 0.0;            ///< highest point of a bead [m]
  double mean_diameter = 0.0;  ///< [m]
};

/// In a column of cross-section `area` [m2].
BedLook look_at_bed(const dem::Dem& dem, double area);

/// Porosity of the middle half alone.
double middle_porosity(const dem::Dem& dem, double area);

/// How far from rest the beads are.
struct Rest {
  double unbalanced =
      1.0;  ///< mean unbalanced force of a bead / mean contact force; 1 without contacts
  double fastest = 0.0;       ///< speed of the fastest bead along z [m/s]
  double speed = 0.0;         ///< of the fastest free bead in any direction [m/s]
  double coordination = 0.0;  ///< contacts between beads per bead
  double max_overlap = 0.0;   ///< largest overlap / diameter
};

Rest rest_of(const dem::Dem& dem);

/// Whether the height of a bed changed by less than 1e-4 mean diameters in a slice.
bool is_steady(double height, double height_before, double mean_diameter);

/// sqrt(inertia scale d / gravity) [s]: in this time a bead falls by half its diameter, or tips over.
/// The background damping of a bed that comes to rest: faster, and beads about to roll off take ever
/// longer; slower, and the bed swings on.
double falling_time(double mean_diameter, double gravity, const dem::Dem& dem);

}  // namespace packbed::column
