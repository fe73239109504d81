// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The frames of a run that has ended, and what its tables say of the instants at which they were taken.

#include <filesystem>
#include <optional>
#include <vector>

#include "analysis/sections.hpp"
#include "core/quantity.hpp"
#include "mesh/column_shape.hpp"
#include "report/run_data.hpp"

namespace packbed::app {

/// A frame and its place in the run.
struct RunFrame {
  std::size_t number = 0;  ///< of its files
  double time = 0.0;       ///< [s]
  std::size_t row = 0;     ///< of series.csv, the last one that is not later
  int stage = 0;           ///< from 1; 0: the start
  bool ends_stage = false;
  std::filesystem::path beads;
  std::filesystem::path contacts;
  std::optional<std::filesystem::path> liquid;
};

// NOLINTNEXTLINE(bugprone-exception-escape): as that of RunData.
struct RunFrames {
  report::RunData run;
  mesh::ColumnShape shape;
  std::vector<RunFrame> frames;  ///< all, in their order
};

/// Throws DataError, on one line, if the folder has no run that has ended, no bed or no frames, or if something in
/// it is damaged.
RunFrames read_run_frames(const std::filesystem::path& folder, const UnitSystem& units);

/// Of each stage the last frame of a bed that is there: that at its end, or the nearest before it where frames were
/// written by time.
std::vector<RunFrame> frames_at_stage_ends(const RunFrames& all);

/// "flow_ramp"; "start" before the first stage.
std::string stage_name(const report::RunData& run, int stage);

/// The stage at whose end packing is over: the last "compress", "relax", "flow_pack" or "store", else the last
/// "settle" or "tap", else the start, 0.
int packing_end(const report::RunData& run);

/// The material sections at this time of a row [s]; none where the run wrote none.
std::vector<analysis::Section> sections_at(const report::RunData& run, double time);
/// At the end of a stage.
std::vector<analysis::Section> sections_after(const report::RunData& run, int stage);

}  // namespace packbed::app
