// SPDX-License-Identifier: BSD-3-Clause
#include "study/wall_support_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/fit_print.hpp"
#include "app/print.hpp"
#include "app/quantities.hpp"
#include "app/wall_support_commands.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "io/plot.hpp"
#include "study/read_column_data.hpp"

namespace packbed::app {
namespace {

using Json = nlohmann::ordered_json;
using enum Dimension;
namespace bounds = setup::bounds;
using study::BedParameter;
using study::WallSupportFit;

constexpr double cm_h = 0.01 / 3600.0;  // in m/s

struct Name {
  std::string name;
  BedParameter parameter;
  Dimension dimension;
};
const std::vector<Name> names = {{"B", BedParameter::modulus, pressure},
                                 {"bead-diameter", BedParameter::bead_diameter, length},
                                 {"wall-friction", BedParameter::wall_friction, fraction},
                                 {"poisson", BedParameter::poisson, fraction},
                                 {"density-difference", BedParameter::density_difference, density},
                                 {"settled-porosity", BedParameter::eps0, fraction},
                                 {"exponent", BedParameter::exponent, fraction}};

const Name& named(const std::string& name, std::string_view option) {
  const auto found = std::ranges::find(names, name, &Name::name);
  if (found != names.end()) return *found;
  std::vector<std::string> known;
  known.reserve(names.size());
  for (const auto& n : names) known.push_back(n.name);
  throw ConfigError(fmt::format("{}: \"{}\" is not a parameter of the bed; known are {}", option,
                                name, either_of(known)));
}

// "B=10 kPa:1 MPa"
void set_bound(const std::string& text,
               const UnitSystem& units,
               std::vector<study::BedBound>& free) {
  const auto equals = text.find('=');
  const auto colon = text.find(':');
  if (equals == std::string::npos || colon == std::string::npos || colon < equals) {
    throw ConfigError(
        fmt::format("--bound = \"{}\" is refused; give it as \"B=10 kPa:1 MPa\"", text));
  }
  const auto& name = named(text.substr(0, equals), "--bound");
  const auto low = text.substr(equals + 1, colon - equals - 1);
  const auto high = text.substr(colon + 1);
  const auto found = std::ranges::find(free, name.parameter, &study::BedBound::parameter);
  if (found == free.end())
    throw ConfigError(fmt::format("--bound: {} is not free (--free)", name.name));
  found->low = quantity(units, {"--bound", low}, name.dimension, bounds::positive);
  found->high = quantity(units, {"--bound", high}, name.dimension, bounds::positive);
  if (!(found->low < found->high))
    throw ConfigError(
        fmt::format("--bound = \"{}\": the lower bound must be below the upper one", text));
}

std::vector<study::BedBound> read_free(const WallSupportFitCommand& c, const UnitSystem& units) {
  std::vector<study::BedBound> free;
  std::string rest = c.free;
  while (!rest.empty()) {
    const auto comma = rest.find(',');
    const auto word = std::string(trimmed(rest.substr(0, comma)));
    const auto bound = study::usual_bounds(named(word, "--free").parameter);
    if (std::ranges::find(free, bound.parameter, &study::BedBound::parameter) != free.end()) {
      throw ConfigError(fmt::format("--free: {} is there twice", word));
    }
    free.push_back(bound);
    rest = comma == std::string::npos ? "" : rest.substr(comma + 1);
  }
  for (const auto& text : c.bounds) set_bound(text, units, free);
  return free;
}

std::vector<std::string> notes_of(const WallSupportFit& f, const study::ColumnData& data) {
  std::vector<std::string> notes;
  for (const auto& group : f.fit.confounded) {
    notes.push_back(
        fmt::format("the data cannot tell apart {}: only a combination of them is known; fix all "
                    "but one (leave them out of --free)",
                    fmt::join(group.names, " and ")));
  }
  const auto n = f.fit.size();
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (std::abs(f.fit.correlation[a * n + b]) > 0.98) {
        notes.push_back(fmt::format("{} and {} are hardly told apart: their correlation is {:.4f}",
                                    f.fit.parameters[b].name, f.fit.parameters[a].name,
                                    f.fit.correlation[a * n + b]));
      }
    }
    const auto& e = f.fit.estimates[a];
    if (e.at_bound) notes.push_back(fmt::format("{} rests on a bound", e.name));
    if (std::isfinite(e.error) && e.error > 0.5 * std::abs(e.value))
      notes.push_back(
          fmt::format("{} is hardly determined by these data: error {:.0f} % of its value", e.name,
                      100.0 * e.error / std::abs(e.value)));
  }
  if (!data.has_errors)
    notes.emplace_back(
        "the errors of the data are weights (5 % of pressure drops, 15 % of compressions); "
        "intervals follow from the misfit");
  if (f.agreeing < f.starts)
    notes.push_back(fmt::format(
        "{} of {} starts end at this fit; the others at worse ones, or where the data say nothing",
        f.agreeing, f.starts));
  notes.push_back(fmt::format(
      "calibrated up to a compression of {:.4g}: pass it on as --calibrated-compression",
      f.largest_compression));
  return notes;
}

