// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// What the analyses (analysis/) say of one frame of a run.

#include <optional>
#include <span>
#include <vector>

#include "analysis/bead.hpp"
#include "analysis/contact_force.hpp"
#include "analysis/force_directions.hpp"
#include "analysis/force_distribution.hpp"
#include "analysis/granular_temperature.hpp"
#include "analysis/profile.hpp"
#include "analysis/stress_profile.hpp"
#include "analysis/velocity_variance.hpp"
#include "app/run_frames.hpp"

namespace packbed::app {

/// A frame as the analyses take it.
struct BedFrame {
  RunFrame place;
  std::vector<analysis::Bead> beads;
  std::vector<analysis::MovingBead> motion;  ///< one per bead
  std::vector<analysis::ContactForce> contacts;
  std::vector<Vec3> tangential;              ///< on beads i, one per contact [N]; empty if unknown
  std::vector<analysis::LiquidCell> liquid;  ///< empty where nothing flows
  double diameter = 0.0;                     ///< mean of the grains' number [m]
};
/// Throws DataError for files that are missing or damaged.
BedFrame read_frame(const RunFrame& frame);

/// A row of analysis.csv; NaN where the run does not have it. docs/manual/analyze.md tells what each one is.
struct FrameFigures {
  double superficial_velocity = report::unknown;
  double pressure_drop = report::unknown;
  double bed_height = report::unknown;
  double compression = report::unknown;
  double mean_porosity = report::unknown;
  double s_mean = report::unknown;
  double s_init = report::unknown;
  double coordination = report::unknown;
  double coordination_without_rattlers = report::unknown;
  double rattler_share = report::unknown;
  double mean_force = report::unknown;
  double share_above_6 = report::unknown;
  double strong_load = report::unknown;
  double tail_slope = report::unknown;
  double fabric_anisotropy = report::unknown;
  double force_anisotropy = report::unknown;
  double axial_to_lateral = report::unknown;
  double stress_top = report::unknown;
  double stress_middle = report::unknown;
  double stress_bottom = report::unknown;
  double lateral_ratio = report::unknown;
  double wall_share = report::unknown;
  double bulk_porosity = report::unknown;
  double ipd_signed = report::unknown;    ///< [m]
  double ipd_absolute = report::unknown;  ///< [m]
  double ipd_signed_d = report::unknown;
  double ipd_absolute_d = report::unknown;
  double velocity_variance = report::unknown;
  double velocity_variation = report::unknown;
  double granular_temperature = report::unknown;
  double mean_overlap = report::unknown;
  double largest_overlap = report::unknown;
  double large_overlaps = report::unknown;
  double very_large_overlaps = report::unknown;
  double void_d10 = report::unknown;
  double void_d50 = report::unknown;
  double d_over_d_eff = report::unknown;
};

/// A column of analysis.csv.
struct FigureColumn {
  const char* name;
  double FrameFigures::*value;
};
std::span<const FigureColumn> figure_columns();

/// All of a frame: its row and its tables.
struct FrameAnalysis {
  FrameFigures figures;
  analysis::ForceDistribution forces;
  std::vector<analysis::DirectionBin> angles;
  std::vector<analysis::StressBin> stress;           ///< empty where tangential forces are unknown
  std::optional<analysis::Profile> wall_porosity;    ///< where there are side walls
  std::vector<analysis::VelocityBin> wall_velocity;  ///< likewise, where there is a liquid
};

/// `initial`: the sections when packing was over.
FrameAnalysis analyze_frame(const RunFrames& run,
                            const BedFrame& frame,
                            std::span<const analysis::Section> initial);

}  // namespace packbed::app
