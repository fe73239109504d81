// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The state of the liquid in a checkpoint, folder "liquid": cells and faces by their numbers in the
/// whole mesh.

#include "fluid/fluid_state.hpp"
#include "io/checkpoint.hpp"

namespace packbed::app {

/// Collective. `state`: that of this rank; the file has the cells and faces of all in their order.
void write_fluid_state(io::CheckpointWriter& writer, const fluid::FluidState& state);

/// Whether the checkpoint has a liquid.
bool has_fluid_state(const io::CheckpointReader& reader);
/// The state of all ranks, on every rank.
fluid::FluidState read_fluid_state(const io::CheckpointReader& reader);

}  // namespace packbed::app
