// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// How far the inertia of beads may be scaled (masses and moments of inertia times s, the time step
/// times sqrt(s)), and how to see afterwards that it was too far. docs/theory/contact.md, section 6.

#include <optional>
#include <string>
#include <string_view>

#include "dem/dem.hpp"

namespace packbed::dem {

/// A scale s >= 1 and the sentence that says what set it, for logs and summaries.
struct InertiaChoice {
  double scale = 1.0;
  std::string reason;
};

/// Limits of the rules and of the monitor.
inline constexpr double most_speed_ratio = 0.01;       ///< plunger speed / scaled wave speed
inline constexpr double most_kinetic_share = 1e-4;     ///< kinetic / elastic energy
inline constexpr double most_unbalanced_share = 1e-3;  ///< mean unbalanced / mean contact force
inline constexpr double least_damping_ratio = 1.0;     ///< of the lowest mode of a bed in liquid

/// Modulus of a random packing of linear springs whose beads move with the mean strain, in uniaxial
/// strain [Pa]: 3 z phi k_n / (5 pi d), without friction. Real packings are softer.
/// `coordination` z, `solid_fraction` phi, `stiffness` k_n of a pair [N/m], `diameter` [m].
/// It is 9/5 of the bulk modulus z phi k_n / (3 pi d), since all contacts are central.
double estimated_modulus(double coordination,
                         double solid_fraction,
                         double stiffness,
                         double diameter);

/// (i) Beads that move freely (falling, or a step "run" without a driven wall): 1.
InertiaChoice free_inertia_scale();

/// A bed pressed slowly by a wall, without liquid.
struct DrivenBed {
  double speed;         ///< of the wall [m/s]
  double modulus;       ///< of the bed in uniaxial strain, measured or estimated [Pa]
  double bulk_density;  ///< solid fraction times bead density [kg/m3]
  double strain;        ///< elastic strain from which on the bed must count as static
};

/// (ii) The largest s with v / c <= 0.01, c = sqrt(M / (rho s)), and kinetic / elastic energy
/// (rho s v^2 / 6) / (M strain^2 / 2) <= 1e-4 for a velocity that falls linearly through the bed:
///   s = (M / rho) / v^2 min(0.01^2, 3e-4 strain^2).
/// The second bounds more below a strain of 0.58. Not below 1. Throws ValueError for numbers that are
/// not positive.
InertiaChoice driven_inertia_scale(const DrivenBed& bed);

/// A bed in liquid that is compressed by flow.
struct DraggedBed {
  double drag_rate;        ///< drag coefficient / mass of a bead in the bed, at s = 1 [1/s]
  double height;           ///< [m]
  double modulus;          ///< in uniaxial strain [Pa]
  double bulk_density;     ///< solid fraction times bead density [kg/m3]
  double loose_drag_time;  ///< mass / drag coefficient of a bead without contacts, at s = 1 [s]
  double flow_step;        ///< time for which the flow stays as it is [s]
};

/// 180 eta phi / (eps^3 d^2 rho): the drag rate in a bed of solid fraction phi = 1 - eps by
/// Kozeny-Carman [1/s]. Coarse grains of c^3 beads have that of their beads. `diameter` is that of the
/// real beads [m], `viscosity` [Pa s], `density` of the beads [kg/m3].
double kozeny_carman_drag_rate(double solid_fraction,
                               double viscosity,
                               double diameter,
                               double density);

/// Damping ratio of the lowest mode of the bed, fixed below and free above:
///   zeta = drag rate / (2 s w_1),  w_1 = pi / (2 H) sqrt(M / (rho s)):
/// it falls with sqrt(s).
double damping_ratio_of_bed(const DraggedBed& bed, double scale);

/// (iii) The largest s with damping ratio >= 1 (a bed that swings over packs too densely) and
/// s loose_drag_time <= flow_step. Not below 1. Throws ValueError for numbers that are not positive.
InertiaChoice dragged_inertia_scale(const DraggedBed& bed);

/// Time in which the slowest mode of an overdamped bed falls to 1/e, at any scale [s]:
///   drag rate / (s w_1^2) = drag rate rho (2 H / pi)^2 / M.
double consolidation_time(const DraggedBed& bed);

/// What damps the motion of a bed.
enum class BedMedium { dry, liquid };

/// The monitor: one line that names the stage, the figures, their limits and a scale that would have
/// been fine; nothing if the bed counts as static. Both figures grow with s in a slowly driven bed.
/// In a liquid the unbalanced force alone counts: a bed that still consolidates moves without
/// swinging (docs/theory/contact.md, section 6).
std::optional<std::string> inertia_warning(std::string_view stage,
                                           double scale,
                                           const Sums& s,
                                           BedMedium medium);

}  // namespace packbed::dem
