// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The commands of `packbed wall-support`.

#include <optional>
#include <string>
#include <vector>

#include "continuum/wall_support/wall_support.hpp"
#include "core/quantity.hpp"

namespace packbed::app {

/// The bed and column that the options describe, as the user wrote them. The library gives what is left out.
struct WallSupportOptions {
  std::string resin, library;
  std::string modulus, bead_diameter, wall_friction, poisson, density_difference, settled_porosity;
  std::string stiffening = "constant";
  std::string reference_compression, exponent, table;
  std::string calibrated_compression;
  std::string height, viscosity, temperature;
  std::string reading = "material";
};

struct WallSupportBed {
  continuum::CompressibleBed bed;
  continuum::WallSupportColumn column;  ///< without its diameter
  std::optional<double> calibrated;     ///< compression up to which the bed was calibrated
};
WallSupportBed read_wall_support(const WallSupportOptions& options, const UnitSystem& units);

/// `packbed wall-support`: one column at one velocity.
struct WallSupportCommand {
  WallSupportOptions options;
  std::string diameter, velocity;
  bool no_wall = false;
  int points = 101;
  std::string csv, plot;
  bool json = false;
};
int wall_support(const WallSupportCommand& command);

/// `packbed wall-support velocities | diameters | scale`.
struct WallSupportSweepCommand {
  WallSupportOptions options;
  std::vector<std::string> diameters, heights;
  std::string velocity, from, to;
  int points = 41;
  std::string csv, plot;
  bool json = false;
};
int wall_support_velocities(const WallSupportSweepCommand& command);
int wall_support_diameters(const WallSupportSweepCommand& command);
int wall_support_scale(const WallSupportSweepCommand& command);

/// `packbed wall-support fit`. The options of the bed are the start, and hold for what is not free.
struct WallSupportFitCommand {
  WallSupportOptions options;
  std::string file;
  std::string free = "B,bead-diameter,wall-friction,poisson,density-difference,settled-porosity";
  std::vector<std::string> bounds;  ///< "B=10 kPa:1 MPa"
  int starts = 8;
  std::string intervals = "linear";
  std::string plot;
  bool json = false;
};
int wall_support_fit(const WallSupportFitCommand& command);

struct WallSupportCommands {
  WallSupportCommand one;
  WallSupportSweepCommand velocities, diameters, scale;
  WallSupportFitCommand fit;
};

}  // namespace packbed::app
