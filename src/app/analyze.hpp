// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "app/analysis_files.hpp"
#include "core/quantity.hpp"

namespace packbed::app {

/// What an analysis has found and written.
struct RunAnalysis {
  std::vector<AnalysisRow> rows;
  int packing_end = 0;
  bool has_stress = true;  ///< false: frames of an older version
};

/// Analyzes these frames, in their order, and writes the tables into `output`. Throws DataError.
RunAnalysis analyze_frames(const RunFrames& run,
                           const std::vector<RunFrame>& frames,
                           const std::filesystem::path& output);

/// What a run does at its end: its frames at ends of stages, into its folder. Nothing where there is no bed.
void analyze_ended_run(const std::filesystem::path& folder, const UnitSystem& units);

}  // namespace packbed::app
