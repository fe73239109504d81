// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The plunger of a column: its frit is the wall "lid" to the beads and the upper end of the mesh to the
/// liquid. All ranks call these.

#include <optional>

#include "dem/dem.hpp"

namespace packbed::column {

/// z of a lid that does not act [m].
inline constexpr double lid_away = 1e3;

/// Height of its face [m]; nothing where there is none, or while it does not act.
std::optional<double> plunger_position(const std::vector<dem::Wall>& walls);

/// It moves at `speed` [m/s], upwards, from the next time step on.
void set_plunger_speed(double speed, dem::Dem& dem);

/// Of the beads on it, upwards [N].
double plunger_force(const dem::Dem& dem);

/// Of the beads on the floor, downwards [N]; 0 where there is none.
double floor_force(const dem::Dem& dem);

/// Puts it somewhere else at once [m], lid_away too. Lists are made anew; nothing happens where there is none.
void place_plunger(double height, dem::Dem& dem);

}  // namespace packbed::column
