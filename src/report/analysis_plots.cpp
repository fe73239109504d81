// SPDX-License-Identifier: BSD-3-Clause
// Plots of what `packbed analyze` found in the frames of runs.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/plots.hpp"

namespace packbed::report {
namespace {

/// One table per frame: a column of it against another.
struct OfFrames {
  const char* title = "";
  Axis x;
  Axis y;
  std::vector<Profile> RunData::*tables = nullptr;
  const char* low = "";  ///< columns whose mean is x
  const char* high = "";
  const char* column = "";
  double per_x = 1.0;  ///< from SI to the unit of the axis
  double per_y = 1.0;
};

const OfFrames of_forces[] = {{"Forces between beads",
                               {"F / <F>"},
                               {.label = "probability density", .logarithmic = true},
                               &RunData::forces,
                               "force_low",
                               "force_high",
                               "density"},
                              {"Where contacts point",
                               {"angle to the cross-section [deg]"},
                               {"density over isotropic"},
                               &RunData::angles,
                               "angle_low_deg",
                               "angle_high_deg",
                               "density"},
                              {"Where forces point",
                               {"angle to the cross-section [deg]"},
                               {"mean force over <F>"},
                               &RunData::angles,
                               "angle_low_deg",
                               "angle_high_deg",
                               "mean_force"},
                              {"Contacts above 3 <F>",
                               {"angle to the cross-section [deg]"},
                               {"share of the contacts there [%]"},
                               &RunData::angles,
                               "angle_low_deg",
                               "angle_high_deg",
                               "share_above_3",
                               1.0,
                               100.0},
                              {"Axial stress of the beads",
                               {"z [mm]"},
                               {"stress [bar]"},
                               &RunData::stress,
                               "z_low_m",
                               "z_high_m",
                               "stress_zz_Pa",
                               per_mm,
                               per_bar},
                              {"Lateral over axial stress",
                               {"z [mm]"},
                               {"K [-]"},
                               &RunData::stress,
                               "z_low_m",
                               "z_high_m",
                               "lateral_ratio",
                               per_mm}};

const OfFrames of_liquid[] = {{"Velocity near the wall",
                               {"distance from the wall [mm]"},
                               {"axial velocity over that of the bulk"},
                               &RunData::wall_velocity,
                               "wall_distance_low_m",
                               "wall_distance_high_m",
                               "relative",
                               per_mm}};

/// A figure of each frame against its stage.
struct OfStages {
  const char* title = "";
  const char* axis = "";
  const char* column = "";
  double factor = 1.0;
  bool logarithmic = false;
};

const OfStages over_stages[] = {
    {"Unevenness of the sections", "S_mean [-]", "S_mean"},
    {"Change of the sections since packing", "S_init [-]", "S_init"},
    {"Deviation of the porosity near the wall", "IPD, absolute [d]", "IPD_absolute_d"},
    {"Variance of the liquid's velocity", "sigma_z2 [cm2/s2]", "sigma_z2_m2_s2", 1e4},
    {"Variation of the liquid's velocity", "standard deviation / mean [-]", "velocity_variation"},
    {"Contacts above 6 <F>", "share [%]", "share_above_6", 100.0},
    {"Wall friction", "share of the load on the wall [%]", "wall_share", 100.0},
    {"Contacts without rattlers", "contacts per bead [-]", "coordination_without_rattlers"},
    {"Largest overlap of beads", "overlap / smaller diameter [%]", "largest_overlap", 100.0},
    {"Granular temperature", "T [m2/s2]", "granular_temperature_m2_s2", 1.0, true}};

/// Place of a frame's row in analysis.csv.
std::optional<std::size_t> row_of(const RunData& run, int frame) {
  if (run.analysis.empty()) return std::nullopt;
  const auto& frames = run.analysis["frame"];
  const auto found = std::ranges::find(frames, static_cast<double>(frame));
  if (found == frames.end()) return std::nullopt;
  return static_cast<std::size_t>(found - frames.begin());
}

std::string frame_label(const RunData& run, int frame) {
  const auto row = row_of(run, frame);
  if (!row) return fmt::format("frame {}", frame);
  return stage_end_label(run, static_cast<int>(run.analysis["stage"][*row]));
}

Curve curve_of(const Columns& table, const OfFrames& of) {
  Curve curve;
  const auto& low = table[of.low];
  const auto& high = table[of.high];
  const auto& values = table[of.column];
  for (std::size_t i = 0; i < table.rows(); ++i) {
    curve.x.push_back(of.per_x * 0.5 * (low[i] + high[i]));
    curve.y.push_back(of.per_y * values[i]);
  }
  return curve;
}

/// The tables to draw: of one run some stages; of several the end of packing or the last frame.
std::vector<std::size_t> chosen(const RunData& run,
                                const std::vector<Profile>& tables,
                                bool one_run,
                                bool at_packing) {
  constexpr std::size_t limit = 8;
  if (one_run) return spread(tables.size(), limit);
  if (!at_packing) return spread(tables.size(), 1);
  for (std::size_t k = 0; k < tables.size(); ++k) {
    const auto row = row_of(run, tables[k].number);
    if (row && run.analysis["stage"][*row] == run.analysis["packing_end"][*row]) return {k};
  }
  return {};
}

Plot frame_plot(const OfFrames& of, std::span<const RunData> runs, bool at_packing) {
  const bool one_run = runs.size() == 1;
  Plot plot{.title = of.title, .x = of.x, .y = of.y, .curves = {}};
  if (!one_run) plot.title += at_packing ? ", after packing" : ", at the end";
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto& tables = runs[r].*of.tables;
    for (const auto k : chosen(runs[r], tables, one_run, at_packing)) {
      if (!tables[k].table.has(of.column)) continue;
      auto curve = curve_of(tables[k].table, of);
      curve.label = curve_label(runs, r, frame_label(runs[r], tables[k].number));
      curve.color = static_cast<int>(one_run ? plot.curves.size() : r);
      plot.add(std::move(curve));
    }
  }
  return plot;
}

void add_frame_plots(PlotGroup& group,
                     std::span<const OfFrames> plots,
                     std::span<const RunData> runs) {
  for (const auto& of : plots) {
    if (runs.size() > 1) group.add(frame_plot(of, runs, true));
    group.add(frame_plot(of, runs, false));
  }
}

/// The axis without its unit.
std::string short_name(const OfStages& of) {
  const std::string axis = of.axis;
  return axis.substr(0, axis.find(" ["));
}

/// Of one run against its stages; of several against stages since packing was over, which lays cycles of different
/// methods over each other.
Plot stage_plot(const OfStages& of, std::span<const RunData> runs) {
  const bool one_run = runs.size() == 1;
  Plot plot{.title = of.title,
            .x = {.label = one_run ? "stage" : "stages after packing", .whole_numbers = true},
            .y = {.label = of.axis, .logarithmic = of.logarithmic},
            .curves = {}};
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto& table = runs[r].analysis;
    if (table.rows() < 2 || !table.has(of.column)) continue;
    Curve curve{.label = curve_label(runs, r, one_run ? short_name(of) : ""), .x = {}, .y = {}};
    curve.draw = Draw::line_with_points;
    curve.color = static_cast<int>(r);
    for (std::size_t i = 0; i < table.rows(); ++i) {
      curve.x.push_back(table["stage"][i] - (one_run ? 0.0 : table["packing_end"][i]));
      curve.y.push_back(of.factor * table[of.column][i]);
    }
    plot.add(std::move(curve));
  }
  return plot;
}

}  // namespace

