// SPDX-License-Identifier: BSD-3-Clause
#include "report/key_figures.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/plot.hpp"
#include "report/plots.hpp"

namespace packbed::report {
namespace {

/// `value` times `factor` in `form`, such as "{:.3f} mm"; empty where there is none.
std::string written(std::optional<double> value, double factor, const char* form) {
  return value && std::isfinite(*value) ? fmt::format(fmt::runtime(form), factor * *value) : "";
}

/// Of microseconds to days, with three or four digits.
std::string duration(std::optional<double> seconds) {
  if (!seconds) return {};
  const double s = *seconds;
  if (s >= 7200.0) return fmt::format("{:.4g} h", s / 3600.0);
  if (s >= 120.0) return fmt::format("{:.3g} min", s / 60.0);
  if (s >= 0.1 || s == 0.0) return fmt::format("{:.3g} s", s);
  return s >= 1e-4 ? fmt::format("{:.3g} ms", 1e3 * s) : fmt::format("{:.3g} us", 1e6 * s);
}

void add_flow(const RunData& run, std::vector<KeyFigure>& figures) {
  const auto flow = run.plateaus.empty() ? Plateau{} : run.plateaus[highest_flow(run.plateaus)];
  const auto resistance = kozeny_carman_resistance(run);
  figures.push_back(
      {"Highest superficial velocity", written(flow.velocity, per_cm_h, "{:.4g} cm/h")});
  figures.push_back({"Pressure drop there", written(flow.pressure_drop, per_bar, "{:.4g} bar"),
                     flow.frit_pressure_drop > 0.0
                         ? written(flow.frit_pressure_drop, per_bar, "frits besides: {:.4g} bar")
                         : ""});
  figures.push_back({"Per present bed height",
                     written(flow.pressure_gradient, per_bar, "{:.4g} bar/m"),
                     written(resistance.value_or(unknown) * flow.velocity, per_bar,
                             "Kozeny-Carman, settled bed: {:.4g} bar/m")});
  figures.push_back({"Compression there", written(flow.compression, 100.0, "{:.2f} %")});
}

}  // namespace

std::vector<KeyFigure> key_figures(const RunData& run) {
  const auto settled = run.number("/settled_height_m");
  std::vector<KeyFigure> figures;
  figures.push_back({"Settled bed height", written(settled, per_mm, "{:.3f} mm")});
  figures.push_back({"Settled porosity", written(run.number("/settled_porosity"), 1.0, "{:.4f}"),
                     settled ? "of the middle half" : ""});
  add_flow(run, figures);
  figures.push_back(
      {"Bed height at the end", written(run.number("/bed_height_m"), per_mm, "{:.3f} mm")});
  figures.push_back(
      {"Contacts per bead at the end", written(run.number("/coordination_number"), 1.0, "{:.2f}")});
  figures.push_back({"Largest overlap",
                     written(run.number("/max_overlap_ratio"), 100.0, "{:.2f} %"),
                     "of the smaller diameter"});
  figures.push_back(
      {"Budget error at the end", written(run.number("/budget_error"), 1.0, "{:.1e}")});
  figures.push_back({"Simulated grains", written(run.number("/beads"), 1.0, "{:.0f}")});
  figures.push_back({"Simulated time", duration(run.number("/simulated_time_s"))});
  const auto ranks = run.number("/ranks");
  figures.push_back({"Wall time", duration(run.number("/wall_time_s")),
                     written(ranks, 1.0, ranks == 1.0 ? "on {:.0f} rank" : "on {:.0f} ranks")});
  return figures;
}

std::vector<StageTime> stage_times(const RunData& run) {
  std::vector<StageTime> times;
  const auto found = run.summary.find("timings");
  if (found == run.summary.end() || !found->is_array()) return times;
  for (const auto& t : *found) {
    times.push_back({.stage = fmt::format("{}, {}", t.value("stage", 0), t.value("name", "")),
                     .beads = t.value("beads_s", 0.0),
                     .coupling = t.value("coupling_s", 0.0),
                     .liquid = t.value("liquid_s", 0.0),
                     .outputs = t.value("outputs_s", 0.0),
                     .all = t.value("wall_s", 0.0)});
  }
  return times;
}

}  // namespace packbed::report
