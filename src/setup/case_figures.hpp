// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// What can be said of a case before it is run. Estimates; a run reports what it measured.

#include <cstdint>
#include <optional>

#include "dem/step_choice.hpp"
#include "mesh/mesh_quality.hpp"
#include "resin/size_statistics.hpp"
#include "setup/case.hpp"

namespace packbed::setup {

struct FlowFigures {
  double highest_velocity;   ///< superficial, of all steps [m/s]
  double reynolds;           ///< thesis eq. 3.55, with the Sauter diameter
  double stokes;             ///< thesis eq. 8.1, with the Sauter diameter
  double pressure_gradient;  ///< Kozeny-Carman, uncompressed bed [Pa/m]
  double pressure_drop;      ///< over the bed height [Pa]
};

struct BedFigures {
  double height;  ///< [m]
  double porosity;
  bool porosity_is_set;  ///< by a settle step; assumed otherwise
};

struct MeshFigures {
  mesh::CellCounts counts;
  double cell_across;  ///< square root of the mean area of cells seen from above [m]
  double cell_height;  ///< [m]
  mesh::MeshQuality quality;
};

struct CaseFigures {
  resin::SizeStatistics sizes = {};  ///< of real beads (of the grains, where a bead file has them)
  double largest_grain = 0.0;        ///< coarse_grain included [m]
  std::optional<BedFigures> bed;     ///< where a settle step says how high it will be
  double bead_count = 0.0;           ///< grains of the simulation
  double real_bead_count = 0.0;      ///< beads that they stand for
  double bead_mass = 0.0;            ///< of all beads, wet [kg]
  double bead_volume = 0.0;          ///< of all beads [m3]
  std::optional<double> submerged_weight;  ///< weight less buoyancy [N]; none when dry
  std::optional<FlowFigures> flow;         ///< where there is a bed, a liquid and a flow
  std::optional<MeshFigures> mesh;         ///< where there is a liquid
  dem::StepChoice step = {};               ///< of the beads, and what it rests on
  double run_time = 0.0;                   ///< simulated by steps that just run [s]
  double memory = 0.0;                     ///< of beads and contacts [B]
  double memory_with_frames = 0.0;         ///< while frames of a settled bed are written [B]
};

/// Particle-steps per second of one core, for the expected run time; docs/performance.md.
inline constexpr double expected_rate = 20e6;

/// Settled porosity where the case does not say: what the thesis's friction (0.1, rolling 0.35)
/// settles to in a bead simulation, 0.40-0.41.
inline constexpr double assumed_porosity = 0.40;

CaseFigures figures(const Case& c);

}  // namespace packbed::setup
