// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Porosity to which a cloud of beads settles, and contacts per bead that it then has, as measured with this
/// program: docs/theory/settling.md.

namespace packbed::column {

/// Porosity of the middle of a bed of CM Sepharose grains away from walls that was settled, dry, with
/// this friction of bead on bead and this rolling friction; interpolated, and held at the ends.
double settled_porosity(double friction, double rolling_friction);

/// The friction at which a bed settles to a porosity; within [0, 0.5].
double settling_friction(double porosity, double rolling_friction);

/// Contacts per bead of a bed that settled to a porosity by itself, with that friction.
double settled_coordination(double porosity, double rolling_friction);

}  // namespace packbed::column
