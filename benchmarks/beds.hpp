// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Packed beds to time things with: beads of diameter 3 normal(86.9, 16.6) um, pressed down by a
/// body force of 457.2 m/s2, periodic in x and y, on a floor.

#include <string>
#include <vector>

#include "dem/dem.hpp"

namespace packbed::benchmarks {

struct Bed {
  std::vector<dem::BeadStart> beads;
  double width_x = 0.0, width_y = 0.0;  ///< of the periodic cell [m]
};

/// A bed of a name: b2k (2 200 beads), b18k (18 300) or b1m (b18k 7 x 8 times, 1 024 800), packed but
/// without history. Read from $PACKBED_BEDS/NAME.data (LAMMPS data file, as the peers read it) where
/// that is set, else generated: random, overlaps removed, settled.
Bed packed_bed(const std::string& name);

/// The mechanics of a bed: Hooke V 0.1 m/s, e 0.5, mu 0.1, elastic-plastic rolling 0.35.
dem::Dem make_dem(const Bed& bed, double step);

}  // namespace packbed::benchmarks
