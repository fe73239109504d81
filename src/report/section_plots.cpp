// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <fmt/format.h>

#include "report/plots.hpp"

namespace packbed::report {
namespace {

/// Compressions of all sections, top first, at one time.
struct Row {
  double time;
  std::vector<double> compression;
};

std::vector<Row> rows_of(const Columns& sections) {
  std::vector<Row> rows;
  if (sections.empty()) return rows;
  const auto& time = sections["time_s"];
  const auto& section = sections["section"];
  const auto& compression = sections["compression"];
  for (std::size_t i = 0; i < sections.rows(); ++i) {
    if (section[i] == 1.0) rows.push_back({.time = time[i], .compression = {}});
    if (!rows.empty()) rows.back().compression.push_back(compression[i]);
  }
  return rows;
}

/// The row nearest in time to the end of each plateau.
std::vector<Row> rows_at(const std::vector<Row>& rows, std::span<const Plateau> plateaus) {
  std::vector<Row> found;
  if (rows.empty()) return found;
  for (const auto& plateau : plateaus) {
    auto at = std::ranges::lower_bound(rows, plateau.time, {}, &Row::time);
    if (at == rows.end() ||
        (at != rows.begin() && plateau.time - std::prev(at)->time < at->time - plateau.time)) {
      --at;
    }
    found.push_back(*at);
  }
  return found;
}

Curve against_section(const Row& row) {
  Curve curve;
  for (std::size_t k = 0; k < row.compression.size(); ++k) {
    curve.x.push_back(static_cast<double>(k + 1));
    curve.y.push_back(100.0 * row.compression[k]);
  }
  curve.draw = Draw::line_with_points;
  return curve;
}

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
    for (const auto& branch : branches(run.plateaus)) {
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
    return group;
  }
  const auto rows = rows_at(rows_of(runs[0].sections), runs[0].plateaus);
  if (rows.empty()) return group;
  group.add(each_plateau(runs[0], rows));
  group.add(each_section(runs[0], rows));
  return group;
}

}  // namespace packbed::report
