// SPDX-License-Identifier: BSD-3-Clause
#include "setup/make_liquid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "resin/size_statistics.hpp"
#include "setup/make_dem.hpp"

namespace packbed::setup {
namespace {

/// Mean diameter of the grains, Sauter mean of the beads that they stand for [m].
struct Sizes {
  double grain = 0.0;
  double bead_sauter = 0.0;
};

Sizes sizes_of(const Case& c) {
  if (c.resin.sizes) {
    const auto s = resin::statistics(*c.resin.sizes);
    return {c.resin.coarse_grain * s.mean, s.sauter};
  }
  std::array<double, 4> moments{};
  for (const double d : c.beads.table.diameter) {
    double power = 1.0;
    for (auto& m : moments) {
      m += power;
      power *= d;
    }
  }
  return {moments[1] / moments[0], moments[3] / moments[2] / c.resin.coarse_grain};
}

/// A property of the beads: that of the bead file, its mean, or that of the resin.
double mean(const std::optional<double>& resin, const std::vector<double>& column) {
  if (column.empty()) return *resin;
  return std::accumulate(column.begin(), column.end(), 0.0) / static_cast<double>(column.size());
}

fluid::Boundaries boundaries_of(const mesh::ColumnShape& shape) {
  fluid::Boundaries b;
  const auto* box = std::get_if<mesh::Box>(&shape);
  if (box == nullptr) return b;
  const auto side = [&](std::size_t axis) -> fluid::BoundaryCondition {
    if (box->boundaries[axis] == mesh::Boundary::wall) return fluid::Wall{};
    return fluid::Empty{};  // open, or periodic of a single cell
  };
  b.x_low = b.x_high = side(0);
  b.y_low = b.y_high = side(1);
  return b;
}

/// Force over overlap of a contact of two mean grains, at an overlap of a hundredth of a diameter [N/m].
double stiffness_of(const Case& c, double grain) {
  const auto& t = c.beads.table;
  const dem::Material material{.youngs_modulus = mean(c.resin.youngs_modulus, t.youngs_modulus),
                               .poisson_ratio = mean(c.resin.poisson_ratio, t.poisson_ratio)};
  const auto bead = bead_properties(c, 0, grain, mean(c.resin.density, t.density), material);
  const dem::Pair pair{.i = material,
                       .j = material,
                       .r_eff = 0.25 * grain,
                       .m_eff = 0.5 * bead.mass,
                       .m_scaled = 0.5 * bead.mass};
  const double overlap = 0.01 * grain;
  return std::visit(
      [&](const auto& law) { return law(overlap, 0.0, law.coefficients(pair)).f_n / overlap; },
      contact_model(c).contact);
}

column::FlowOptions common(const Case& c, const dem::StepChoice& step) {
  const auto sizes = sizes_of(c);
  column::FlowOptions o;
  o.interval = c.output.interval;
  o.area = mesh::cross_section(c.column.shape);
  o.coupling_interval = longest_coupling_interval;
  o.inertia_scale = c.numerics.inertia_scale;
  o.stepping = {.longest_step = step.contact_time / dem::fewest_steps_per_contact,
                .fixed_step = c.numerics.step,
                .force_step = c.numerics.force_step};
  o.grains = {.viscosity = c.liquid->viscosity,
              .density = mean(c.resin.density, c.beads.table.density),
              .bead_diameter = sizes.bead_sauter,
              .diameter = sizes.grain,
              .stiffness = stiffness_of(c, sizes.grain)};
  return o;
}

}  // namespace

column::CoupledOptions coupled_options(const Case& c) {
  const double reach = std::max(reach_in_diameters * sizes_of(c).grain, c.column.mesh->cell);
  column::CoupledOptions o;
  o.fluid.rho_f = c.liquid->density;
  o.fluid.mu_f = c.liquid->viscosity;
  o.fluid.gravity = {0.0, 0.0, c.numerics.gravity ? -gravity : 0.0};
  o.fluid.boundaries = boundaries_of(c.column.shape);
  o.coupling.coarse_grain = c.resin.coarse_grain;
  o.coupling.rho_f = c.liquid->density;
  o.coupling.mu_f = c.liquid->viscosity;
  o.coupling.widths = {.reach = reach, .reach_z = reach};
  return o;
}

column::CoupledBed make_coupled_bed(const Case& c, const Ranks& ranks) {
  const mesh::ColumnMesh mesh(c.column.shape, mesh::cell_counts(c.column.shape, *c.column.mesh));
  return {mesh, c.column.shape, coupled_options(c), ranks};
}

column::FlowOptions flow_options(const Case& c, const FlowRamp& ramp, const dem::StepChoice& step) {
  auto o = common(c, step);
  o.name = "flow_ramp";
  o.from = ramp.from;
  o.to = ramp.to;
  o.steps = ramp.steps;
  o.hold = ramp.hold;
  o.hold_limit = ramp.hold_limit;
  o.ramps = ramp.change == FlowChange::ramp;
  return o;
}

column::FlowOptions flow_options(const Case& c,
                                 const Hold& hold,
                                 double flow,
                                 const dem::StepChoice& step) {
  auto o = common(c, step);
  o.name = "hold";
  o.from = o.to = hold.flow.value_or(flow);
  o.hold = o.hold_limit = hold.duration;
  o.ramps = false;
  return o;
}

}  // namespace packbed::setup
