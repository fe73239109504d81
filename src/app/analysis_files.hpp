// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The tables of an analysis, as docs/manual/analyze.md tells.

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/rearrangement.hpp"
#include "app/frame_figures.hpp"

namespace packbed::app {

/// A row of analysis.csv.
struct AnalysisRow {
  RunFrame frame;
  std::string stage_name;
  FrameFigures figures;
};

/// A row of rearrangement.csv: what happened between two frames.
struct RearrangementRow {
  std::size_t from = 0;  ///< frame
  std::size_t to = 0;
  double from_time = 0.0;  ///< [s]
  double to_time = 0.0;    ///< [s]
  double diameter = 0.0;   ///< mean, of the first frame [m]
  std::int64_t beads = 0;  ///< of both frames
  std::int64_t gone = 0;
  std::int64_t come = 0;
  double lateral = 0.0;     ///< root mean square beyond the motion of the bed [m]
  double vertical = 0.0;    ///< [m]
  double non_affine = 0.0;  ///< root of the mean D^2_min [m]
  std::int64_t left_out = 0;
  analysis::ContactChanges contacts;
};

/// An earlier analysis in the folder is taken away, nothing else; the folder is made. DataError if that fails.
void prepare_analysis_folder(const std::filesystem::path& folder);
/// forces_N.csv, angles_N.csv and whichever else the frame has.
void write_frame_tables(const std::filesystem::path& folder,
                        std::size_t number,
                        const FrameAnalysis& analysis);
/// analysis.csv. `packing_end`: the stage against whose end S_init is taken.
void write_analysis(const std::filesystem::path& folder,
                    const std::vector<AnalysisRow>& rows,
                    int packing_end);
/// rearrangement.csv, if there is a row.
void write_rearrangement(const std::filesystem::path& folder,
                         const std::vector<RearrangementRow>& rows);

/// The same rows; what is not known is null.
nlohmann::ordered_json to_json(const std::vector<AnalysisRow>& rows, int packing_end);

}  // namespace packbed::app
