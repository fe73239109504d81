// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The protocol of a case as a row of stages: repeats unrolled, each stage made when it is its turn.

#include <cstdint>
#include <memory>

#include "column/coupled_bed.hpp"
#include "column/protocol/stage.hpp"
#include "dem/step_choice.hpp"
#include "setup/case.hpp"
#include "setup/make_packing.hpp"

namespace packbed::app {

/// How many stages there are; at most the largest number that can be counted.
std::int64_t stage_count(const setup::Case& c);

/// Whether any stage has a flow of liquid.
bool has_flow(const setup::Case& c);
/// Whether stage k has, or stands in a liquid that flowed before it.
bool has_flow(const setup::Case& c, std::int64_t k);
/// Whether stage k moves the plunger.
bool moves_plunger(const setup::Case& c, std::int64_t k);
/// Whether any does.
bool any_plunger(const setup::Case& c);

/// Stage k, not begun. `bed`: as it is when the stage begins. `step` as setup::step_of says; `liquid` where there is a flow, else not looked at.
std::unique_ptr<column::Stage> make_stage(const setup::Case& c,
                                          std::int64_t k,
                                          const setup::PackedBed& bed,
                                          const dem::StepChoice& step,
                                          column::CoupledBed* liquid);

/// Time steps of all stages, those of settling as they are on the average; a double, as there may be
/// any number. For progress lines.
double expected_steps(const setup::Case& c, double step);
/// Of stage k.
double expected_steps(const setup::Case& c, std::int64_t k, double step);

/// Whether this version can carry the whole protocol out.
bool can_simulate(const setup::Case& c);

}  // namespace packbed::app
