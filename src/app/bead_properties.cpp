// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/bead_commands.hpp"
#include "app/print.hpp"
#include "app/quantities.hpp"
#include "continuum/bead/attenuation.hpp"
#include "continuum/bead/swollen_bead.hpp"
#include "core/csv.hpp"
#include "core/error.hpp"
#include "io/plot.hpp"

namespace packbed::app {
namespace {

using Json = nlohmann::ordered_json;
using enum Dimension;
namespace bounds = setup::bounds;

constexpr setup::Bounds below_half{
    .low = -1.0,
    .high = 0.5,
    .refusal = "is outside (-1, 0.5), which the diffusion of liquid needs"};

int finish(const Json& j, bool as_json) {
  if (as_json) {
    fmt::print("{}", json_text(j));
  } else {
    for (const auto& [name, value] : j.items())
      fmt::print("{:<34} {:.6g}\n", name, value.get<double>());
  }
  return 0;
}

// Columns "energy [keV]", "matrix [cm2/g]", "liquid [cm2/g]", exactly so: nothing is converted but cm2/g.
struct AttenuationTable {
  std::vector<double> energy_kev, matrix, liquid;  // m2/kg
};

std::vector<double> exact_column(const CsvTable& table, const std::string& header) {
  const int column = table.find(header);
  if (column < 0) {
    throw ConfigError(
        fmt::format("{}: column \"{}\" is missing; the header must be \"energy [keV],matrix "
                    "[cm2/g],liquid [cm2/g]\"",
                    table.header_place(), header));
  }
  std::vector<double> values;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    values.push_back(table.number(row, column));
    if (!(values.back() > 0.0))
      throw ConfigError(fmt::format("{}: {} must be positive", table.place(row), header));
  }
  return values;
}

AttenuationTable read_attenuation(const std::string& file) {
  const CsvTable table(file);
  AttenuationTable t{exact_column(table, "energy [keV]"), exact_column(table, "matrix [cm2/g]"),
                     exact_column(table, "liquid [cm2/g]")};
  if (!std::ranges::is_sorted(t.energy_kev)) {
    throw ConfigError(fmt::format("{}: energies must ascend", file));
  }
  for (auto* column : {&t.matrix, &t.liquid}) {
    for (auto& v : *column) v *= 0.1;  // cm2/g in m2/kg
  }
  return t;
}

}  // namespace

int bead_properties(const BeadPropertiesCommand& c) {
  const UnitSystem units;
  const double rho_f =
      quantity_or(units, {"--liquid-density", c.liquid_density}, density, bounds::positive, 1000.0);
  const double mu_f =
      quantity_or(units, {"--viscosity", c.viscosity}, viscosity, bounds::positive, 1e-3);
  const auto eps = optional_quantity(units, {"--intraparticle-porosity", c.intraparticle_porosity},
                                     fraction, bounds::between_0_and_1);
  Json j = Json::object();
  if (!c.dry_density.empty()) {
    if (!eps)
      throw ConfigError(
          "--dry-density needs --intraparticle-porosity for the wet density (thesis eq. 5.1)");
    j["wet_density_kg_m3"] = continuum::wet_density(
        *eps, rho_f, quantity(units, {"--dry-density", c.dry_density}, density, bounds::positive));
  }
  if (!c.pore_radius.empty()) {
    if (!eps)
      throw ConfigError(
          "--pore-radius needs --intraparticle-porosity for the permeability (thesis eq. 3.36)");
    const double k = continuum::pore_permeability(
        *eps, quantity(units, {"--pore-radius", c.pore_radius}, length, bounds::positive));
    j["permeability_m2"] = k;
    if (!c.shear_modulus.empty()) {
      const double nu = quantity(units, {"--poisson", c.poisson}, fraction, below_half);
      j["poroelastic_diffusivity_m2_s"] = continuum::poroelastic_diffusivity(
          nu, quantity(units, {"--G", c.shear_modulus}, pressure, bounds::positive), k, mu_f);
    }
  }
  if (!c.height.empty() || !c.compressed_radius.empty()) {
    const double r = quantity(units, {"--radius", c.radius}, length, bounds::positive);
    const double h = quantity(units, {"--compressed-height", c.height}, length, bounds::positive);
    const double bulged =
        quantity(units, {"--compressed-radius", c.compressed_radius}, length, bounds::positive);
    if (h >= 2.0 * r)
      throw ConfigError(
          "--compressed-height must be below the diameter of the unloaded bead (2 --radius)");
    if (bulged < 0.5 * h)
      throw ConfigError("--compressed-radius must be at least half of --compressed-height");
    j["strain"] = (2.0 * r - h) / (2.0 * r);
    j["volume_share_kept"] =
        continuum::flattened_volume(bulged, h) / continuum::flattened_volume(r, 2.0 * r);
    if (const double kept = j["volume_share_kept"]; kept > 1.0) {
      throw ConfigError(
          fmt::format("the bead between the plates has {:.3f} times its volume before; a bead does "
                      "not grow when it is compressed: "
                      "measure --radius, --compressed-height and --compressed-radius again",
                      kept));
    }
    j["poisson_ratio"] = continuum::poisson_from_pictures(r, h, bulged);
  }
  if (j.empty()) {
    throw ConfigError(
        "nothing to work out; give --intraparticle-porosity with --dry-density or --pore-radius, "
        "or --radius with --compressed-height and --compressed-radius");
  }
  return finish(j, c.json);
}

