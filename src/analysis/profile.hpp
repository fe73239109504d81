// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Porosity along a direction, from the exact shares of the spheres in each bin. Every bead counts
/// with its full volume, overlaps with other beads twice (thesis eq. 7.9).

#include <span>
#include <vector>

#include "analysis/bead.hpp"
#include "mesh/column_shape.hpp"

namespace packbed::analysis {

enum class Axis { x, y, z };

/// What a profile is taken over.
struct ProfileBins {
  double width = 0.0;  ///< of a bin, > 0 [m]; the last one takes what is left
  Range z;             ///< part of the column, low < high [m]
};

struct Profile {
  std::vector<double> edges;   ///< of bins, ascending [m]; one more than bins
  std::vector<double> solid;   ///< volume of beads, one per bin [m3]
  std::vector<double> volume;  ///< one per bin [m3]
  double outside = 0.0;  ///< volume of beads within `z` but in no bin: pressed into a wall [m3]

  [[nodiscard]] std::size_t size() const { return solid.size(); }
  [[nodiscard]] double porosity(std::size_t bin) const { return 1.0 - solid[bin] / volume[bin]; }
  [[nodiscard]] std::vector<double> porosities() const;
};

/// Slabs across an axis of the column, from side to side; along z from z.low to z.high. Periodic sides
/// are wrapped: what sticks out on one side counts on the other.
Profile bed_profile(std::span<const Bead> beads,
                    const mesh::ColumnShape& shape,
                    Axis axis,
                    const ProfileBins& bins,
                    const Ranks& ranks);

/// Over the distance from the wall: rings of a cylinder from the wall to the axis; in a slice, and in a
/// box with walls, slabs from both walls to the middle, taken together. A box is taken along x if it
/// has walls there, else along y; ValueError if it has none.
Profile wall_profile(std::span<const Bead> beads,
                     const mesh::ColumnShape& shape,
                     const ProfileBins& bins,
                     const Ranks& ranks);

/// Porosity in planes across an axis at `positions`, of which none is on a wall: 1 - area cut out of the
/// spheres / area of the plane, within `z`. What a micrograph or a slice of a tomogram shows.
std::vector<double> plane_porosities(std::span<const Bead> beads,
                                     const mesh::ColumnShape& shape,
                                     Axis axis,
                                     std::span<const double> positions,
                                     const Range& z,
                                     const Ranks& ranks);

}  // namespace packbed::analysis
