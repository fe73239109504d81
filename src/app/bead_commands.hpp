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
  std::string intervals = "linear";
  std::string plot;
  bool json = false;
};
int bead_fit(const BeadFitCommand& command);

/// `packbed bead sizes`.
struct BeadSizesCommand {
  std::string file, bin, csv, plot;
  bool json = false;
};
int bead_sizes(const BeadSizesCommand& command);

/// `packbed bead properties`: works out what the options given allow.
struct BeadPropertiesCommand {
  std::string intraparticle_porosity, dry_density, liquid_density;  // wet density
  std::string pore_radius, shear_modulus, poisson, viscosity;       // permeability, diffusivity
  std::string radius, height, compressed_radius;                    // Poisson's ratio from pictures
  bool json = false;
};
int bead_properties(const BeadPropertiesCommand& command);

/// `packbed bead xray`.
struct BeadXrayCommand {
  std::string file, intraparticle_porosity, dry_density, liquid_density, thickness, csv, plot;
  bool json = false;
};
int bead_xray(const BeadXrayCommand& command);

/// All of them, for the command line to fill.
struct BeadCommands {
  BeadCurveCommand compress, relax;
  BeadFitCommand fit;
  BeadSizesCommand sizes;
  BeadPropertiesCommand properties;
  BeadXrayCommand xray;
};

}  // namespace packbed::app
