// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "report/plots.hpp"

namespace packbed::report {
namespace {

/// By the place of the plunger, over the height of the settled bed.
constexpr auto compression_column = "plunger_compression";

/// A column of series.csv against compression.
struct AgainstCompression {
  const char* title;
  const char* axis;
  const char* column;
  double factor;
};

const AgainstCompression plots[] = {
    {"Plunger force", "force on the plunger [N]", "plunger_force_N", 1.0},
    {"Plunger pressure", "force over cross-section [bar]", "plunger_pressure_Pa", per_bar}};

constexpr std::size_t row_limit = 1000;  ///< of a stage: more than a screen shows

/// Compression by which a plunger that stands may differ: round-off of its place.
constexpr double standing = 1e-6;

/// Rows of a stage in which the plunger presses, from the lowest compression to the highest.
struct Stroke {
  int stage = 0;
  bool rises = true;
  std::vector<std::size_t> rows;
};

std::vector<Stroke> strokes(const Columns& series, const char* column) {
  const auto& stage = series["stage"];
  const auto& compression = series[compression_column];
  const auto& value = series[column];
  std::vector<Stroke> all;
  for (std::size_t i = 0; i < series.rows(); ++i) {
    if (!std::isfinite(compression[i]) || !std::isfinite(value[i])) continue;
    if (value[i] == 0.0 && compression[i] < 0.0) continue;  // on its way to the bed
    if (all.empty() || all.back().stage != static_cast<int>(stage[i])) {
      all.push_back({.stage = static_cast<int>(stage[i]), .rows = {}});
    }
    all.back().rows.push_back(i);
  }
  std::erase_if(all, [&](const Stroke& s) {
    const bool is_free =
        std::ranges::all_of(s.rows, [&](std::size_t i) { return value[i] == 0.0; });
    const bool stands = std::ranges::all_of(s.rows, [&](std::size_t i) {
      return std::abs(compression[i] - compression[s.rows.front()]) < standing;
    });
    return is_free || stands;
  });
  for (auto& s : all) {
    s.rises = compression[s.rows.back()] >= compression[s.rows.front()];
    std::vector<std::size_t> drawn;
    for (const auto k : spread(s.rows.size(), row_limit)) drawn.push_back(s.rows[k]);
    std::ranges::stable_sort(drawn, {}, [&](std::size_t i) { return compression[i]; });
    s.rows = std::move(drawn);
  }
  return all;
}

Plot against_compression(const AgainstCompression& a, std::span<const RunData> runs) {
  Plot plot{.title = a.title, .x = {"compression by the plunger [%]"}, .y = {a.axis}, .curves = {}};
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto& series = runs[r].series;
    if (!series.has(a.column) || !series.has(compression_column)) continue;
    int color = 0;
    for (const auto& stroke : strokes(series, a.column)) {
      Curve curve{
          .label = curve_label(runs, r, stage_label(runs[r], stroke.stage)), .x = {}, .y = {}};
      curve.draw = stroke.rises ? Draw::line : Draw::dashed;
      curve.color = runs.size() == 1 ? color++ % 8 : static_cast<int>(r);
      for (const auto i : stroke.rows) {
        curve.x.push_back(100.0 * series[compression_column][i]);
        curve.y.push_back(a.factor * series[a.column][i]);
      }
      plot.add(std::move(curve));
    }
  }
  return plot;
}

}  // namespace

PlotGroup plunger_plots(std::span<const RunData> runs) {
  PlotGroup group{
      .id = "plunger",
      .title = "Plunger",
      .text =
          "What the beads press against the plunger with, against the compression of the "
          "bed, stage by stage; dashed where the bed rises."};
  for (const auto& a : plots) group.add(against_compression(a, runs));
  return group;
}

}  // namespace packbed::report
