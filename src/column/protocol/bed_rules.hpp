// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// What the rules for inertia, time steps and exchanges ask for in steps that drive a bed, by a flow or by the
/// plunger: how to step it, and what it is now.

#include <optional>

#include "column/protocol/stepping.hpp"
#include "dem/dem.hpp"
#include "dem/inertia_scale.hpp"

namespace packbed::column {

/// The rule for the time between exchanges of beads and liquid: at most this, in a flow and under the plunger, and
/// shares of the time in which the bed consolidates and of a plateau.
inline constexpr double longest_interval = 10e-3;            // [s]
inline constexpr double longest_interval_of_plunger = 5e-3;  // [s]
inline constexpr double interval_of_consolidation = 0.25;
inline constexpr double interval_of_plateau = 0.05;

/// What the rules ask for besides the bed itself.
struct GrainProperties {
  double viscosity = 0.0;         ///< of the liquid; 0: dry [Pa s]
  double density = 0.0;           ///< of the beads [kg/m3]
  double bead_diameter = 0.0;     ///< Sauter mean of the beads that grains stand for [m]
  double diameter = 0.0;          ///< mean, of the grains [m]
  double inertia_diameter = 0.0;  ///< root of mean cube over mean, of the grains [m]
  double stiffness = 0.0;         ///< of a contact of two of them [N/m]
};

/// How a step drives a bed.
struct DriveOptions {
  double interval = 0.0;  ///< between rows of the outputs [s]
  double area = 0.0;      ///< cross-section of the bed [m2]
  std::optional<double>
      coupling_interval;                ///< longest time between exchanges [s]; none: by the rule
  std::optional<double> inertia_scale;  ///< none: as far as the rule goes
  bool inertia_by_size = true;          ///< small beads are scaled more, else all alike
  SteppingOptions stepping{};           ///< at an inertia scale of 1
  double longest_step_per_diameter =
      0.0;                         ///< the least of all beads, at an inertia scale of 1 [s/m]
  double smallest_diameter = 0.0;  ///< of a grain [m]
  GrainProperties grains{};
};

/// The bed as it is.
struct BedState {
  double height = 0.0;        ///< [m]
  double modulus = 0.0;       ///< in uniaxial strain, estimated [Pa]
  double bulk_density = 0.0;  ///< solid fraction times bead density [kg/m3]
  double solid_fraction = 0.0;
};

/// Nothing where there is no bed. All ranks call it.
std::optional<BedState> bed_state(const DriveOptions& options, const dem::Dem& dem);

/// For the rule of a bed in a flow that stays as it is for `flow_step` [s]; `presses`: no bead leaves the bed.
dem::DraggedBed dragged_bed(const BedState& bed,
                            const GrainProperties& grains,
                            bool presses,
                            double flow_step);

/// Scales the inertia of all beads together by `scale`, each by its size or all alike.
void scale_inertia(const DriveOptions& options, double scale, dem::Dem& dem);

/// A tenth of the shortest contact at an inertia scale [s]. Scaled by size, contacts of beads of diameter d last
/// t sqrt(1 + (s - 1) (D / d + (D / d)^2) / 2); where t >= k d that is at least
///   sqrt(t^2 + (s - 1) k^2 D (d + D) / 2)   with the smallest t, k and d.
double longest_step(const DriveOptions& options, const dem::InertiaScale& inertia);

/// Gives the beads the step for the next slice, at the inertia scale that they have.
void choose_step(const DriveOptions& options, dem::Dem& dem);

/// Steps of the beads for an interval that is cut into equal ones, none longer than the present step, which
/// becomes that length.
std::int64_t cut_into_steps(double interval, dem::Dem& dem);

}  // namespace packbed::column
