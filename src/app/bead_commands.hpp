// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The commands of `packbed bead`. Like those of commands.hpp: print, throw Error, return the shell's code.

#include <string>
#include <vector>

#include "app/bead_model.hpp"

namespace packbed::app {

/// `packbed bead compress` and `packbed bead relax`.
struct BeadCurveCommand {
  BeadOptions bead;
  std::string speed, time, depth, hold;
  bool unload = false;
  int points = 501;
  std::string csv, plot;  ///< files to write; empty: none
  bool json = false;
};
int bead_compress(const BeadCurveCommand& command);
int bead_relax(const BeadCurveCommand& command);

/// All of them, for the command line to fill.
struct BeadCommands {
  BeadCurveCommand compress, relax;
};

}  // namespace packbed::app