PlotGroup force_plots(std::span<const RunData> runs) {
  PlotGroup group{
      .id = "forces",
      .title = "Forces in the bed",
      .text =
          "Normal forces between beads at the ends of stages, <F> their mean. 0 degrees is "
          "lateral, 90 axial; an isotropic bed has density 1 at all angles. Stresses are "
          "positive where they press; beads alone, without the pressure of the liquid."};
  add_frame_plots(group, of_forces, runs);
  return group;
}

std::vector<Rose> direction_roses(std::span<const RunData> runs) {
  Rose contacts{.title = "Directions of contacts", .radius = "density of contacts, 1 if isotropic"};
  Rose forces{.title = "Directions of forces",
              .radius = "density of contacts times their mean force over <F>, 1 if isotropic"};
  const bool one_run = runs.size() == 1;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    for (const auto k : chosen(runs[r], runs[r].angles, one_run, false)) {
      const auto& [frame, table] = runs[r].angles[k];
      const auto& density = table["density"];
      const auto& force = table["mean_force"];
      Curve curve{
          .label = curve_label(runs, r, frame_label(runs[r], frame)), .x = {}, .y = density};
      curve.color = static_cast<int>(one_run ? contacts.curves.size() : r);
      for (std::size_t i = 0; i < table.rows(); ++i) {
        curve.x.push_back(0.5 * (table["angle_low_deg"][i] + table["angle_high_deg"][i]));
      }
      contacts.curves.push_back(curve);
      for (std::size_t i = 0; i < table.rows(); ++i) curve.y[i] = density[i] * force[i];
      forces.curves.push_back(std::move(curve));
    }
  }
  return {std::move(contacts), std::move(forces)};
}

PlotGroup evenness_plots(std::span<const RunData> runs) {
  PlotGroup group{
      .id = "evenness",
      .title = "How even the bed is",
      .text =
          "At the ends of stages. S_mean: spread of the packing densities of the sections; S_init: "
          "their change since packing was over; IPD: porosity near the wall against that of the "
          "bulk, both walls."};
  for (const auto& run : runs) {
    const auto& table = run.analysis;
    if (table.empty() || !std::isfinite(table["D_over_d_eff"].front())) continue;
    group.text +=
        fmt::format(" {}column over grain diameter {:.1f}.",
                    runs.size() > 1 ? run.label + ": " : "What depends on the wall belongs to a ",
                    table["D_over_d_eff"].front());
  }
  for (const auto& of : over_stages) group.add(stage_plot(of, runs));
  add_frame_plots(group, of_liquid, runs);
  return group;
}

}  // namespace packbed::report
