// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Readers of the steps of a protocol, one per kind, and what they share.

#include "setup/read_sections.hpp"

namespace packbed::setup {

/// What the steps read so far leave to the next one.
struct StepContext {
  const ColumnOptions& column;
  bool has_liquid = false;
  bool beads_are_counted = false;  ///< by [beads] or an earlier settling
  bool in_repeat = false;
};

Settle read_settle(Section& section, StepContext& context);
Tap read_tap(Section& section, const StepContext& context);
FlowRamp read_flow_ramp(Section& section, const StepContext& context);
Hold read_hold(Section& section, const StepContext& context);
FlowPack read_flow_pack(Section& section, const StepContext& context);
Cycle read_cycle(Section& section, const StepContext& context);
Store read_store(Section& section, const StepContext& context);
Compress read_compress(Section& section, const StepContext& context);
Relax read_relax(Section& section, const StepContext& context);

/// Refuses a plunger where z is periodic or open.
void require_plunger(const Section& section, const StepContext& context);

}  // namespace packbed::setup
