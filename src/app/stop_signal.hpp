// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Ctrl-C, SIGTERM and, from the process that started the ranks, SIGUSR1: a run is asked to write a
/// checkpoint and to stop. A second signal ends it at once.

namespace packbed::app {

/// From now on signals ask for a stop.
void watch_stop_signals();

/// Whether this process was asked to stop.
bool stop_was_asked();

}  // namespace packbed::app
