// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The commands of `packbed flow`: correlations of a bed that is not compressed by the flow.

#include <string>

namespace packbed::app {

/// `packbed flow`
struct FlowCommand {
  std::string porosity, sauter, sizes, resin;  // bed; one of the last three
  std::string velocity, flow_rate, diameter, height;
  std::string to;  // up to this velocity, in `points` steps
  int points = 11;
  std::string viscosity, density, temperature;  // liquid
  std::string csv, plot;
  bool json = false;
};
int flow(const FlowCommand& command);

/// `packbed flow convert`: one name of a compression into all others.
struct ConvertCommand {
  std::string settled_porosity;
  std::string compression, relative, factor, packing_factor, density, porosity;  // exactly one
  std::string consolidated;            // compression at which the bed was consolidated
  std::string settled_height, height;  // optional; height may be the one given
  bool json = false;
};
int flow_convert(const ConvertCommand& command);

/// `packbed flow wall`: porosity near the wall.
struct WallProfileCommand {
  std::string diameter, bead_diameter, csv, plot;
  int points = 201;
  bool json = false;
};
int flow_wall(const WallProfileCommand& command);

struct FlowCommands {
  FlowCommand flow;
  ConvertCommand convert;
  WallProfileCommand wall;
};

}  // namespace packbed::app
