// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numeric>

#include "continuum/packed_bed.hpp"
#include "report/plots.hpp"

namespace packbed::report {
namespace {

/// One of the plots against velocity: what of a plateau, what of a measured table.
struct Against {
  const char* title = "";
  const char* axis = "";
  double Plateau::*simulated = nullptr;
  std::vector<double> setup::MeasuredFlow::*measured = nullptr;
  double factor = 1.0;  ///< from SI to the unit of the axis
  bool logarithmic = false;
};

const Against against_velocity[] = {
    {"Pressure drop", "pressure drop [bar]", &Plateau::pressure_drop,
     &setup::MeasuredFlow::pressure_drop, per_bar},
    {"Pressure drop per present bed height", "pressure drop per height [bar/m]",
     &Plateau::pressure_gradient, &setup::MeasuredFlow::pressure_gradient, per_bar},
    {"Compression", "compression [%]", &Plateau::compression, &setup::MeasuredFlow::compression,
     100.0},
    {"Bed height", "bed height [mm]", &Plateau::bed_height, &setup::MeasuredFlow::bed_height,
     per_mm},
    {"Noise of the pressure drop", "standard deviation / mean [-]", &Plateau::pressure_noise,
     nullptr, 1.0, true}};

void add_simulated(Plot& plot, const Against& a, std::span<const RunData> runs, std::size_t r) {
  const auto& plateaus = runs[r].plateaus;
  for (const auto& branch : shown_branches(plateaus)) {
    Curve curve{.label = curve_label(runs, r, branch.name), .x = {}, .y = {}};
    curve.draw = branch.rises ? Draw::line_with_points : Draw::dashed_with_points;
    curve.color = static_cast<int>(r);
    for (const auto i : branch.plateaus) {
      curve.x.push_back(per_cm_h * plateaus[i].velocity);
      curve.y.push_back(a.factor * plateaus[i].*a.simulated);
    }
    plot.add(std::move(curve));
  }
}

void add_kozeny_carman(Plot& plot, double slope, std::span<const RunData> runs, std::size_t r) {
  double low = 0.0;
  double high = 0.0;
  for (const auto& p : runs[r].plateaus) {
    low = std::min(low, p.velocity);
    high = std::max(high, p.velocity);
  }
  Curve curve{.label = curve_label(runs, r, "Kozeny-Carman"), .x = {}, .y = {}};
  curve.draw = Draw::dotted;
  curve.color = runs.size() == 1 ? gray : static_cast<int>(r);
  constexpr int pieces = 40;  // so that there is always a point near the pointer
  for (int k = 0; k <= pieces; ++k) {
    const double velocity = low + (high - low) * k / pieces;
    curve.x.push_back(per_cm_h * velocity);
    curve.y.push_back(slope * velocity);
  }
  plot.add(std::move(curve));
}

void add_measured(Plot& plot, const Against& a, std::span<const RunData> runs, std::size_t r) {
  const auto& measured = runs[r].measured;
  if (!measured || a.measured == nullptr) return;
  const bool is_there_already =
      std::ranges::any_of(runs.first(r), [&](const RunData& b) { return b.measured == measured; });
  if (is_there_already) return;
  const auto& values = (*measured).*a.measured;
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {},
                           [&](std::size_t i) { return measured->superficial_velocity[i]; });
  const bool is_the_same_for_all =
      std::ranges::all_of(runs, [&](const RunData& b) { return b.measured == measured; });
  Curve curve{.label = is_the_same_for_all ? "measured" : curve_label(runs, r, "measured"),
              .x = {},
              .y = {}};
  curve.draw = Draw::points;
  curve.color = runs.size() == 1 ? 1 : is_the_same_for_all ? gray : static_cast<int>(r);
  for (const auto i : order) {
    curve.x.push_back(per_cm_h * measured->superficial_velocity[i]);
    curve.y.push_back(a.factor * values[i]);
  }
  plot.add(std::move(curve));
}

/// What a pressure follows in an uncompressed bed, per velocity, in the unit of the axis.
std::optional<double> kozeny_carman_slope(const Against& a, const RunData& run) {
  const auto resistance = kozeny_carman_resistance(run);
  if (!resistance) return std::nullopt;
  if (a.simulated == &Plateau::pressure_gradient) return a.factor * *resistance;
  if (a.simulated != &Plateau::pressure_drop) return std::nullopt;
  return a.factor * *resistance * *run.number("/settled_height_m");
}

}  // namespace

std::optional<double> kozeny_carman_resistance(const RunData& run) {
  const auto porosity = run.number("/settled_porosity");
  const auto height = run.number("/settled_height_m");
  const auto sauter = run.number("/figures/sizes/sauter_diameter_m");
  const auto viscosity = run.number("/figures/liquid/viscosity_Pa_s");
  if (!porosity || !height || !sauter || !viscosity || !(*porosity > 0.0)) return std::nullopt;
  // A bead file has the grains.
  const Json& values = run.values;
  const bool has_grains = values.contains("/beads/csv"_json_pointer);
  const auto grain = values.value("/resin/coarse_grain"_json_pointer, 1.0);
  return continuum::kozeny_carman_gradient(*porosity, has_grains ? *sauter / grain : *sauter,
                                           *viscosity, 1.0);
}

PlotGroup flow_plots(std::span<const RunData> runs) {
  PlotGroup group{.id = "flow",
                  .title = "Pressure and flow",
                  .text =
                      "Each point is the end of a plateau of the flow. The Kozeny-Carman line is "
                      "that of the settled bed, not compressed, with its measured porosity and "
                      "the Sauter mean diameter of the beads."};
  for (const auto& a : against_velocity) {
    Plot plot{.title = a.title,
              .x = {"superficial velocity [cm/h]"},
              .y = {.label = a.axis, .logarithmic = a.logarithmic},
              .curves = {}};
    for (std::size_t r = 0; r < runs.size(); ++r) {
      add_simulated(plot, a, runs, r);
      if (const auto slope = kozeny_carman_slope(a, runs[r]); slope && !runs[r].plateaus.empty()) {
        add_kozeny_carman(plot, *slope, runs, r);
      }
      add_measured(plot, a, runs, r);
    }
    group.add(std::move(plot));
  }
  return group;
}

}  // namespace packbed::report
