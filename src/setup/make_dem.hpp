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

/// A bead; its weight less buoyancy where there is a liquid. Diameter in m, density in kg/m3.
dem::BeadProperties bead_properties(
    const Case& c, std::int64_t id, double diameter, double density, const dem::Material& material);

/// The beads of the case's bead file, or the cloud of beads that the program makes
/// (setup/make_settle.hpp); none if the case has neither.
std::vector<dem::BeadStart> make_beads(const Case& c);

/// The step that the case gives, or the recommended one, with what it rests on. Where beads are still
/// to be made, the smallest and the mean one of the size distribution stand for them.
dem::StepChoice step_of(const Case& c);

/// Domain, laws and numerics of a case.
dem::DemOptions options_of(const Case& c, double step);

/// Beads, walls and laws of a case. The lid is out of the way if a cloud is to settle first.
dem::Dem make_dem(const Case& c, double step, const Ranks& ranks);

}  // namespace packbed::setup
