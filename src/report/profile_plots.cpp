// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "report/plots.hpp"

namespace packbed::report {
namespace {

/// A column of a profile against the middle of its slices, in mm.
Curve curve_of(const Columns& table, const std::string& along, const char* column, double factor) {
  const auto& low = table[along + "_low_m"];
  const auto& high = table[along + "_high_m"];
  const auto& values = table[column];
  Curve curve;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    curve.x.push_back(per_mm * 0.5 * (low[i] + high[i]));
    curve.y.push_back(factor * values[i]);
  }
  return curve;
}

/// At the ends of the stages of one run, or at the end of each of several runs.
Plot at_stage_ends(std::span<const RunData> runs,
                   std::vector<Profile> RunData::*profiles,
                   const std::string& along,
                   Plot plot) {
  constexpr std::size_t limit = 8;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto& all = runs[r].*profiles;
    for (const auto k : spread(all.size(), runs.size() == 1 ? limit : 1)) {
      auto curve = curve_of(all[k].table, along, "porosity", 1.0);
      const auto label = stage_end_label(runs[r], all[k].number);
      curve.label = curve_label(runs, r, label);
      curve.color = static_cast<int>(runs.size() == 1 ? plot.curves.size() : r);
      plot.add(std::move(curve));
    }
  }
  return plot;
}

struct Quantity {
  const char* title;
  const char* axis;
  const char* column;
  double factor;
};

const Quantity along_the_bed[] = {
    {"Porosity along the bed, plateaus", "porosity [-]", "porosity", 1.0},
    {"Pressure along the bed, plateaus", "pressure [bar]", "pressure_Pa", per_bar}};
const Quantity across_the_bed[] = {
    {"Velocity across the bed, plateaus", "superficial velocity [cm/h]", "superficial_velocity_m_s",
     per_cm_h},
    {"Porosity across the bed, plateaus", "porosity [-]", "porosity", 1.0}};

Plot at_plateaus(const RunData& run,
                 const std::vector<Profile>& profiles,
                 const std::string& along,
                 const Quantity& quantity) {
  Plot plot{.title = quantity.title,
            .x = {fmt::format("{} [mm]", along)},
            .y = {quantity.axis},
            .curves = {}};
  for (const auto k : spread(profiles.size(), 12)) {
    const auto& profile = profiles[k];
    if (!profile.table.has(quantity.column)) continue;
    auto curve = curve_of(profile.table, along, quantity.column, quantity.factor);
    const auto plateau = static_cast<std::size_t>(profile.number - 1);
    if (profile.number >= 1 && plateau < run.plateaus.size()) {
      curve.label = plateau_label(run, plateau);
      curve.shade = plateau_shade(run, plateau);
      if (falls(run, plateau)) curve.draw = Draw::dashed;
    } else {
      curve.label = fmt::format("plateau {}", profile.number);
    }
    plot.add(std::move(curve));
  }
  return plot;
}

}  // namespace

PlotGroup profile_plots(std::span<const RunData> runs) {
  PlotGroup group{.id = "profiles",
                  .title = "Profiles",
                  .text =
                      "Porosity in slices of the bed, beads cut exactly. z is the height above "
                      "the outlet frit; over the wall distance in the middle half of the bed."};
  group.add(at_stage_ends(
      runs, &RunData::porosity_z, "z",
      {.title = "Porosity along the bed", .x = {"z [mm]"}, .y = {"porosity [-]"}, .curves = {}}));
  group.add(at_stage_ends(runs, &RunData::porosity_wall, "wall_distance",
                          {.title = "Porosity near the wall",
                           .x = {"distance from the wall [mm]"},
                           .y = {"porosity [-]"},
                           .curves = {}}));
  if (runs.size() > 1) return group;
  for (const auto& q : along_the_bed) group.add(at_plateaus(runs[0], runs[0].plateau_z, "z", q));
  for (const auto& q : across_the_bed) {
    group.add(at_plateaus(runs[0], runs[0].plateau_across, runs[0].across, q));
  }
  return group;
}

}  // namespace packbed::report
