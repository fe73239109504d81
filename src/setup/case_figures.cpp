// SPDX-License-Identifier: BSD-3-Clause
#include "setup/case_figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "continuum/packed_bed.hpp"
#include "setup/make_dem.hpp"

namespace packbed::setup {
namespace {

// Measured at the peak of runs (docs/performance.md, "Memory").
constexpr double bytes_per_bead = 1100.0;
constexpr double bytes_per_bead_with_frames = 1700.0;

double sphere(double diameter) { return std::numbers::pi / 6.0 * std::pow(diameter, 3); }

void collect(const std::vector<ProtocolStep>& steps,
             std::optional<Settle>& first_settle,
             double& highest_velocity) {
  for (const auto& step : steps) {
    if (const auto* settle = std::get_if<Settle>(&step.what)) {
      if (!first_settle) first_settle = *settle;
    } else if (const auto* ramp = std::get_if<FlowRamp>(&step.what)) {
      highest_velocity = std::max({highest_velocity, std::abs(ramp->from), std::abs(ramp->to)});
    } else if (const auto* hold = std::get_if<Hold>(&step.what)) {
      highest_velocity = std::max(highest_velocity, std::abs(hold->flow.value_or(0.0)));
    } else if (const auto* repeat = std::get_if<Repeat>(&step.what)) {
      collect(repeat->steps, first_settle, highest_velocity);
    }
  }
}

double run_time(const std::vector<ProtocolStep>& steps) {
  double sum = 0.0;
  for (const auto& step : steps) {
    if (const auto* run = std::get_if<Run>(&step.what)) sum += run->duration;
    if (const auto* repeat = std::get_if<Repeat>(&step.what)) {
      sum += static_cast<double>(repeat->count) * run_time(repeat->steps);
    }
  }
  return sum;
}

resin::SizeDistribution sizes_of(const Case& c) {
  if (c.resin.sizes) return *c.resin.sizes;
  return resin::Measured::from(c.beads.table.diameter);
}

double mass_of_file(const Case& c) {
  const auto& table = c.beads.table;
  double mass = 0.0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double density = table.density.empty() ? *c.resin.density : table.density[i];
    mass += density * sphere(table.diameter[i]);
  }
  return mass;
}

MeshFigures mesh_figures(const mesh::ColumnShape& shape, const mesh::MeshOptions& options) {
  const auto counts = mesh::cell_counts(shape, options);
  const auto cells = static_cast<double>(counts.per_layer());
  return {.counts = counts,
          .cell_across = std::sqrt(mesh::cross_section(shape) / cells),
          .cell_height = mesh::height(shape) / counts.layers,
          .quality = mesh::quality({shape, counts})};
}

FlowFigures flow_figures(
    const LiquidOptions& liquid, const BedFigures& bed, double rho_p, double d32, double velocity) {
  const double gradient =
      continuum::kozeny_carman_gradient(bed.porosity, d32, liquid.viscosity, velocity);
  return {.highest_velocity = velocity,
          .reynolds = continuum::bed_reynolds(liquid.density, velocity, d32, liquid.viscosity,
                                              bed.porosity),
          .stokes = continuum::flow_stokes(rho_p, d32, liquid.viscosity, velocity),
          .pressure_gradient = gradient,
          .pressure_drop = gradient * bed.height};
}

}  // namespace

CaseFigures figures(const Case& c) {
  std::optional<Settle> settle;
  double velocity = 0.0;
  collect(c.protocol, settle, velocity);

  CaseFigures f{};
  f.sizes = resin::statistics(sizes_of(c));
  const double grain = c.beads.csv ? 1.0 : c.resin.coarse_grain;
  f.largest_grain = grain * f.sizes.largest;
  const double grain_volume = sphere(grain * f.sizes.volume_mean);
  const double area = mesh::cross_section(c.column.shape);

  if (settle) {
    f.bed = BedFigures{.height = settle->bed_height.value_or(0.0),
                       .porosity = settle->porosity.value_or(assumed_porosity),
                       .porosity_is_set = settle->porosity.has_value()};
  }
  if (c.beads.csv) {
    f.bead_count = static_cast<double>(c.beads.table.size());
  } else if (c.beads.run) {
    f.bead_count = static_cast<double>(c.beads.beads_of_run);
  } else if (c.beads.count) {
    f.bead_count = static_cast<double>(*c.beads.count);
  } else if (f.bed) {
    f.bead_count = std::round((1.0 - f.bed->porosity) * area * f.bed->height / grain_volume);
  }
  f.bead_volume = f.bead_count * grain_volume;
  f.bead_mass = c.beads.csv ? mass_of_file(c) : f.bead_volume * c.resin.density.value_or(0.0);
  f.real_bead_count = f.bead_count * std::pow(c.resin.coarse_grain, 3);
  if (f.bed && f.bed->height == 0.0) {
    f.bed->height = f.bead_volume / ((1.0 - f.bed->porosity) * area);
  }
  if (c.liquid && c.numerics.gravity)
    f.submerged_weight = (f.bead_mass - c.liquid->density * f.bead_volume) * gravity;
  if (c.liquid && f.bed && velocity > 0.0 && f.bead_volume > 0.0) {
    f.flow = flow_figures(*c.liquid, *f.bed, f.bead_mass / f.bead_volume, f.sizes.sauter, velocity);
  }
  if (c.column.mesh) f.mesh = mesh_figures(c.column.shape, *c.column.mesh);
  f.step = step_of(c);
  f.run_time = run_time(c.protocol);
  f.memory = f.bead_count * bytes_per_bead;
  f.memory_with_frames = c.output.frames ? f.bead_count * bytes_per_bead_with_frames : f.memory;
  return f;
}

}  // namespace packbed::setup
