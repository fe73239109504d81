// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Beads put into a bed and taken out of it while it settles. The Dem is made anew from its edited
/// state; springs of beads that stay are kept. All ranks call these functions.

#include "column/protocol/settle.hpp"

namespace packbed::column {

/// Puts a small cloud of dry beads above `low` [m], ids from `next_id` on, of solid volume `volume`
/// [m3] or a little more. Returns the next id after them.
std::int64_t add_beads(
    const SettleOptions& options, double low, double volume, std::int64_t next_id, dem::Dem& dem);

/// Takes the highest beads away, down to `volume` [m3] or a little more.
void remove_highest(double volume, dem::Dem& dem);

/// Lifts all beads into a new cloud, at rest and without springs; `number` makes it another one.
void make_new_cloud(const SettleOptions& options, std::uint64_t number, dem::Dem& dem);

}  // namespace packbed::column
