// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The state of the beads in a checkpoint, folder "dem". What each array is: docs/manual/output-files.md.

#include "dem/state.hpp"
#include "io/checkpoint.hpp"

namespace packbed::io {

/// Collective. `share`: that of this rank.
void write_dem_state(CheckpointWriter& writer, const dem::DemState& share);

/// The state of all ranks, on every rank. `walls` as the case makes them; places, velocities and friction
/// come from the checkpoint. Throws DataError if something is missing.
dem::DemState read_dem_state(const CheckpointReader& reader, std::vector<dem::Wall> walls);

}  // namespace packbed::io
