// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// From a case to the cloud that its first settle step starts from, and to the options of the steps
/// that settle and tap.

#include "column/protocol/settle.hpp"
#include "column/protocol/tap.hpp"
#include "setup/make_dem.hpp"

namespace packbed::setup {

/// Whether the beads are made by the program: no bead file, and a number of them is known.
bool makes_beads(const Case& c);

/// Whether the cloud may stand above the lid of the column, as the protocol begins with a settle step
/// (at the end of which the lid is put in).
bool settles_first(const Case& c);

/// Bead `id` of a case without a bead file, submerged; its diameter follows from (seed, id).
dem::BeadProperties bead_of(const Case& c, std::int64_t id);

/// The beads of `[beads] count` or of the first settle step, as a cloud: random, dense, at rest. Throws
/// ConfigError if no settle step comes first and the cloud is higher than the column.
std::vector<dem::BeadStart> make_cloud_beads(const Case& c);

/// `first` says that the bed is still a cloud: its lid is put in at the end.
column::SettleOptions settle_options(const Case& c,
                                     const Settle& settle,
                                     const dem::StepChoice& step,
                                     bool first);

/// To begin with: the next id is that behind the beads that were made.
column::SettleState settle_start(std::int64_t bead_count);

column::TapOptions tap_options(const Case& c, const Tap& tap, const dem::StepChoice& step);

}  // namespace packbed::setup
