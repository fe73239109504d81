// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <fmt/format.h>

#include "app/members.hpp"
#include "app/print.hpp"
#include "app/quantities.hpp"
#include "app/wall_support_commands.hpp"
#include "core/error.hpp"
#include "io/plot.hpp"

namespace packbed::app {
namespace {

using enum Dimension;
namespace bounds = setup::bounds;
using continuum::BedDepth;

constexpr double cm_h = 0.01 / 3600.0;  // in m/s

void write_files(const WallSupportCommand& c, const std::vector<BedDepth>& p) {
  write_csv(
      c.csv,
      {"depth_m", "settled_depth_m", "stress_Pa", "compression", "porosity", "pressure_lost_Pa"},
      {column_of(p, &BedDepth::z), column_of(p, &BedDepth::settled),
       column_of(p, &BedDepth::stress), column_of(p, &BedDepth::compression),
       column_of(p, &BedDepth::porosity), column_of(p, &BedDepth::pressure)});
  if (c.plot.empty()) return;
  const auto panel = [&](const char* title, const char* y, double BedDepth::*member,
                         double factor) {
    return io::PlotPanel{.title = title,
                         .x = {"depth below the top of the bed [mm]"},
                         .y = {y},
                         .series = {{.label = "",
                                     .x = column_of(p, &BedDepth::z, 1e3),
                                     .y = column_of(p, member, factor)}}};
  };
  write_plot(
      c.plot,
      io::plot_svg(
          {panel("Stress between the beads", "axial stress [kPa]", &BedDepth::stress, 1e-3),
           panel("Compression", "local compression", &BedDepth::compression, 1.0),
           panel("Porosity", "local porosity", &BedDepth::porosity, 1.0),
           panel("Pressure", "pressure lost since the top [kPa]", &BedDepth::pressure, 1e-3)}));
}

}  // namespace

int wall_support(const WallSupportCommand& c) {
  const UnitSystem units;
  auto [bed, column, calibrated] = read_wall_support(c.options, units);
  if (column.height == 0.0)
    quantity(units, {"--height", c.options.height}, length, bounds::positive);  // refuses
  if (c.no_wall) {
    if (!c.diameter.empty()) throw ConfigError("--no-wall and --diameter exclude each other");
  } else {
    column.diameter = quantity(units, {"--diameter", c.diameter}, length, bounds::positive);
  }
  const double u = quantity(units, {"--velocity", c.velocity}, velocity, bounds::not_negative);
  const auto r = continuum::wall_support(bed, column, u, c.points);
  const double critical = continuum::critical_velocity(bed, column);
  const bool extrapolated = calibrated && r.compression > *calibrated;
  write_files(c, r.profile);
  if (c.json) {
    nlohmann::ordered_json j{{"pressure_drop_Pa", r.pressure_drop},
                             {"pressure_drop_per_height_Pa_m", r.pressure_drop_per_height},
                             {"compression", r.compression},
                             {"bottom_stress_Pa", r.bottom_stress},
                             {"critical_velocity_m_s", critical},
                             {"velocity_m_s", u},
                             {"velocity_per_critical", u / critical},
                             {"height_m", r.height},
                             {"settled_height_m", r.settled_height},
                             {"bottom_compression", r.bottom_compression},
                             {"reading", c.options.reading},
                             {"extrapolated", extrapolated}};
    j["calibrated_compression"] =
        calibrated ? nlohmann::ordered_json(*calibrated) : nlohmann::ordered_json(nullptr);
    fmt::print("{}", json_text(j));
    return 0;
  }
  fmt::print("{:<34} {:.6g} bar\n", "pressure drop", r.pressure_drop * 1e-5);
  fmt::print("{:<34} {:.6g} bar/m\n", "per height under flow", r.pressure_drop_per_height * 1e-5);
  fmt::print("{:<34} {:.6g} (bed of {:.5g} mm, settled {:.5g} mm)\n", "compression", r.compression,
             r.height * 1e3, r.settled_height * 1e3);
  fmt::print("{:<34} {:.6g} kPa, local compression {:.5g}\n", "stress at the bottom",
             r.bottom_stress * 1e-3, r.bottom_compression);
  fmt::print("{:<34} {:.6g} cm/h; this is {:.1f} % of it\n", "critical velocity", critical / cm_h,
             100.0 * u / critical);
  if (extrapolated) {
    fmt::print("note: EXTRAPOLATED: the bed was calibrated up to a compression of {:.4g}\n",
               *calibrated);
  } else if (!calibrated) {
    fmt::print(
        "note: it is not known up to which compression the bed was calibrated "
        "(--calibrated-compression)\n");
  }
  return 0;
}

}  // namespace packbed::app
