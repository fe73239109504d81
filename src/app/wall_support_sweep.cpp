// SPDX-License-Identifier: BSD-3-Clause
// Sweeps of the wall-support model: thesis figs 7.12 to 7.16, and u_crit L0 over L0/D.
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "app/members.hpp"
#include "app/print.hpp"
#include "app/quantities.hpp"
#include "app/wall_support_commands.hpp"
#include "core/error.hpp"
#include "io/plot.hpp"
#include "study/regression.hpp"

namespace packbed::app {
namespace {

using Json = nlohmann::ordered_json;
using enum Dimension;
namespace bounds = setup::bounds;

constexpr double cm_h = 0.01 / 3600.0;   // in m/s
constexpr double cm2_h = 1e-4 / 3600.0;  // in m2/s
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// One column of a sweep; NaN where there is no steady state.
struct Point {
  double diameter, velocity, critical;
  double gradient = nothing, compression = nothing, stress = nothing, drop = nothing;
  bool extrapolated = false;
};

Point solve(const WallSupportBed& w, double diameter, double u) {
  auto column = w.column;
  column.diameter = diameter;
  Point p{
      .diameter = diameter, .velocity = u, .critical = continuum::critical_velocity(w.bed, column)};
  if (u >= p.critical) return p;
  const auto r = continuum::wall_support(w.bed, column, u, 2);
  p.gradient = r.pressure_drop_per_height;
  p.drop = r.pressure_drop;
  p.compression = r.compression;
  p.stress = r.bottom_stress;
  p.extrapolated = w.calibrated && r.compression > *w.calibrated;
  return p;
}

Json point_json(const Point& p) {
  Json j{{"diameter_m", p.diameter},
         {"velocity_m_s", p.velocity},
         {"critical_velocity_m_s", p.critical}};
  j["steady"] = std::isfinite(p.gradient);
  if (!std::isfinite(p.gradient)) return j;
  j["pressure_drop_Pa"] = p.drop;
  j["pressure_drop_per_height_Pa_m"] = p.gradient;
  j["compression"] = p.compression;
  j["bottom_stress_Pa"] = p.stress;
  j["extrapolated"] = p.extrapolated;
  return j;
}

// Rows without a steady state are left out: there is no number for them.
void write_points(const std::string& file, const std::vector<Point>& points) {
  std::vector<Point> steady;
  for (const auto& p : points) {
    if (std::isfinite(p.gradient)) steady.push_back(p);
  }
  write_csv(file,
            {"diameter_m", "velocity_m_s", "critical_velocity_m_s", "pressure_drop_Pa",
             "pressure_drop_per_height_Pa_m", "compression", "bottom_stress_Pa"},
            {column_of(steady, &Point::diameter), column_of(steady, &Point::velocity),
             column_of(steady, &Point::critical), column_of(steady, &Point::drop),
             column_of(steady, &Point::gradient), column_of(steady, &Point::compression),
             column_of(steady, &Point::stress)});
}

void print_points(const std::vector<Point>& points) {
  fmt::print("{:>10} {:>12} {:>12} {:>12} {:>12} {:>14}\n", "D [mm]", "u [cm/h]", "u_crit",
             "dP [bar/m]", "compression", "stress [kPa]");
  for (const auto& p : points) {
    fmt::print("{:>10.5g} {:>12.5g} {:>12.5g} ", p.diameter * 1e3, p.velocity / cm_h,
               p.critical / cm_h);
    if (std::isfinite(p.gradient)) {
      fmt::print("{:>12.5g} {:>12.5g} {:>14.5g}{}\n", p.gradient * 1e-5, p.compression,
                 p.stress * 1e-3, p.extrapolated ? "  extrapolated" : "");
    } else {
      fmt::print("  no steady state above u_crit = {:.5g} cm/h\n", p.critical / cm_h);
    }
  }
}

WallSupportBed read(const WallSupportSweepCommand& c, const UnitSystem& units) {
  auto w = read_wall_support(c.options, units);
  quantity(units, {"--height", c.options.height}, length, bounds::positive);
  return w;
}

std::vector<double> lengths(const UnitSystem& units,
                            std::string_view name,
                            const std::vector<std::string>& texts) {
  std::vector<double> values;
  values.reserve(texts.size());
  for (const auto& text : texts)
    values.push_back(quantity(units, {name, text}, length, bounds::positive));
  return values;
}

// a ln(D in mm) + b of the steady points, as thesis eqs 7.2 to 7.5.
std::optional<study::Line> logarithmic_fit(const std::vector<Point>& points,
                                           double Point::*member,
                                           double factor) {
  std::vector<double> x, y;
  for (const auto& p : points) {
    if (!std::isfinite(p.*member)) continue;
    x.push_back(std::log(p.diameter * 1e3));
    y.push_back(p.*member * factor);
  }
  if (x.size() < 3) return std::nullopt;
  return study::regression(x, y);
}

io::PlotSeries fitted_line(const std::vector<Point>& points, const study::Line& line) {
  io::PlotSeries s{.label = fmt::format("{:.4g} ln(D/mm) {} {:.4g}", line.slope,
                                        line.intercept < 0 ? "-" : "+", std::abs(line.intercept)),
                   .x = {},
                   .y = {},
                   .style = io::PlotStyle::dashed};
  for (const auto& p : points) {
    if (!std::isfinite(p.gradient)) continue;
    s.x.push_back(p.diameter * 1e3);
    s.y.push_back(line.slope * std::log(p.diameter * 1e3) + line.intercept);
  }
  return s;
}

Json line_json(const study::Line& line) {
  return {{"slope", line.slope}, {"intercept", line.intercept}, {"r2", line.r2}};
}

void note_calibration(const WallSupportBed& w, const std::vector<Point>& points) {
  bool any = false;
  for (const auto& p : points) any = any || p.extrapolated;
  if (any)
    fmt::print("note: \"extrapolated\": the bed was calibrated up to a compression of {:.4g}\n",
               *w.calibrated);
  if (!w.calibrated)
    fmt::print(
        "note: it is not known up to which compression the bed was calibrated "
        "(--calibrated-compression)\n");
}

// The line of the calibrated range, across a panel of compression.
void add_calibration(const WallSupportBed& w, io::PlotPanel& panel, double from, double to) {
  if (!w.calibrated) return;
  panel.series.push_back({.label = "end of calibration",
                          .x = {from, to},
                          .y = {*w.calibrated, *w.calibrated},
                          .style = io::PlotStyle::dashed,
                          .color = 6});
}

}  // namespace

int wall_support_velocities(const WallSupportSweepCommand& c) {
  const UnitSystem units;
  const auto w = read(c, units);
  if (c.diameters.empty())
    throw ConfigError(
        "--diameter is missing; give one or more, such as --diameter \"9.6 mm\" --diameter \"20 "
        "mm\"");
  const double from = quantity_or(units, {"--from", c.from}, velocity, bounds::positive, 0.0);
  const double to = quantity(units, {"--to", c.to}, velocity, bounds::positive);
  io::PlotPanel gradient{.title = "Pressure drop",
                         .x = {"superficial velocity [cm/h]"},
                         .y = {"pressure drop per height [bar/m]"},
                         .series = {}};
  io::PlotPanel compression{.title = "Compression",
                            .x = {"superficial velocity [cm/h]"},
                            .y = {"compression"},
                            .series = {}};
  std::vector<Point> all;
  for (const double d : lengths(units, "--diameter", c.diameters)) {
    std::vector<Point> points;
    for (const double u : spread(from, to, c.points)) points.push_back(solve(w, d, u));
    const auto u = column_of(points, &Point::velocity, 1.0 / cm_h);
    const auto label = fmt::format("D = {:.4g} mm", d * 1e3);
    gradient.series.push_back(
        {.label = label, .x = u, .y = column_of(points, &Point::gradient, 1e-5)});
    compression.series.push_back(
        {.label = label, .x = u, .y = column_of(points, &Point::compression)});
    all.insert(all.end(), points.begin(), points.end());
  }
  add_calibration(w, compression, from / cm_h, to / cm_h);
  write_points(c.csv, all);
  if (!c.plot.empty()) write_plot(c.plot, io::plot_svg({gradient, compression}));
  if (c.json) {
    Json j{{"reading", c.options.reading}};
    for (const auto& p : all) j["points"].push_back(point_json(p));
    fmt::print("{}", json_text(j));
  } else {
    print_points(all);
    note_calibration(w, all);
  }
  return 0;
}

int wall_support_diameters(const WallSupportSweepCommand& c) {
  const UnitSystem units;
  const auto w = read(c, units);
  const double u = quantity(units, {"--velocity", c.velocity}, velocity, bounds::positive);
  auto diameters = lengths(units, "--diameter", c.diameters);
  if (diameters.empty()) {
    diameters =
        spread(quantity_or(units, {"--from", c.from}, length, bounds::positive, 0.01),
               quantity_or(units, {"--to", c.to}, length, bounds::positive, 2.0), c.points, true);
  }
  std::vector<Point> points;
  points.reserve(diameters.size());
  for (const double d : diameters) points.push_back(solve(w, d, u));
  const auto gradient = logarithmic_fit(points, &Point::gradient, 1e-5);
  const auto compression = logarithmic_fit(points, &Point::compression, 1.0);
  write_points(c.csv, points);
  if (!c.plot.empty()) {
    const auto x = column_of(points, &Point::diameter, 1e3);
    const auto panel = [&](const char* title, const char* y, double Point::*member, double factor,
                           const std::optional<study::Line>& line) {
      io::PlotPanel p{
          .title = title,
          .x = {"column diameter [mm]", true},
          .y = {y},
          .series = {{.label = "model", .x = x, .y = column_of(points, member, factor)}}};
      if (line) p.series.push_back(fitted_line(points, *line));
      return p;
    };
    auto of_compression =
        panel("Compression", "compression", &Point::compression, 1.0, compression);
    add_calibration(w, of_compression, x.front(), x.back());
    auto critical =
        panel("Critical velocity", "critical velocity [cm/h]", &Point::critical, 1.0 / cm_h, {});
    critical.series.push_back({.label = "velocity of the sweep",
                               .x = {x.front(), x.back()},
                               .y = {u / cm_h, u / cm_h},
                               .style = io::PlotStyle::dashed});
    write_plot(c.plot, io::plot_svg({panel("Pressure drop", "pressure drop per height [bar/m]",
                                           &Point::gradient, 1e-5, gradient),
                                     of_compression, critical}));
  }
  if (c.json) {
    Json j{{"reading", c.options.reading}};
    if (gradient) j["pressure_drop_bar_m_over_ln_mm"] = line_json(*gradient);
    if (compression) j["compression_over_ln_mm"] = line_json(*compression);
    for (const auto& p : points) j["points"].push_back(point_json(p));
    fmt::print("{}", json_text(j));
    return 0;
  }
  print_points(points);
  if (gradient)
    fmt::print("dP [bar/m]   = {:.5g} ln(D/mm) {:+.5g}   R2 = {:.4f}\n", gradient->slope,
               gradient->intercept, gradient->r2);
  if (compression)
    fmt::print("compression  = {:.5g} ln(D/mm) {:+.5g}   R2 = {:.4f}\n", compression->slope,
               compression->intercept, compression->r2);
  note_calibration(w, points);
  return 0;
}

int wall_support_scale(const WallSupportSweepCommand& c) {
  const UnitSystem units;
  auto w = read_wall_support(c.options, units);
  const auto heights = lengths(units, "--height", c.heights);
  if (heights.empty())
    throw ConfigError(
        "--height is missing; give one or more, such as --height \"10 cm\" --height \"20 cm\"");
  const auto diameters =
      spread(quantity_or(units, {"--from", c.from}, length, bounds::positive, 0.01),
             quantity_or(units, {"--to", c.to}, length, bounds::positive, 2.0), c.points, true);
  io::PlotPanel panel{.title = "Scale-up",
                      .x = {"height / diameter"},
                      .y = {"critical velocity x height [cm2/h]"},
                      .series = {}};
  std::vector<double> ratio, product, all_d, all_h, all_u;
  for (const double h : heights) {
    w.column.height = h;
    io::PlotSeries s{.label = fmt::format("L0 = {:.4g} cm", h * 100), .x = {}, .y = {}};
    for (const double d : diameters) {
      w.column.diameter = d;
      const double u = continuum::critical_velocity(w.bed, w.column);
      all_d.push_back(d);
      all_h.push_back(h);
      all_u.push_back(u);
      ratio.push_back(h / d);
      product.push_back(u * h);
      s.x.push_back(h / d);
      s.y.push_back(u * h / cm2_h);
    }
    panel.series.push_back(std::move(s));
  }
  const auto line = study::regression(ratio, product);
  const double last = *std::max_element(ratio.begin(), ratio.end());
  panel.series.push_back(
      {.label = fmt::format("{:.4g} L0/D + {:.5g}", line.slope / cm2_h, line.intercept / cm2_h),
       .x = {0.0, last},
       .y = {line.intercept / cm2_h, (line.slope * last + line.intercept) / cm2_h},
       .style = io::PlotStyle::dashed});
  write_csv(c.csv,
            {"diameter_m", "height_m", "critical_velocity_m_s", "height_per_diameter",
             "critical_velocity_times_height_m2_s"},
            {all_d, all_h, all_u, ratio, product});
  if (!c.plot.empty()) write_plot(c.plot, io::plot_svg({panel}, 1));
  if (c.json) {
    Json j{{"slope_m2_s", line.slope}, {"intercept_m2_s", line.intercept}, {"r2", line.r2}};
    for (std::size_t i = 0; i < all_d.size(); ++i) {
      j["points"].push_back(
          {{"diameter_m", all_d[i]}, {"height_m", all_h[i]}, {"critical_velocity_m_s", all_u[i]}});
    }
    fmt::print("{}", json_text(j));
    return 0;
  }
  fmt::print("{:>10} {:>10} {:>14} {:>10} {:>16}\n", "D [cm]", "L0 [cm]", "u_crit [cm/h]", "L0/D",
             "u L0 [cm2/h]");
  for (std::size_t i = 0; i < all_d.size(); ++i) {
    fmt::print("{:>10.4g} {:>10.4g} {:>14.5g} {:>10.4g} {:>16.6g}\n", all_d[i] * 100,
               all_h[i] * 100, all_u[i] / cm_h, ratio[i], product[i] / cm2_h);
  }
  fmt::print(
      "u_crit L0 [cm2/h] = {:.5g} L0/D {:+.6g}   R2 = {:.4f}  (the form of Stickel and "
      "Fotopoulos)\n",
      line.slope / cm2_h, line.intercept / cm2_h, line.r2);
  fmt::print(
      "note: a collapse lies beyond any calibrated compression: these velocities are "
      "extrapolated\n");
  return 0;
}

}  // namespace packbed::app
