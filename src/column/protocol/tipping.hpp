// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Beads that have begun to slide or roll off others while the rest of the bed stands. From a balance that is
/// not stable they leave as exp(t / tau), tau being 5 ms dry and up to 50 ms in a liquid that bears them: the
/// last bits of a motion would decide how long a bed takes to come to rest. They are pushed on.
/// Text: docs/theory/settling.md, "Tipping".

#include <cstdint>
#include <vector>

#include "dem/dem.hpp"

namespace packbed::column {

struct TippingLimits {
  double slowest = 0.0;  ///< speed below which a bead counts as at rest [m/s]
  double speed = 0.0;    ///< that it is given [m/s]
};

/// The beads that tip: slow, yet far faster than the bed; faster than a moment before; and driven by a force
/// that has grown on the way. A bead that comes to rest, or swings in a hollow, is driven less and less.
/// Both looks are at the same beads; what is returned are the velocities to give. On rank 0.
std::vector<dem::NewVelocity> tipping_beads(const dem::Snapshot& before,
                                            const dem::Snapshot& now,
                                            const TippingLimits& limits);

/// Gives them these velocities and returns how many they are. All ranks call it.
std::int64_t push_tipping_beads(const dem::Snapshot& before,
                                const dem::Snapshot& now,
                                const TippingLimits& limits,
                                dem::Dem& dem);

}  // namespace packbed::column
