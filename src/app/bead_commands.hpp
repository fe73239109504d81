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

/// `packbed bead fit`.
struct BeadFitCommand {
  std::vector<std::string> files;
  std::string model;
  std::string radius, poisson, density, characteristic_velocity;
  int terms = 0;  ///< prony: 0 chooses
  std::string ramp_time;
  std::string ramp_correction = "exact";
  std::string plot;
  bool json = false;
};
int bead_fit(const BeadFitCommand& command);

/// All of them, for the command line to fill.
struct BeadCommands {
  BeadCurveCommand compress, relax;
  BeadFitCommand fit;
};

}  // namespace packbed::app
