// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <fmt/format.h>

#include "report/plots.hpp"

namespace packbed::report {
namespace {

/// All sections, top first, at one time.
struct Row {
  double time;
  std::vector<double> compression;
  std::vector<double> density{};
};

std::vector<Row> rows_of(const Columns& sections) {
  std::vector<Row> rows;
  if (sections.empty()) return rows;
  const auto& time = sections["time_s"];
  const auto& section = sections["section"];
  const auto& compression = sections["compression"];
  const auto& density = sections["packing_density"];
  for (std::size_t i = 0; i < sections.rows(); ++i) {
    if (section[i] == 1.0) rows.push_back({.time = time[i], .compression = {}});
    if (rows.empty()) continue;
    rows.back().compression.push_back(compression[i]);
    rows.back().density.push_back(density[i]);
  }
  return rows;
}

/// The row nearest to a time. A bed that has settled has two at one instant: the last one counts.
const Row& row_at(const std::vector<Row>& rows, double time) {
  auto at = std::ranges::upper_bound(rows, time, {}, &Row::time);
  if (at == rows.end() || (at != rows.begin() && time - std::prev(at)->time < at->time - time))
    --at;
  return *at;
}

/// The row nearest in time to the end of each plateau.
std::vector<Row> rows_at(const std::vector<Row>& rows, std::span<const Plateau> plateaus) {
  std::vector<Row> found;
  if (rows.empty()) return found;
  for (const auto& plateau : plateaus) found.push_back(row_at(rows, plateau.time));
  return found;
}

Curve over_sections(const std::vector<double>& values, double factor) {
  Curve curve;
  for (std::size_t k = 0; k < values.size(); ++k) {
    curve.x.push_back(static_cast<double>(k + 1));
    curve.y.push_back(factor * values[k]);
  }
  curve.draw = Draw::line_with_points;
  return curve;
}

Curve against_section(const Row& row) { return over_sections(row.compression, 100.0); }

Plot plot_against_section(const char* title) {
  return {.title = title,
          .x = {.label = "section (1 = top)", .whole_numbers = true},
          .y = {"compression [%]"},
          .curves = {}};
}

Plot each_plateau(const RunData& run, const std::vector<Row>& rows) {
  auto plot = plot_against_section("Sections at each plateau");
  for (const auto i : spread(rows.size(), 12)) {
    auto curve = against_section(rows[i]);
    curve.label = plateau_label(run, i);
    curve.shade = plateau_shade(run, i);
    if (falls(run, i)) curve.draw = Draw::dashed_with_points;
    plot.add(std::move(curve));
  }
  return plot;
}

Plot each_section(const RunData& run, const std::vector<Row>& rows) {
  Plot plot{.title = "Each section up and down",
            .x = {"superficial velocity [cm/h]"},
            .y = {"compression [%]"},
            .curves = {}};
  const auto sections = rows.front().compression.size();
  for (std::size_t k = 0; k < sections; ++k) {
    for (const auto& branch : shown_branches(run.plateaus)) {
      Curve curve{.label = fmt::format("{}{} {}", k + 1, k == 0 ? " (top)" : "", branch.name),
                  .x = {},
                  .y = {}};
      curve.draw = branch.rises ? Draw::line_with_points : Draw::dashed_with_points;
      curve.shade = sections > 1 ? static_cast<double>(k) / static_cast<double>(sections - 1) : 0.0;
      for (const auto i : branch.plateaus) {
        const auto& row = rows[i].compression;
        curve.x.push_back(per_cm_h * run.plateaus[i].velocity);
        curve.y.push_back(k < row.size() ? 100.0 * row[k] : unknown);
      }
      plot.add(std::move(curve));
    }
  }
  return plot;
}

Plot at_the_end(std::span<const RunData> runs) {
  auto plot = plot_against_section("Sections at the end");
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto rows = rows_of(runs[r].sections);
    if (rows.empty()) continue;
    auto curve = against_section(rows.back());
    curve.label = curve_label(runs, r, runs.size() == 1 ? "end of the run" : "");
    curve.color = static_cast<int>(r);
    plot.add(std::move(curve));
  }
  return plot;
}

/// Times at which stages end, those with sections, and their numbers.
struct StageEnd {
  int stage;
  double time;
};
std::vector<StageEnd> stage_ends(const RunData& run, const std::vector<Row>& rows) {
  std::vector<StageEnd> ends;
  if (rows.empty()) return ends;
  const auto& stage = run.series["stage"];
  const auto& time = run.series["time_s"];
  for (std::size_t i = 0; i < run.series.rows(); ++i) {
    if (i + 1 < run.series.rows() && stage[i + 1] == stage[i]) continue;
    if (time[i] < rows.front().time) continue;
    ends.push_back({static_cast<int>(stage[i]), time[i]});
  }
  return ends;
}

/// At the ends of the stages of one run, or at the end of each of several.
Plot densities(std::span<const RunData> runs) {
  constexpr std::size_t limit = 8;
  const bool one_run = runs.size() == 1;
  Plot plot{.title = one_run ? "Packing density of the sections" : "Packing density at the end",
            .x = {.label = "section (1 = top)", .whole_numbers = true},
            .y = {"packing density [-]"},
            .curves = {}};
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto rows = rows_of(runs[r].sections);
    const auto ends = stage_ends(runs[r], rows);
    for (const auto k : spread(ends.size(), one_run ? limit : 1)) {
      auto curve = over_sections(row_at(rows, ends[k].time).density, 1.0);
      curve.label = curve_label(runs, r, stage_end_label(runs[r], ends[k].stage));
      curve.color = static_cast<int>(one_run ? plot.curves.size() : r);
      plot.add(std::move(curve));
    }
  }
  return plot;
}

Plot at_the_highest_flow(std::span<const RunData> runs) {
  auto plot = plot_against_section("Sections at the highest flow");
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto& plateaus = runs[r].plateaus;
    const auto rows = rows_at(rows_of(runs[r].sections), plateaus);
    if (rows.empty()) continue;
    const auto highest = highest_flow(plateaus);
    auto curve = against_section(rows[highest]);
    curve.label =
        curve_label(runs, r, fmt::format("{:.4g} cm/h", per_cm_h * plateaus[highest].velocity));
    curve.color = static_cast<int>(r);
    plot.add(std::move(curve));
  }
  return plot;
}

}  // namespace

PlotGroup section_plots(std::span<const RunData> runs) {
  PlotGroup group{.id = "sections",
                  .title = "Sections of the bed",
                  .text =
                      "The settled bed cut into slices of equal height that move with their "
                      "beads; section 1 is at the top."};
  if (runs.size() > 1) {
    group.add(at_the_highest_flow(runs));
    group.add(at_the_end(runs));
    group.add(densities(runs));
    return group;
  }
  const auto rows = rows_at(rows_of(runs[0].sections), runs[0].plateaus);
  if (!rows.empty()) {
    group.add(each_plateau(runs[0], rows));
    group.add(each_section(runs[0], rows));
  }
  group.add(densities(runs));
  return group;
}

}  // namespace packbed::report
