// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "report/run_data.hpp"

namespace packbed::report {

struct KeyFigure {
  std::string name;
  std::string value;  ///< with its unit; empty where the run does not have it
  std::string note = {};
};

/// The same figures in the same order for every run.
std::vector<KeyFigure> key_figures(const RunData& run);

/// Wall time of a part of a stage.
struct StageTime {
  std::string stage;   ///< "2, flow_ramp"
  double beads = 0.0;  ///< [s]
  double coupling = 0.0;
  double liquid = 0.0;
  double outputs = 0.0;
  double all = 0.0;
};
/// Empty where the run did not write them.
std::vector<StageTime> stage_times(const RunData& run);

}  // namespace packbed::report