Json to_json(const WallSupportFit& f,
             const study::ColumnData& data,
             const std::vector<std::string>& notes) {
  Json j{{"rows", f.fit.rows},
         {"r2_pressure_gradient", f.r2_gradient},
         {"r2_compression", f.r2_compression},
         {"chi_squared", f.fit.sum_of_squares},
         {"converged", f.fit.converged},
         {"starts", f.starts},
         {"starts_agreeing", f.agreeing}};
  for (const auto& e : f.fit.estimates) j["parameters"][e.name] = estimate_json(e);
  if (f.wall_coefficient) j["wall_coefficient"] = estimate_json(*f.wall_coefficient);
  j["correlation"] = correlation_json(f.fit);
  j["confounded"] = Json::array();
  for (const auto& group : f.fit.confounded) j["confounded"].push_back(group.names);
  j["calibrated_compression"] = f.largest_compression;
  for (std::size_t i = 0; i < data.rows.size(); ++i) {
    const auto& d = data.rows[i];
    Json row{{"diameter_m", d.diameter}, {"velocity_m_s", d.velocity}};
    if (d.gradient) row["pressure_gradient_Pa_m"] = *d.gradient;
    row["pressure_gradient_model_Pa_m"] = f.model[i].gradient;
    if (d.compression) row["compression"] = *d.compression;
    row["compression_model"] = f.model[i].compression;
    j["data"].push_back(row);
  }
  j["notes"] = notes;
  return j;
}

void print(const WallSupportFit& f,
           const study::ColumnData& data,
           const std::vector<std::string>& notes) {
  fmt::print("  {:<28} {:>12} +- {:<10} [95 % interval]\n", "", "value", "error");
  for (const auto& e : f.fit.estimates) print_estimate(e);
  if (f.wall_coefficient) print_estimate(*f.wall_coefficient);
  fmt::print("  {:<28} {:>12.5f}\n  {:<28} {:>12.5f}\n  {:<28} {:>12.5g} on {} rows\n",
             "R2, pressure drop", f.r2_gradient, "R2, compression", f.r2_compression,
             "sum of squared residuals", f.fit.sum_of_squares, f.fit.rows);
  print_correlation(f.fit);
  fmt::print("\n  {:>10} {:>10} {:>12} {:>12} {:>12} {:>12}\n", "D [mm]", "u [cm/h]", "dP [bar/m]",
             "model", "compression", "model");
  for (std::size_t i = 0; i < data.rows.size(); ++i) {
    const auto& d = data.rows[i];
    fmt::print("  {:>10.5g} {:>10.5g} {:>12} {:>12.5g} {:>12} {:>12.5g}\n", d.diameter * 1e3,
               d.velocity / cm_h, d.gradient ? fmt::format("{:.5g}", *d.gradient * 1e-5) : "-",
               f.model[i].gradient * 1e-5,
               d.compression ? fmt::format("{:.5g}", *d.compression) : "-", f.model[i].compression);
  }
  for (const auto& note : notes) fmt::print("note: {}\n", note);
}

/// Rows of the data that belong to one line of a plot.
struct Group {
  std::string label, model_label;
  std::vector<std::size_t> rows;
  int color = 0;
  int model_color = 0;
};

