// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// From a case to the liquid, its coupling with the beads, and the options of the steps with a flow.

#include "column/coupled_bed.hpp"
#include "column/protocol/flow_stage.hpp"
#include "dem/step_choice.hpp"
#include "setup/case.hpp"

namespace packbed::setup {

/// Of a case with a liquid.
column::CoupledOptions coupled_options(const Case& c);

/// The liquid of a case, at rest.
column::CoupledBed make_coupled_bed(const Case& c, std::optional<double> top, const Ranks& ranks);

/// Options of a stage that drives the bed, with the common part filled in.
template <class Options>
Options with(const column::DriveOptions& common) {
  Options options;
  static_cast<column::DriveOptions&>(options) = common;
  return options;
}

/// How a step that drives the bed steps it, with or without a liquid. `step` as setup::step_of says.
column::DriveOptions drive_options(const Case& c, const dem::StepChoice& step);
/// Of a step "flow_ramp". `step` as setup::step_of says.
column::FlowOptions flow_options(const Case& c, const FlowRamp& ramp, const dem::StepChoice& step);
/// Of a step "hold"; `flow`: the velocity before it [m/s].
column::FlowOptions flow_options(const Case& c,
                                 const Hold& hold,
                                 double flow,
                                 const dem::StepChoice& step);

}  // namespace packbed::setup
