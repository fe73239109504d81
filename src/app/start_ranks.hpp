// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/commands.hpp"

namespace packbed::app {

/// Ranks that serve a run of so many grains: physical cores, fewer for few grains.
int useful_ranks(double grains);

/// Starts the run again under mpiexec and waits for it; the first Ctrl-C or SIGTERM asks all ranks to
/// write a checkpoint and stop, the second ends them. Returns the exit code of the run. Throws
/// DataError if mpiexec cannot be started.
int run_on_ranks(int ranks, const RunCommand& command);

}  // namespace packbed::app
