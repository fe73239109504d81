// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/plots.hpp"

namespace packbed::report {
namespace {

/// A column of series.csv against time.
struct Against {
  const char* title = "";
  const char* axis = "";
  const char* column = "";
  double factor = 1.0;  ///< from SI to the unit of the axis
  bool logarithmic = false;
};

const Against in_time[] = {
    {"Superficial velocity", "superficial velocity [cm/h]", "superficial_velocity_m_s", per_cm_h},
    {"Pressure drop", "pressure drop [bar]", "pressure_drop_Pa", per_bar},
    {"Plunger position", "height of the plunger [mm]", "plunger_position_m", per_mm},
    {"Plunger force", "force on the plunger [N]", "plunger_force_N", 1.0},
    {"Bed height", "bed height [mm]", "bed_height_m", per_mm},
    {"Compression", "compression [%]", "compression", 100.0},
    {"Porosity of the middle half", "porosity [-]", "middle_porosity", 1.0}};

const Against checks[] = {
    {"Budget error", "|1 - forces out / forces in| [-]", "budget_error", 1.0, true},
    {"Unbalanced force", "mean unbalanced / contact force [-]", "unbalanced_force", 1.0, true},
    {"Kinetic to elastic energy", "kinetic / elastic energy [-]", "kinetic_to_elastic", 1.0, true},
    {"Largest overlap", "overlap / smaller diameter [-]", "max_overlap_ratio", 1.0},
    {"Contacts", "contacts per bead [-]", "coordination_number", 1.0},
    {"Residual of continuity", "continuity error [-]", "continuity_error", 1.0, true}};

/// The unit in which the longest run is a handy number.
struct TimeUnit {
  const char* label;
  double per_second;
};

TimeUnit time_unit(std::span<const RunData> runs) {
  double longest = 0.0;
  for (const auto& run : runs) {
    if (run.was_simulated()) longest = std::max(longest, run.series["time_s"].back());
  }
  if (longest >= 0.1) return {"time [s]", 1.0};
  return longest >= 1e-4 ? TimeUnit{"time [ms]", 1e3} : TimeUnit{"time [us]", 1e6};
}

// More than a screen shows; a run of hours has many more rows.
constexpr std::size_t row_limit = 2000;

/// Rows to draw: every n-th, and the last.
std::vector<std::size_t> rows_of(const Columns& series) {
  const auto each = (series.rows() + row_limit - 1) / row_limit;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < series.rows(); i += each) rows.push_back(i);
  if (!rows.empty() && rows.back() + 1 != series.rows()) rows.push_back(series.rows() - 1);
  return rows;
}

/// A column that never leaves zero has nothing to tell: no flow, nothing settled.
bool tells_something(const std::vector<double>& column) {
  return std::ranges::any_of(column, [](double v) { return std::isfinite(v) && v != 0.0; });
}

void add_curve(Plot& plot, const Against& a, std::span<const RunData> runs, std::size_t r) {
  const auto& series = runs[r].series;
  const auto unit = time_unit(runs);
  if (!series.has(a.column) || !tells_something(series[a.column])) return;
  Curve curve{.label = curve_label(runs, r, runs.size() == 1 ? plot.title : ""), .x = {}, .y = {}};
  curve.color = static_cast<int>(r);
  for (const auto row : rows_of(series)) {
    const double value = series[a.column][row];
    curve.x.push_back(unit.per_second * series["time_s"][row]);
    curve.y.push_back(a.factor * (a.logarithmic ? std::abs(value) : value));
  }
  plot.add(std::move(curve));
}

void fill(PlotGroup& group, std::span<const Against> plots, std::span<const RunData> runs) {
  for (const auto& a : plots) {
    Plot plot{.title = a.title,
              .x = {time_unit(runs).label},
              .y = {.label = a.axis, .logarithmic = a.logarithmic},
              .curves = {}};
    for (std::size_t r = 0; r < runs.size(); ++r) add_curve(plot, a, runs, r);
    group.add(std::move(plot));
  }
  std::size_t rows = 0;
  for (const auto& run : runs) rows = std::max(rows, run.series.rows());
  if (rows > row_limit) {
    group.text += fmt::format(" Of {} rows of series.csv about {} are drawn, evenly spaced.", rows,
                              row_limit);
  }
}

void add_energy(Plot& plot, const RunData& run, const char* column, const char* label, int color) {
  if (!run.series.has(column)) return;
  const auto unit = time_unit({&run, 1});
  Curve curve{.label = label, .x = {}, .y = {}};
  curve.color = color;
  for (const auto row : rows_of(run.series)) {
    curve.x.push_back(unit.per_second * run.series["time_s"][row]);
    curve.y.push_back(run.series[column][row]);
  }
  plot.add(std::move(curve));
}

}  // namespace

PlotGroup time_plots(std::span<const RunData> runs) {
  PlotGroup group{.id = "time", .title = "In time", .text = "Rows of series.csv."};
  fill(group, in_time, runs);
  return group;
}

PlotGroup check_plots(std::span<const RunData> runs) {
  PlotGroup group{.id = "checks", .title = "Contacts and energies", .text = ""};
  const bool has_bed =
      std::ranges::any_of(runs, [](const RunData& run) { return run.series.has("bed_height_m"); });
  if (has_bed) {
    group.title = "Can the figures be trusted?";
    group.text =
        "A bed at rest has a budget error near 0 (what pulls it down, its weight and the pressure, "
        "arrives at the floor and the wall), a small unbalanced force (1e-3 is the limit) and "
        "little kinetic energy (1e-4 of the elastic energy).";
  }
  fill(group, checks, runs);
  if (runs.size() == 1) {
    Plot plot{.title = "Energies",
              .x = {time_unit(runs).label},
              .y = {.label = "energy [J]", .logarithmic = true},
              .curves = {}};
    add_energy(plot, runs[0], "kinetic_energy_J", "kinetic", 0);
    add_energy(plot, runs[0], "elastic_energy_J", "elastic", 1);
    group.add(std::move(plot));
  }
  return group;
}

}  // namespace packbed::report
