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

namespace packbed::app {

/// How many stages there are; at most the largest number that can be counted.
std::int64_t stage_count(const setup::Case& c);

/// Step of the protocol that stage k is, from 0.
const setup::ProtocolStep& protocol_step(const setup::Case& c, std::int64_t k);

/// Whether any stage has a flow of liquid.
bool has_flow(const setup::Case& c);
/// Whether stage k has.
bool has_flow(const setup::Case& c, std::int64_t k);

/// Stage k, not begun. `step` as setup::step_of says; `liquid` where there is a flow, else not looked at.
std::unique_ptr<column::Stage> make_stage(const setup::Case& c,
                                          std::int64_t k,
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
