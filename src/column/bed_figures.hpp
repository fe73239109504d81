// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Height and porosity of a bed, from the places of its beads. docs/theory/settling.md, section 3.

#include <span>
#include <vector>

#include "core/ranks.hpp"
#include "dem/particles.hpp"

namespace packbed::column {

/// A bead as the figures see it.
struct Ball {
  std::int64_t id = 0;
  double z = 0.0;         ///< center [m]
  double diameter = 0.0;  ///< [m]
};

/// Beads of all ranks on rank 0, sorted by id; nothing on the others.
std::vector<Ball> gather_balls(const dem::Particles& particles, const Ranks& ranks);

struct BedFigures {
  double height = 0.0;         ///< where the solid fraction falls to half of the bulk's [m]
  double porosity = 1.0;       ///< of the middle half of that height
  double top = 0.0;            ///< highest point of a bead [m]
  double mean_diameter = 0.0;  ///< [m]
};

/// Of a bed that stands on z = 0 in a column of cross-section `area` [m2]. All zero, porosity 1,
/// without beads.
BedFigures bed_figures(std::span<const Ball> balls, double area);

/// The same of all ranks' beads, on every rank.
BedFigures bed_figures(const dem::Particles& particles, double area, const Ranks& ranks);

}  // namespace packbed::column