int bead_xray(const BeadXrayCommand& c) {
  const UnitSystem units;
  const auto table = read_attenuation(c.file);
  const double eps = quantity(units, {"--intraparticle-porosity", c.intraparticle_porosity},
                              fraction, bounds::between_0_and_1);
  const double rho_dry =
      quantity(units, {"--dry-density", c.dry_density}, density, bounds::positive);
  const double rho_f =
      quantity_or(units, {"--liquid-density", c.liquid_density}, density, bounds::positive, 1000.0);
  const double thickness = quantity(units, {"--thickness", c.thickness}, length, bounds::positive);
  const double rho_p = continuum::wet_density(eps, rho_f, rho_dry);
  std::vector<std::vector<double>> columns{table.energy_kev, {}, {}, {}, {}};
  Json rows = Json::array();
  for (std::size_t i = 0; i < table.energy_kev.size(); ++i) {
    const double bead =
        continuum::bead_attenuation(eps, rho_f, rho_dry, table.liquid[i], table.matrix[i]);
    columns[1].push_back(bead);
    columns[2].push_back(continuum::absorbed_share(table.matrix[i], rho_dry, thickness));
    columns[3].push_back(continuum::absorbed_share(table.liquid[i], rho_f, thickness));
    columns[4].push_back(continuum::absorbed_share(bead, rho_p, thickness));
    rows.push_back({{"energy_keV", table.energy_kev[i]},
                    {"bead_mass_attenuation_m2_kg", bead},
                    {"absorbed_matrix", columns[2][i]},
                    {"absorbed_liquid", columns[3][i]},
                    {"absorbed_bead", columns[4][i]}});
  }
  write_csv(c.csv,
            {"energy_keV", "bead_mass_attenuation_m2_kg", "absorbed_matrix", "absorbed_liquid",
             "absorbed_bead"},
            columns);
  if (!c.plot.empty()) {
    io::PlotPanel panel{.title = "X-ray attenuation",
                        .x = {"photon energy [keV]", true},
                        .y = {"absorbed share"},
                        .series = {}};
    for (std::size_t k = 2; k < 5; ++k) {
      panel.series.push_back({.label = std::array{"matrix", "liquid", "wet bead"}[k - 2],
                              .x = table.energy_kev,
                              .y = columns[k]});
    }
    write_plot(c.plot, io::plot_svg({panel}, 1));
  }
  if (c.json) {
    fmt::print(
        "{}",
        json_text({{"wet_density_kg_m3", rho_p}, {"thickness_m", thickness}, {"rows", rows}}));
    return 0;
  }
  fmt::print("wet density {:.1f} kg/m3; absorbed share over {:.4g} mm of\n", rho_p,
             thickness * 1e3);
  fmt::print("{:>12} {:>10} {:>10} {:>10}   mu/rho of the bead [cm2/g]\n", "energy [keV]", "matrix",
             "liquid", "wet bead");
  for (std::size_t i = 0; i < table.energy_kev.size(); ++i) {
    fmt::print("{:>12.4g} {:>10.4f} {:>10.4f} {:>10.4f} {:>10.5g}\n", columns[0][i], columns[2][i],
               columns[3][i], columns[4][i], 10 * columns[1][i]);
  }
  return 0;
}

}  // namespace packbed::app
