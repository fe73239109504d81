// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "app/flow_commands.hpp"
#include "app/library.hpp"
#include "app/liquid.hpp"
#include "app/print.hpp"
#include "app/quantities.hpp"
#include "continuum/correlations.hpp"
#include "continuum/wall_porosity.hpp"
#include "core/csv.hpp"
#include "core/error.hpp"
#include "io/plot.hpp"
#include "resin/size_statistics.hpp"
#include "setup/data_columns.hpp"

namespace packbed::app {
namespace {

using Json = nlohmann::ordered_json;
using enum Dimension;
namespace bounds = setup::bounds;

constexpr double cm_h = 0.01 / 3600.0;  // in m/s

/// A bed, its liquid, and where known column and height.
struct Bed {
  double eps = 0.0;  ///< porosity
  double d32 = 0.0;  ///< [m]
  Liquid liquid = {};
  std::optional<double> diameter, height;
};

double sauter_diameter(const FlowCommand& c, const UnitSystem& units) {
  const int given = static_cast<int>(!c.sauter.empty()) + static_cast<int>(!c.sizes.empty()) +
                    static_cast<int>(!c.resin.empty());
  if (given != 1) {
    throw ConfigError(
        "give the size of the beads by one of --sauter (\"93 um\"), --sizes (a CSV file) and "
        "--resin (a name)");
  }
  if (!c.sauter.empty()) return quantity(units, {"--sauter", c.sauter}, length, bounds::positive);
  if (!c.sizes.empty()) {
    const CsvTable table(c.sizes);
    return resin::statistics(
               resin::Measured::from(
                   setup::DataColumns(table, units, "diameter [um]").values("diameter", length)))
        .sauter;
  }
  const auto library = setup::builtin_library(units);
  return property(find_resin(library, c.resin), "sauter_diameter", "--sauter");
}

Json row(const Bed& bed, double u) {
  const auto& [rho, mu] = bed.liquid;
  const double re = continuum::particle_reynolds(rho, u, bed.d32, mu);
  Json j{{"superficial_velocity_m_s", u}, {"interstitial_velocity_m_s", u / bed.eps}};
  if (bed.diameter)
    j["flow_rate_m3_s"] = u * std::numbers::pi / 4.0 * *bed.diameter * *bed.diameter;
  j["reynolds_particle"] = re;
  j["reynolds_solid"] = continuum::solid_reynolds(rho, u, bed.d32, mu, bed.eps);
  j["reynolds_pore"] = continuum::bed_reynolds(rho, u, bed.d32, mu, bed.eps);
  j["regime"] = continuum::flow_regime(re);
  const double kc = continuum::kozeny_carman_gradient(bed.eps, bed.d32, mu, u);
  const double bk = continuum::blake_kozeny_gradient(bed.eps, bed.d32, mu, u);
  const double ergun = continuum::ergun_gradient(bed.eps, bed.d32, rho, mu, u);
  j["kozeny_carman_Pa_m"] = kc;
  j["blake_kozeny_Pa_m"] = bk;
  j["ergun_Pa_m"] = ergun;
  if (bed.height) {
    j["kozeny_carman_Pa"] = kc * *bed.height;
    j["blake_kozeny_Pa"] = bk * *bed.height;
    j["ergun_Pa"] = ergun * *bed.height;
  }
  return j;
}

double velocity_of(const FlowCommand& c,
                   const UnitSystem& units,
                   const std::optional<double>& diameter) {
  if (c.velocity.empty() == c.flow_rate.empty()) {
    throw ConfigError(
        "give one of --velocity (superficial, \"300 cm/h\") and --flow-rate (\"2 L/h\", with "
        "--diameter)");
  }
  if (!c.velocity.empty())
    return quantity(units, {"--velocity", c.velocity}, velocity, bounds::not_negative);
  if (!diameter) throw ConfigError("--flow-rate needs --diameter, that of the column");
  return quantity(units, {"--flow-rate", c.flow_rate}, volume_flow, bounds::not_negative) /
         (std::numbers::pi / 4.0 * *diameter * *diameter);
}

void print(const Json& j, const Bed& bed) {
  fmt::print("{:<34} {:.4f}\n{:<34} {:.3f} um\n", "porosity", bed.eps, "Sauter diameter",
             bed.d32 * 1e6);
  fmt::print("{:<34} {:.2f} kg/m3, {:.4f} mPa s\n", "liquid", bed.liquid.density,
             bed.liquid.viscosity * 1e3);
  fmt::print("{:<34} {:.5g} m2\n", "permeability (Kozeny-Carman)",
             continuum::kozeny_carman_permeability(bed.eps, bed.d32));
  for (const auto& r : j) {
    const auto value = [&](const char* key) { return r[key].get<double>(); };
    fmt::print("\n{:<34} {:.2f} cm/h\n{:<34} {:.2f} cm/h\n", "superficial velocity",
               value("superficial_velocity_m_s") / cm_h, "interstitial velocity",
               value("interstitial_velocity_m_s") / cm_h);
    if (bed.diameter)
      fmt::print("{:<34} {:.5g} L/h\n", "flow rate", value("flow_rate_m3_s") * 3.6e6);
    fmt::print("{:<34} {:.4g} ({})\n{:<34} {:.4g}\n{:<34} {:.4g}\n", "Re_p",
               value("reynolds_particle"), r["regime"].get<std::string>(),
               "Re_B = Re_p / (1 - eps)", value("reynolds_solid"), "Re_B' = Re_p / eps",
               value("reynolds_pore"));
    for (const auto& [key, name] : {std::pair{"kozeny_carman", "Kozeny-Carman (180)"},
                                    {"blake_kozeny", "Blake-Kozeny (150)"},
                                    {"ergun", "Ergun"}}) {
      fmt::print("{:<34} {:.5g} bar/m", name, value(fmt::format("{}_Pa_m", key).c_str()) * 1e-5);
      if (bed.height) fmt::print(", {:.5g} bar", value(fmt::format("{}_Pa", key).c_str()) * 1e-5);
      fmt::print("\n");
    }
  }
}

std::vector<double> column(const Json& rows, const char* key, double factor = 1.0) {
  std::vector<double> values;
  for (const auto& r : rows) values.push_back(r[key].get<double>() * factor);
  return values;
}

void write_files(const FlowCommand& c, const Json& rows) {
  const auto u = column(rows, "superficial_velocity_m_s");
  if (!c.csv.empty()) {
    std::vector<std::string> header;
    std::vector<std::vector<double>> columns;
    for (const auto& [key, value] : rows.front().items()) {
      if (!value.is_number()) continue;
      header.push_back(key);
      columns.push_back(column(rows, key.c_str()));
    }
    write_csv(c.csv, header, columns);
  }
  if (c.plot.empty()) return;
  io::PlotPanel panel{.title = "Pressure gradient",
                      .x = {"superficial velocity [cm/h]"},
                      .y = {"pressure gradient [bar/m]"},
                      .series = {}};
  for (const auto& [key, name] : {std::pair{"kozeny_carman_Pa_m", "Kozeny-Carman"},
                                  {"blake_kozeny_Pa_m", "Blake-Kozeny"},
                                  {"ergun_Pa_m", "Ergun"}}) {
    panel.series.push_back({.label = name,
                            .x = column(rows, "superficial_velocity_m_s", 1.0 / cm_h),
                            .y = column(rows, key, 1e-5)});
  }
  write_plot(c.plot, io::plot_svg({panel}, 1));
}

}  // namespace

int flow(const FlowCommand& c) {
  const UnitSystem units;
  const Bed bed{
      .eps = quantity(units, {"--porosity", c.porosity}, fraction, bounds::between_0_and_1),
      .d32 = sauter_diameter(c, units),
      .liquid = read_liquid(units, c.viscosity, c.density, c.temperature),
      .diameter = optional_quantity(units, {"--diameter", c.diameter}, length, bounds::positive),
      .height = optional_quantity(units, {"--height", c.height}, length, bounds::positive)};
  const double from = velocity_of(c, units, bed.diameter);
  const auto to = optional_quantity(units, {"--to", c.to}, velocity, bounds::positive);
  Json rows = Json::array();
  for (const double u : to ? spread(from, *to, c.points) : std::vector{from})
    rows.push_back(row(bed, u));
  if (c.json) {
    Json j{{"porosity", bed.eps},
           {"sauter_diameter_m", bed.d32},
           {"liquid_density_kg_m3", bed.liquid.density},
           {"liquid_viscosity_Pa_s", bed.liquid.viscosity},
           {"permeability_m2", continuum::kozeny_carman_permeability(bed.eps, bed.d32)}};
    if (to) {
      j["rows"] = rows;
    } else {
      j.update(rows.front());
    }
    fmt::print("{}", json_text(j));
  } else {
    print(rows, bed);
  }
  write_files(c, rows);
  return 0;
}

int flow_wall(const WallProfileCommand& c) {
  const UnitSystem units;
  const continuum::BeyEigenberger law{
      .column_diameter = quantity(units, {"--diameter", c.diameter}, length, bounds::positive),
      .bead_diameter =
          quantity(units, {"--bead-diameter", c.bead_diameter}, length, bounds::positive)};
  if (law.column_diameter <= 2.0 * law.bead_diameter) {
    throw ConfigError("--diameter must be more than twice --bead-diameter (thesis eq. 3.48)");
  }
  const auto y = spread(0.0, 0.5 * law.column_diameter, c.points);
  std::vector<double> in_beads, eps;
  // Mean over the cross-section by the midpoint rule, fine enough for 6 digits at any D/d below 1000.
  double area = 0.0, mean = 0.0;
  constexpr int strips = 200000;
  for (int i = 0; i < strips; ++i) {
    const double r = (i + 0.5) / strips;
    area += r;
    mean += r * law(0.5 * law.column_diameter * (1.0 - r));
  }
  for (const double at : y) {
    in_beads.push_back(at / law.bead_diameter);
    eps.push_back(law(at));
  }
  write_csv(c.csv, {"wall_distance_m", "wall_distance_per_bead", "porosity"}, {y, in_beads, eps});
  if (!c.plot.empty()) {
    io::PlotPanel panel{.title = "Porosity near the wall (Bey and Eigenberger)",
                        .x = {"distance from the wall / bead diameter"},
                        .y = {"porosity"},
                        .series = {{.label = "", .x = in_beads, .y = eps}}};
    panel.y.range = {0.0, 1.0};
    panel.x.range = {0.0, std::min(8.0, in_beads.back())};
    write_plot(c.plot, io::plot_svg({panel}, 1));
  }
  const Json j{{"y_min_m", law.y_min()},
               {"y_min_per_bead", law.y_min() / law.bead_diameter},
               {"porosity_at_y_min", law(law.y_min())},
               {"porosity_mean", mean / area},
               {"porosity_far_from_wall", law.eps_bulk}};
  if (c.json) {
    fmt::print("{}", json_text(j));
  } else {
    fmt::print("{:<34} {:.6f} bead diameters\n{:<34} {:.4f}\n{:<34} {:.4f}\n", "first minimum at",
               law.y_min() / law.bead_diameter, "porosity there", law(law.y_min()),
               "mean porosity of the cross-section", mean / area);
  }
  return 0;
}

}  // namespace packbed::app
