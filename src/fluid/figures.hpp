// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Figures of the liquid in a column. All ranks call them; all get the same, independent of the order of cells.

#include <vector>

#include "fluid/fluid.hpp"

namespace packbed::fluid {

/// Mean dynamic pressure over the faces of a patch [Pa], by area. NaN if the mesh lacks the patch.
double mean_pressure(const Fluid& fluid, mesh::Patch patch);

/// Dynamic pressure at the inlet less that at the outlet [Pa]: without its hydrostatic part.
double pressure_drop(const Fluid& fluid);

/// Force of the liquid on all walls, along them [N].
Vec3 wall_shear(const Fluid& fluid);

/// Volume of liquid that passes each level of the mesh per time, upwards, from z = 0 to the top: layers + 1
/// values [m3/s]. Relative to space, not to levels that move.
std::vector<double> level_fluxes(const Fluid& fluid);

/// Courant number per time step [1/s]: the largest sum_f |S q| / (2 eps V) of a cell. Where a flow of `superficial`
/// [m/s] along the column through the densest cell would be faster, it is still to come, and 1.5 times that counts:
/// uneven beds are passed that much faster somewhere.
double courant_rate(const Fluid& fluid, double superficial);

/// How the time step follows the Courant number.
struct StepControl {
  double courant = 0.5;   ///< aimed at; the largest of all cells, by interstitial velocity
  double largest = 1e-3;  ///< [s]
  double growth = 1.2;    ///< at most, from step to step
};

/// The step after one of `dt` [s] whose report says `courant`: shorter at once, longer by `growth` at most.
double next_step(const StepControl& control, double dt, double courant);

}  // namespace packbed::fluid
