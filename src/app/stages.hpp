// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The protocol of a case as a row of stages: repeats unrolled, each stage made when it is its turn.

#include <cstdint>
#include <memory>

#include "column/protocol/stage.hpp"
#include "setup/case.hpp"

namespace packbed::app {

/// How many stages there are; at most the largest number that can be counted.
std::int64_t stage_count(const setup::Case& c);

/// Step of the protocol that stage k is, from 0.
const setup::ProtocolStep& protocol_step(const setup::Case& c, std::int64_t k);

/// Stage k, not begun. `step` is the recommended time step of the beads [s].
std::unique_ptr<column::Stage> make_stage(const setup::Case& c, std::int64_t k, double step);

/// Time steps of all stages, as far as they are known before; a double, as there may be any number.
double expected_steps(const setup::Case& c, double step);
/// Of stage k.
double expected_steps(const setup::Case& c, std::int64_t k, double step);

/// Whether this version can carry the whole protocol out.
bool can_simulate(const setup::Case& c);

}  // namespace packbed::app
