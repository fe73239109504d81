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

std::optional<double> ratio(std::optional<double> above, std::optional<double> below) {
  if (!above || !below || *below == 0.0) return std::nullopt;
  return *above / *below;
}

std::optional<double> compression(std::optional<double> height, std::optional<double> settled) {
  const auto share = ratio(height, settled);
  if (!share) return std::nullopt;
  return 1.0 - *share;
}

/// Steps that have a flow; the summary of a run that has none tells of a flow of zero.
std::optional<double> highest_velocity(const RunData& run) {
  const auto velocity = run.number("/highest_superficial_velocity_m_s");
  return velocity && *velocity != 0.0 ? velocity : std::nullopt;
}

std::string kozeny_carman_note(const RunData& run) {
  const auto resistance = kozeny_carman_resistance(run);
  const auto velocity = highest_velocity(run);
  if (!resistance || !velocity) return {};
  return written(*resistance * *velocity, per_bar, "Kozeny-Carman, settled bed: {:.4g} bar/m");
}

void add_flow(const RunData& run, std::vector<KeyFigure>& figures) {
  const auto velocity = highest_velocity(run);
  const auto drop = velocity ? run.number("/pressure_drop_at_highest_flow_Pa") : std::nullopt;
  const auto height = velocity ? run.number("/bed_height_at_highest_flow_m") : std::nullopt;
  const auto settled = run.number("/settled_height_m");
  const auto gradient = ratio(drop, height);
  figures.push_back({"Highest superficial velocity", written(velocity, per_cm_h, "{:.4g} cm/h")});
  figures.push_back({"Pressure drop there", written(drop, per_bar, "{:.4g} bar")});
  figures.push_back({"Per present bed height", written(gradient, per_bar, "{:.4g} bar/m"),
                     kozeny_carman_note(run)});
  figures.push_back(
      {"Compression there", written(compression(height, settled), 100.0, "{:.2f} %")});
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
  figures.push_back({"Simulated time", written(run.number("/simulated_time_s"), 1.0, "{:.4g} s")});
  figures.push_back({"Wall time", written(run.number("/wall_time_s"), 1.0, "{:.4g} s"),
                     written(run.number("/ranks"), 1.0, "on {:.0f} ranks")});
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
