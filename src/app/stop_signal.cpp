// SPDX-License-Identifier: BSD-3-Clause
#include "app/stop_signal.hpp"

#include <array>
#include <csignal>

namespace packbed::app {
namespace {

volatile std::sig_atomic_t asked = 0;  // NOLINT: what a signal handler may write

// The second of the same kind meets the system's own answer.
extern "C" void ask(int signal) {
  asked = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void watch_stop_signals() {
  for (const int signal : std::array{SIGINT, SIGTERM, SIGUSR1}) std::signal(signal, ask);
}

bool stop_was_asked() { return asked != 0; }

}  // namespace packbed::app
