// SPDX-License-Identifier: BSD-3-Clause
// What stays between two exchanges of beads and liquid: the flux of both, or the velocity of the liquid. A bed of 300
// grains at rest at 500 cm/h, no scaled inertia; the flow jumps to 550 cm/h. Noise of the pressure drop against the
// interval, and the largest interval that each scheme bears. The judgement draws schemes.svg beside the tables.
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include <fmt/format.h>

#include "column/coupled_bed.hpp"
#include "column/protocol/bed_look.hpp"
#include "core/error.hpp"
#include "io/plot.hpp"
#include "tests/support/settling.hpp"
#include "validation/support/validation.hpp"

namespace packbed::validation {
namespace {

using namespace test;  // NOLINT

constexpr mesh::Slice slice{.inner_diameter = 2e-3, .depth = 0.7e-3, .height = 5e-3};
constexpr double cm_h = 0.01 / 3600.0;
constexpr std::array<double, 10> intervals = {1e-5, 2e-5, 5e-5, 1e-4, 2e-4,
                                              5e-4, 1e-3, 2e-3, 4e-3, 8e-3};  // [s]
constexpr double quiet = 1e-2;   ///< noise below which a scheme counts as stable
constexpr double thrown = 10.0;  ///< noise of a bed that is thrown about, or of a run that stopped

column::CoupledBed liquid(coupling::Scheme scheme) {
  const mesh::ColumnMesh mesh(slice, mesh::cell_counts(slice, {}));
  column::CoupledOptions o;
  o.coupling.scheme = scheme;
  o.coupling.widths = {.reach = 0.75e-3, .reach_z = 0.75e-3};
  return {mesh, slice, o, Ranks::alone()};
}

void advance(column::CoupledBed& bed, dem::Dem& dem, double interval) {
  const auto count = static_cast<std::int64_t>(std::ceil(interval / dem.options().step - 1e-9));
  bed.advance(dem, count);
}

double height(const dem::Dem& dem) {
  return column::look_at_bed(dem, mesh::cross_section(slice)).height;
}

/// Largest second difference of the pressure drop over its mean, in 60 intervals after 20.
double noise(const dem::Dem& start,
             const fluid::FluidState& state,
             coupling::Scheme scheme,
             double interval) {
  dem::Dem dem(start.options(), start.state(), dem::Dem::Lists::as_saved);
  auto bed = liquid(scheme);
  bed.load(state, dem);
  bed.set_flow(fluid::FlowProgram::steady(550 * cm_h));
  const double steps = std::ceil(interval / dem.options().step);
  dem.set_step(interval / steps);
  std::vector<double> drops;
  try {
    for (int k = 0; k < 80; ++k) {
      advance(bed, dem, interval);
      if (k >= 20) drops.push_back(bed.figures().pressure_drop);
    }
  } catch (const DivergenceError&) {
    return thrown;
  }
  if (std::abs(height(dem) / height(start) - 1.0) > 0.02) return thrown;
  double worst = 0.0;
  for (std::size_t k = 2; k < drops.size(); ++k) {
    worst = std::max(worst, std::abs(drops[k] - 2.0 * drops[k - 1] + drops[k - 2]));
  }
  return std::min(thrown, worst / std::abs(mean(drops)));
}

Table noises(coupling::Scheme scheme) {
  auto s = cloud_of(300, 0.1);
  column::Settle settle(s.options, s.start);
  while (settle.advance(s.dem)) {}
  s.dem.set_background_damping(0.0);
  auto bed = liquid(coupling::Scheme::frozen_flux);
  bed.start(s.dem);
  bed.set_flow(fluid::FlowProgram::steady(500 * cm_h));
  for (int k = 0; k < 300; ++k) advance(bed, s.dem, 1e-3);
  Table table{.columns = {"interval_s", "noise"}, .rows = {}};
  for (const double interval : intervals) {
    table.rows.push_back({interval, noise(s.dem, bed.save(), scheme, interval)});
  }
  return table;
}

std::vector<double> column_of(const Table& table, std::size_t k) {
  std::vector<double> values;
  for (const auto& row : table.rows) values.push_back(row[k]);
  return values;
}

/// Up to which interval all are quiet [s]; 0: none is.
double largest_stable(const Table& table) {
  double largest = 0.0;
  for (const auto& row : table.rows) {
    if (row[1] > quiet) break;
    largest = row[0];
  }
  return largest;
}

void draw(const Table& flux, const Table& velocity) {
  std::vector<double> milliseconds;
  for (const double t : intervals) milliseconds.push_back(1e3 * t);
  std::ofstream("schemes.svg") << io::plot_svg(
      {{.title = "Pressure noise of a bed of 300 grains",
        .x = {.label = "interval between exchanges [ms]", .logarithmic = true},
        .y = {.label = "second difference / pressure drop", .logarithmic = true},
        .series = {{.label = "flux frozen", .x = milliseconds, .y = column_of(flux, 1)},
                   {.label = "velocity frozen", .x = milliseconds, .y = column_of(velocity, 1)}},
        .notes = {"10: thrown about, or stopped"}}},
      1);
}

std::vector<Check> judge(const Results& results) {
  if (!results.contains("flux") || !results.contains("velocity")) return {};
  const auto& flux = results.at("flux");
  const auto& velocity = results.at("velocity");
  draw(flux, velocity);
  return {{"flux frozen: largest stable interval [ms]", 1e3 * largest_stable(flux), 8.0, 1e9,
           "the longest that was tried"},
          {"velocity frozen: largest stable interval [ms]", 1e3 * largest_stable(velocity), 0.01,
           0.5, "docs/theory/coupling.md, section 5"}};
}

}  // namespace
}  // namespace packbed::validation

int main(int argc, char** argv) {
  using namespace packbed;  // NOLINT
  const validation::Validation all{
      .pieces = {{"flux", [] { return validation::noises(coupling::Scheme::frozen_flux); }},
                 {"velocity",
                  [] { return validation::noises(coupling::Scheme::frozen_velocity); }}},
      .judge = validation::judge};
  return validation::validation_main(argc, argv, all);
}
