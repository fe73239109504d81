// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli.hpp"

namespace packbed::app {
namespace {

constexpr int most_points = 1000000;

void add_convert(CLI::App& flow_command, ConvertCommand& o, Action& action) {
  auto* c = flow_command.add_subcommand("convert", "One name of a compression into all others");
  c->add_option("--settled-porosity", o.settled_porosity, "Porosity of the settled bed");
  c->add_option("--compression", o.compression, "lambda = (H0 - H) / H0");
  c->add_option("--relative-to-packed", o.relative, "(H0 - H) / H");
  c->add_option("--factor", o.factor, "Compression factor H0 / H");
  c->add_option("--packing-factor", o.packing_factor, "Height of the consolidated bed over H");
  c->add_option("--consolidated", o.consolidated,
                "Compression of the consolidated bed; 0 if not given");
  c->add_option("--density", o.density, "Packing density 1 - eps");
  c->add_option("--porosity", o.porosity, "Porosity eps of the compressed bed");
  c->add_option("--settled-height", o.settled_height, "H0");
  c->add_option("--height", o.height, "H, with --settled-height");
  add_json(*c, o.json);
  c->callback([&] { action = [&] { return flow_convert(o); }; });
}

void add_wall(CLI::App& flow_command, WallProfileCommand& o, Action& action) {
  auto* c = flow_command.add_subcommand("wall", "Porosity over the distance from the wall");
  c->add_option("--diameter", o.diameter, "Inner diameter of the column");
  c->add_option("--bead-diameter", o.bead_diameter, "Diameter of the beads");
  c->add_option("--points", o.points, "Rows of the profile")->check(CLI::Range(2, most_points));
  c->add_option("--csv", o.csv, "Write the profile to this file");
  c->add_option("--plot", o.plot, "Draw it to this file (SVG)");
  add_json(*c, o.json);
  c->callback([&] { action = [&] { return flow_wall(o); }; });
}

}  // namespace

void add_flow(CLI::App& app, FlowCommands& all, Action& action) {
  auto& o = all.flow;
  auto* c = app.add_subcommand("flow", "Velocities, Reynolds numbers and pressure drop of a bed");
  c->add_option("--porosity", o.porosity, "Porosity of the bed");
  c->add_option("--sauter", o.sauter, "Sauter diameter of the beads");
  c->add_option("--sizes", o.sizes, "CSV file of measured diameters instead");
  c->add_option("--resin", o.resin, "Resin of the library instead");
  c->add_option("--velocity", o.velocity, "Superficial velocity");
  c->add_option("--flow-rate", o.flow_rate, "Flow rate instead, with --diameter");
  c->add_option("--diameter", o.diameter, "Inner diameter of the column");
  c->add_option("--height", o.height, "Height of the bed");
  c->add_option("--to", o.to, "Velocities from the one given to this one");
  c->add_option("--points", o.points, "How many of them")->check(CLI::Range(2, most_points));
  c->add_option("--viscosity", o.viscosity, "Of the liquid; 1 mPa s if not given");
  c->add_option("--liquid-density", o.density, "1000 kg/m3 if not given");
  c->add_option("--temperature", o.temperature, "Water of this temperature instead");
  c->add_option("--csv", o.csv, "Write the rows to this file");
  c->add_option("--plot", o.plot, "Draw the pressure gradients to this file (SVG)");
  add_json(*c, o.json);
  add_convert(*c, all.convert, action);
  add_wall(*c, all.wall, action);
  c->callback([c, &o, &action] {
    if (c->get_subcommands().empty()) action = [&] { return flow(o); };
  });
}

}  // namespace packbed::app
