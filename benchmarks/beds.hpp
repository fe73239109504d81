// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Packed beds to time things with: beads pressed down by a body force of 457.2 m/s2 onto a floor,
/// periodic in y, and in x unless there are walls. Coarse grains have diameters of 3 normal(86.9, 16.6) um.

#include <string>
#include <vector>

#include "dem/dem.hpp"

namespace packbed::benchmarks {

struct Bed {
  std::vector<dem::BeadStart> beads{};
  double width_x = 0.0, width_y = 0.0;  ///< [m]
  bool walls_in_x = false;
};

/// Bead `id` at rest at x, of 1140 kg/m3, 30 MPa, Poisson's ratio 0.2.
dem::BeadStart bead(std::size_t id, double diameter, const Vec3& x);

/// A bed by its name, packed but without springs:
///
///     b2k, b18k    2 200 and 18 300 coarse grains in 1.5 x 1.5 and 4.5 x 4.5 mm
///     s18k         18 300 coarse grains in a slice 10 mm wide, 0.8 mm thick, with walls in x
///     b223k, b1m   b18k 3 x 4 and 7 x 8 times: 219 600 and 1 024 800 beads
///     equal20k     20 000 beads of 260 um
///     wide20k      20 000 beads of 150 um to 1.5 mm, equal volume per logarithm of size
///
/// Generated (random, overlaps removed, settled); where $PACKBED_BEDS names a folder, read from NAME.data
/// there, and written there first if there is none.
Bed packed_bed(const std::string& name);

dem::Domain domain_of(const Bed& bed);

/// The mechanics of a bed: Hooke V 0.1 m/s, e 0.5, mu 0.1, elastic-plastic rolling 0.35.
dem::Dem make_dem(const Bed& bed, double step, const Ranks& ranks = Ranks::alone());

}  // namespace packbed::benchmarks
