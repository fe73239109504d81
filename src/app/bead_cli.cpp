// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli.hpp"

namespace packbed::app {
namespace {

constexpr int most_points = 1000000;

void add_bead_options(CLI::App& command, BeadOptions& o) {
  command.add_option("--model", o.model,
                     "hertz, hooke, sls-maxwell, sls-kelvin, prony or poroelastic");
  command.add_option("--radius", o.radius, "Radius of the unloaded bead");
  command.add_option("--poisson", o.poisson, "Poisson's ratio");
  command.add_option("--G0", o.g0,
                     "sls: shear modulus of the free spring; poroelastic: that of the bead");
  command.add_option("--G1", o.g1, "sls: shear modulus of the other spring");
  command.add_option("--eta", o.eta, "sls: viscosity of the dashpot");
  command.add_option("--C0", o.c0, "prony: constant term of 2 G(t)");
  command
      .add_option("--term", o.terms,
                  "prony: a term of 2 G(t), \"C,tau\" as in \"0.4 MPa,12 s\"; repeat it")
      ->delimiter('\0');
  command.add_option("--E", o.youngs_modulus, "hertz, hooke: Young's modulus");
  command.add_option("--density", o.density, "hooke: density of the wet bead");
  command.add_option("--characteristic-velocity", o.characteristic_velocity,
                     "hooke: the speed of collision that E belongs to");
  command.add_option("--pore-radius", o.pore_radius, "poroelastic: hydraulic radius of the pores");
  command.add_option("--intraparticle-porosity", o.intraparticle_porosity,
                     "poroelastic: of the bead");
  command.add_option("--viscosity", o.viscosity,
                     "poroelastic: of the liquid; 1 mPa s if not given");
}

void add_files(CLI::App& command, BeadCurveCommand& o) {
  command.add_option("--points", o.points, "Rows of the curve")->check(CLI::Range(2, most_points));
  command.add_option("--csv", o.csv, "Write the curve to this file");
  command.add_option("--plot", o.plot, "Draw the curve to this file (SVG)");
  add_json(command, o.json);
}

void add_compress(CLI::App& bead, BeadCurveCommand& o, Action& action) {
  auto* command = bead.add_subcommand(
      "compress", "Force of a bead between two plates that close at a constant speed");
  add_bead_options(*command, o.bead);
  command->add_option("--speed", o.speed, "Speed of one plate against the other");
  command->add_option("--time", o.time, "Time since first touch");
  auto* unload = command->add_flag("--unload", o.unload, "Open the plates again at the same speed");
  command->add_option("--hold", o.hold, "Time between closing and opening; 0 if not given")
      ->needs(unload);
  add_files(*command, o);
  command->callback([&] { action = [&] { return bead_compress(o); }; });
}

void add_relax(CLI::App& bead, BeadCurveCommand& o, Action& action) {
  auto* command = bead.add_subcommand("relax", "Force of a bead that is held between two plates");
  add_bead_options(*command, o.bead);
  command->add_option("--depth", o.depth, "Displacement of the plates while it is held");
  command->add_option("--speed", o.speed, "Speed at which the plates closed; a step if not given");
  command->add_option("--time", o.time, "Time since the plates stopped");
  add_files(*command, o);
  command->callback([&] { action = [&] { return bead_relax(o); }; });
}

void add_fit(CLI::App& bead, BeadFitCommand& o, Action& action) {
  auto* command = bead.add_subcommand("fit", "Fit a model to measured force curves of beads");
  command->add_option("DATA", o.files, "CSV files with time [s], displacement [um], force [uN]")
      ->required();
  command->add_option("--model", o.model,
                      "prony, sls-maxwell, sls-kelvin, hertz, hooke, power or restitution");
  command->add_option("--radius", o.radius,
                      "Radius of the beads, if the data have no column of it");
  command->add_option("--poisson", o.poisson, "Poisson's ratio");
  command->add_option("--terms", o.terms, "prony: relaxation times; by default chosen")
      ->check(CLI::Range(1, 4));
  command->add_option("--ramp-time", o.ramp_time,
                      "prony: duration of the loading; by default from the data");
  command->add_option("--ramp-correction", o.ramp_correction,
                      "prony: exact (default), mattice, thesis or none");
  command->add_option("--density", o.density, "hooke: density of the wet bead");
  command->add_option("--characteristic-velocity", o.characteristic_velocity,
                      "hooke: speed that E belongs to");
  command->add_option(
      "--intervals", o.intervals,
      "linear (default), or profile: right where the data hardly determine a figure; "
      "takes longer");
  command->add_option("--plot", o.plot, "Draw data, model and residuals to this file (SVG)");
  add_json(*command, o.json);
  command->callback([&] { action = [&] { return bead_fit(o); }; });
}

void add_sizes(CLI::App& bead, BeadSizesCommand& o, Action& action) {
  auto* command = bead.add_subcommand("sizes", "Size distribution of measured beads");
  command->add_option("DATA", o.file, "CSV file with diameter [um], and perhaps count")->required();
  command->add_option("--bin", o.bin, "Width of the bins; 5 um if not given");
  command->add_option("--csv", o.csv, "Write the bins to this file");
  command->add_option("--plot", o.plot, "Draw both distributions to this file (SVG)");
  add_json(*command, o.json);
  command->callback([&] { action = [&] { return bead_sizes(o); }; });
}

void add_properties(CLI::App& bead, BeadPropertiesCommand& o, Action& action) {
  auto* command = bead.add_subcommand(
      "properties",
      "Wet density, permeability and diffusivity of the pores, Poisson's ratio from pictures");
  command->add_option("--intraparticle-porosity", o.intraparticle_porosity, "Porosity of the bead");
  command->add_option("--dry-density", o.dry_density, "Density of the dry matrix");
  command->add_option("--liquid-density", o.liquid_density, "1000 kg/m3 if not given");
  command->add_option("--pore-radius", o.pore_radius, "Hydraulic radius of the pores");
  command->add_option("--G", o.shear_modulus, "Shear modulus of the bead");
  command->add_option("--poisson", o.poisson, "Poisson's ratio of the bead");
  command->add_option("--viscosity", o.viscosity, "Of the liquid; 1 mPa s if not given");
  command->add_option("--radius", o.radius, "Radius of the unloaded bead on the picture");
  command->add_option("--compressed-height", o.height, "Distance of the plates on the picture");
  command->add_option("--compressed-radius", o.compressed_radius,
                      "Largest radius between the plates");
  add_json(*command, o.json);
  command->callback([&] { action = [&] { return bead_properties(o); }; });
}

void add_xray(CLI::App& bead, BeadXrayCommand& o, Action& action) {
  auto* command =
      bead.add_subcommand("xray", "Attenuation of X-rays by matrix, liquid and wet beads");
  command->add_option("TABLE", o.file, "CSV file with energy [keV], matrix [cm2/g], liquid [cm2/g]")
      ->required();
  command->add_option("--intraparticle-porosity", o.intraparticle_porosity, "Porosity of the bead");
  command->add_option("--dry-density", o.dry_density, "Density of the dry matrix");
  command->add_option("--liquid-density", o.liquid_density, "1000 kg/m3 if not given");
  command->add_option("--thickness", o.thickness, "Way of the rays");
  command->add_option("--csv", o.csv, "Write the rows to this file");
  command->add_option("--plot", o.plot, "Draw them to this file (SVG)");
  add_json(*command, o.json);
  command->callback([&] { action = [&] { return bead_xray(o); }; });
}

}  // namespace

void add_json(CLI::App& command, bool& json) {
  command.add_flag("--json", json, "Print figures as JSON: SI, with units in the keys");
}

void add_bead(CLI::App& app, BeadCommands& o, Action& action) {
  auto* bead =
      app.add_subcommand("bead", "Mechanics of one bead: force curves, fits, sizes, properties");
  bead->require_subcommand(1);
  add_compress(*bead, o.compress, action);
  add_relax(*bead, o.relax, action);
  add_fit(*bead, o.fit, action);
  add_sizes(*bead, o.sizes, action);
  add_properties(*bead, o.properties, action);
  add_xray(*bead, o.xray, action);
}

}  // namespace packbed::app
