// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli.hpp"

namespace packbed::app {
namespace {

constexpr int most_points = 100000;

void add_options(CLI::App& c, WallSupportOptions& o) {
  c.add_option("--resin", o.resin, "Resin of the library, for all that follows and is not given");
  c.add_option("--library", o.library, "A library file of your own, added to ours");
  c.add_option("--B", o.modulus,
               "Modulus of the bed; with stiffening: that at the reference compression");
  c.add_option("--stiffening", o.stiffening, "constant (default), hertz (exponent 1.5) or power");
  c.add_option("--reference-compression", o.reference_compression,
               "hertz, power: where B holds; 0.05 if not given");
  c.add_option("--exponent", o.exponent, "power: stress ~ compression^exponent");
  c.add_option("--modulus-table", o.table,
               "CSV file with compression, modulus [MPa] instead of --B");
  c.add_option("--bead-diameter", o.bead_diameter, "Hydrodynamically relevant bead size");
  c.add_option("--wall-friction", o.wall_friction, "Friction of the bed at the wall");
  c.add_option("--poisson", o.poisson, "Poisson's ratio of the bed");
  c.add_option("--density-difference", o.density_difference,
               "Density of beads less that of the liquid");
  c.add_option("--settled-porosity", o.settled_porosity, "Porosity settled by gravity");
  c.add_option("--calibrated-compression", o.calibrated_compression,
               "Compression up to which the bed was calibrated");
  c.add_option("--viscosity", o.viscosity, "Of the liquid; 1 mPa s if not given");
  c.add_option("--temperature", o.temperature, "Water of this temperature instead");
  c.add_option("--reading", o.reading,
               "material (default): the height is that of the settled bed; fixed: that under flow");
}

void add_files(CLI::App& c, std::string& csv, std::string& plot, bool& json) {
  c.add_option("--csv", csv, "Write the rows to this file");
  c.add_option("--plot", plot, "Draw them to this file (SVG)");
  add_json(c, json);
}

void add_velocities(CLI::App& parent, WallSupportSweepCommand& o, Action& action) {
  auto* c = parent.add_subcommand("velocities", "Pressure drop and compression over the velocity");
  add_options(*c, o.options);
  c->add_option("--height", o.options.height, "Height of the bed, see --reading");
  c->add_option("--diameter", o.diameters, "Inner diameter of the column; repeat it")->take_all();
  c->add_option("--from", o.from, "Lowest velocity; 0 if not given");
  c->add_option("--to", o.to, "Highest velocity");
  c->add_option("--points", o.points, "Velocities")->check(CLI::Range(2, most_points));
  add_files(*c, o.csv, o.plot, o.json);
  c->callback([&] { action = [&] { return wall_support_velocities(o); }; });
}

void add_diameters(CLI::App& parent, WallSupportSweepCommand& o, Action& action) {
  auto* c = parent.add_subcommand(
      "diameters", "Pressure drop, compression and critical velocity over the diameter");
  add_options(*c, o.options);
  c->add_option("--height", o.options.height, "Height of the bed, see --reading");
  c->add_option("--velocity", o.velocity, "Superficial velocity");
  c->add_option("--diameter", o.diameters,
                "Inner diameters of columns; repeat it. By default a range")
      ->take_all();
  c->add_option("--from", o.from, "Smallest diameter; 1 cm if not given");
  c->add_option("--to", o.to, "Largest diameter; 2 m if not given");
  c->add_option("--points", o.points, "Diameters, at even ratios")
      ->check(CLI::Range(2, most_points));
  add_files(*c, o.csv, o.plot, o.json);
  c->callback([&] { action = [&] { return wall_support_diameters(o); }; });
}

void add_scale(CLI::App& parent, WallSupportSweepCommand& o, Action& action) {
  auto* c = parent.add_subcommand("scale", "Critical velocity x height over height / diameter");
  add_options(*c, o.options);
  c->add_option("--height", o.heights, "Height of the bed; repeat it")->take_all();
  c->add_option("--from", o.from, "Smallest diameter; 1 cm if not given");
  c->add_option("--to", o.to, "Largest diameter; 2 m if not given");
  c->add_option("--points", o.points, "Diameters, at even ratios")
      ->check(CLI::Range(2, most_points));
  add_files(*c, o.csv, o.plot, o.json);
  c->callback([&] { action = [&] { return wall_support_scale(o); }; });
}

void add_fit(CLI::App& parent, WallSupportFitCommand& o, Action& action) {
  auto* c = parent.add_subcommand("fit", "Fit the bed to measured pressure drops and compressions");
  c->add_option(
       "DATA", o.file,
       "CSV file with diameter [mm], velocity [cm/h], pressure_gradient [bar/m], compression")
      ->required();
  add_options(*c, o.options);
  c->add_option("--height", o.options.height, "Settled height, if the data have no column of it");
  c->add_option("--free", o.free,
                "What to fit, with commas: B, bead-diameter, wall-friction, poisson, "
                "density-difference, settled-porosity, exponent");
  c->add_option("--bound", o.bounds, "Bounds of a free parameter, \"B=10 kPa:1 MPa\"; repeat it")
      ->take_all();
  c->add_option("--starts", o.starts, "Starts of the search")->check(CLI::Range(1, 1000));
  c->add_option(
      "--intervals", o.intervals,
      "linear (default), or profile: right where the data hardly determine a figure; takes "
      "longer");
  c->add_option("--plot", o.plot, "Draw data and model to this file (SVG)");
  add_json(*c, o.json);
  c->callback([&] { action = [&] { return wall_support_fit(o); }; });
}

}  // namespace

void add_wall_support(CLI::App& app, WallSupportCommands& all, Action& action) {
  auto& o = all.one;
  auto* c = app.add_subcommand(
      "wall-support", "Bed under flow in a column, carried in part by the wall (one-dimensional)");
  add_options(*c, o.options);
  c->add_option("--height", o.options.height, "Height of the bed, see --reading");
  c->add_option("--diameter", o.diameter, "Inner diameter of the column");
  c->add_flag("--no-wall", o.no_wall, "A column so wide that the wall does not count");
  c->add_option("--velocity", o.velocity, "Superficial velocity");
  c->add_option("--points", o.points, "Rows of the profile")->check(CLI::Range(2, most_points));
  add_files(*c, o.csv, o.plot, o.json);
  add_velocities(*c, all.velocities, action);
  add_diameters(*c, all.diameters, action);
  add_scale(*c, all.scale, action);
  add_fit(*c, all.fit, action);
  c->callback([c, &o, &action] {
    if (c->get_subcommands().empty()) action = [&] { return wall_support(o); };
  });
}

}  // namespace packbed::app
