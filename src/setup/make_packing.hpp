// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Options of the steps that pack a bed and load it: those of the plunger, flow packing, cycles, storage.

#include "column/protocol/flow_stage.hpp"
#include "column/protocol/plunger_stage.hpp"
#include "dem/step_choice.hpp"
#include "setup/case.hpp"

namespace packbed::setup {

/// The bed that compressions are told against.
struct PackedBed {
  double settled_height = 0.0;  ///< H0; 0: no bed has settled yet [m]
  double height = 0.0;          ///< now [m]
};

/// Of a move. `step` as setup::step_of says. Throws ConfigError for a compression without a settled bed.
column::PlungerOptions plunger_options(const Case& c,
                                       const PlungerMove& move,
                                       bool goes_up,
                                       const PackedBed& bed,
                                       const dem::StepChoice& step);

/// The parts of a step "flow_pack": the flow; the plunger that comes down on the bed; the end of the flow.
column::FlowOptions packing_flow(const Case& c,
                                 const FlowPack& pack,
                                 const PackedBed& bed,
                                 const dem::StepChoice& step);
column::PlungerOptions packing_plunger(const Case& c,
                                       const FlowPack& pack,
                                       const PackedBed& bed,
                                       const dem::StepChoice& step);
column::FlowOptions packing_end(const Case& c, const FlowPack& pack, const dem::StepChoice& step);

/// One half of a cycle.
column::FlowOptions cycle_options(const Case& c,
                                  const Cycle& cycle,
                                  bool high,
                                  const dem::StepChoice& step);

column::FlowOptions store_options(const Case& c, const Store& store, const dem::StepChoice& step);

}  // namespace packbed::setup
