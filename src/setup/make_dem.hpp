// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// From a case to beads, walls and contact laws.

#include <vector>

#include "dem/dem.hpp"
#include "dem/step_choice.hpp"
#include "setup/case.hpp"

namespace packbed::setup {

/// Standard gravity of the thesis, table B.1 [m/s2].
inline constexpr double gravity = 9.81;

dem::ContactModel contact_model(const Case& c);

/// Walls of the column: "x_low", "x_high", ... of a box; "tube" or "x_low", "x_high", and "floor",
/// "lid" of a column.
std::vector<dem::Wall> make_walls(const Case& c);

/// The beads of the case's bead file; weight less buoyancy where there is a liquid.
std::vector<dem::BeadStart> make_beads(const Case& c);

/// The step that the case gives, or the recommended one, with what it rests on. Where beads are still
/// to be made, the smallest and the mean one of the size distribution stand for them.
dem::StepChoice step_of(const Case& c);

/// Domain, laws and numerics of a case.
dem::DemOptions options_of(const Case& c, double step);

/// Beads, walls and laws of a case with a bead file.
dem::Dem make_dem(const Case& c, double step, const Ranks& ranks);

}  // namespace packbed::setup