// One line per column where the velocity varies, otherwise one line over the diameters.
std::vector<Group> groups_of(const study::ColumnData& data, bool& over_velocity) {
  std::map<double, std::vector<std::size_t>> columns;
  for (std::size_t i = 0; i < data.rows.size(); ++i) columns[data.rows[i].diameter].push_back(i);
  over_velocity = columns.size() < data.rows.size();
  std::vector<Group> groups;
  if (!over_velocity)
    groups.push_back(
        {.label = "data", .model_label = "model", .rows = {}, .color = 0, .model_color = 1});
  for (auto& [d, rows] : columns) {
    if (over_velocity) {
      std::ranges::sort(rows, {}, [&](std::size_t i) { return data.rows[i].velocity; });
      const int color = static_cast<int>(groups.size());
      groups.push_back({fmt::format("D = {:.4g} mm", d * 1e3), "", rows, color, color});
    } else {
      groups.front().rows.push_back(rows.front());
    }
  }
  return groups;
}

// Data with error bars and model of one quantity.
void add_group(io::PlotPanel& panel,
               const Group& group,
               const std::vector<double>& axis,
               const std::vector<std::array<double, 3>>& datum_error_model) {
  io::PlotSeries data{
      .label = group.label, .x = {}, .y = {}, .style = io::PlotStyle::points, .color = group.color};
  io::PlotSeries model{.label = group.model_label, .x = {}, .y = {}, .color = group.model_color};
  for (const auto i : group.rows) {
    const auto& [datum, error, fitted] = datum_error_model[i];
    data.x.push_back(axis[i]);
    data.y.push_back(datum);
    data.y_error.push_back(error);
    model.x.push_back(axis[i]);
    model.y.push_back(fitted);
  }
  panel.series.push_back(std::move(data));
  panel.series.push_back(std::move(model));
}

std::string draw(const WallSupportFit& f, const study::ColumnData& data) {
  bool over_velocity = false;
  const auto groups = groups_of(data, over_velocity);
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> axis;
  std::vector<std::array<double, 3>> gradient, compression;
  for (std::size_t i = 0; i < data.rows.size(); ++i) {
    const auto& at = data.rows[i];
    axis.push_back(over_velocity ? at.velocity / cm_h : at.diameter * 1e3);
    gradient.push_back({at.gradient.value_or(nothing) * 1e-5, at.gradient_error * 1e-5,
                        f.model[i].gradient * 1e-5});
    compression.push_back(
        {at.compression.value_or(nothing), at.compression_error, f.model[i].compression});
  }
  const io::PlotAxis x{over_velocity ? "superficial velocity [cm/h]" : "column diameter [mm]",
                       !over_velocity};
  io::PlotPanel of_gradient{
      .title = "Pressure drop", .x = x, .y = {"pressure drop per height [bar/m]"}, .series = {}};
  io::PlotPanel of_compression{.title = "Compression", .x = x, .y = {"compression"}, .series = {}};
  for (const auto& group : groups) {
    add_group(of_gradient, group, axis, gradient);
    add_group(of_compression, group, axis, compression);
  }
  return io::plot_svg({of_gradient, of_compression});
}

}  // namespace

int wall_support_fit(const WallSupportFitCommand& c) {
  const UnitSystem units;
  const auto w = read_wall_support(c.options, units);
  study::WallSupportFitOptions options{.free = read_free(c, units), .column = w.column};
  options.starts = c.starts;
  options.intervals = read_intervals(c.intervals);
  std::optional<double> height;
  if (!c.options.height.empty()) height = w.column.height;
  const auto data = study::read_column_data(c.file, units, {.height = height});
  options.known_errors = data.has_errors;
  WallSupportFit fit;
  try {
    fit = study::fit_wall_support(w.bed, data.rows, options);
  } catch (const ValueError& error) {
    throw ConfigError(fmt::format("{}: {}", c.file, error.what()));
  }
  const auto notes = notes_of(fit, data);
  if (c.json) {
    fmt::print("{}", json_text(to_json(fit, data, notes)));
  } else {
    print(fit, data, notes);
  }
  if (!c.plot.empty()) write_plot(c.plot, draw(fit, data));
  return 0;
}

}  // namespace packbed::app
