// SPDX-License-Identifier: BSD-3-Clause
#include "setup/make_liquid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "setup/averaging.hpp"
#include "setup/make_dem.hpp"

namespace packbed::setup {
namespace {

/// A property of the beads: that of the bead file, its mean, or that of the resin.
double mean(const std::optional<double>& resin, const std::vector<double>& column) {
  if (column.empty()) return *resin;
  return std::accumulate(column.begin(), column.end(), 0.0) / static_cast<double>(column.size());
}

fluid::Boundaries boundaries_of(const ColumnOptions& column, const LiquidOptions& liquid) {
  fluid::Boundaries b;
  b.inlet = fluid::Inlet{.superficial = {}, .frit_resistance = column.inlet_resistance};
  b.outlet = fluid::Outlet{.pressure = 0.0, .frit_resistance = column.outlet_resistance};
  const fluid::Wall column_wall{.velocity = {}, .void_fraction = liquid.wall_void_fraction};
  b.wall = b.x_low = b.x_high = column_wall;
  const auto* box = std::get_if<mesh::Box>(&column.shape);
  if (box == nullptr) return b;
  const auto side = [&](std::size_t axis) -> fluid::BoundaryCondition {
    if (box->boundaries[axis] == mesh::Boundary::wall) return column_wall;
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

coupling::DragLaw drag_law(DragLawName name) {
  switch (name) {
    case DragLawName::ergun:
      return coupling::Ergun{};
    case DragLawName::gidaspow:
      return coupling::Gidaspow{};
    case DragLawName::di_felice:
      return coupling::DiFelice{};
    case DragLawName::beetstra:
      return coupling::Beetstra{};
    case DragLawName::koch_hill:
      break;
  }
  return coupling::KochHill{};
}

}  // namespace

column::DriveOptions drive_options(const Case& c, const dem::StepChoice& step) {
  const auto sizes = grain_sizes(c);
  column::DriveOptions o;
  o.interval = c.output.interval;
  o.area = mesh::cross_section(c.column.shape);
  o.coupling_interval = c.coupling.interval;
  o.inertia_scale = c.numerics.inertia_scale;
  o.inertia_by_size = c.numerics.inertia_scaling == InertiaScaling::by_size;
  // The times of `step` are at the inertia scale that the case gives.
  const double steps_per_contact =
      dem::fewest_steps_per_contact * std::sqrt(c.numerics.inertia_scale.value_or(1.0));
  o.smallest_diameter = step.smallest_diameter;
  o.longest_step_per_diameter = step.contact_time_per_diameter / steps_per_contact;
  o.stepping = {.longest_step = step.contact_time / steps_per_contact,
                .fixed_step = c.numerics.step,
                .force_step = c.numerics.force_step};
  o.grains = {.viscosity = c.liquid ? c.liquid->viscosity : 0.0,
              .density = mean(c.resin.density, c.beads.table.density),
              .bead_diameter = sizes.bead_sauter,
              .diameter = sizes.mean,
              .inertia_diameter = sizes.inertia,
              .stiffness = stiffness_of(c, sizes.mean)};
  return o;
}

column::CoupledOptions coupled_options(const Case& c) {
  const double reach = averaging_reach(c);
  column::CoupledOptions o;
  o.fluid.rho_f = c.liquid->density;
  o.fluid.mu_f = c.liquid->viscosity;
  o.fluid.gravity = {0.0, 0.0, c.numerics.gravity ? -gravity : 0.0};
  o.fluid.boundaries = boundaries_of(c.column, *c.liquid);
  o.coupling.drag = drag_law(c.drag.law);
  o.coupling.min_void_fraction = c.drag.min_void_fraction;
  o.coupling.overlap = c.coupling.overlap == OverlapRuleName::merged ? coupling::OverlapRule::merged
                                                                     : coupling::OverlapRule::full;
  o.coupling.scheme = c.coupling.scheme == CouplingSchemeName::frozen_velocity
                          ? coupling::Scheme::frozen_velocity
                          : coupling::Scheme::frozen_flux;
  o.coupling.coarse_grain = c.resin.coarse_grain;
  o.coupling.rho_f = c.liquid->density;
  o.coupling.mu_f = c.liquid->viscosity;
  o.coupling.widths = {.reach = reach, .reach_z = reach};
  return o;
}

column::CoupledBed make_coupled_bed(const Case& c, std::optional<double> top, const Ranks& ranks) {
  mesh::ColumnMesh mesh(c.column.shape, mesh::cell_counts(c.column.shape, *c.column.mesh));
  if (top && *top != mesh.top()) mesh.set_top(*top);
  return {mesh, c.column.shape, coupled_options(c), ranks};
}

column::FlowOptions flow_options(const Case& c, const FlowRamp& ramp, const dem::StepChoice& step) {
  auto o = with<column::FlowOptions>(drive_options(c, step));
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
  auto o = with<column::FlowOptions>(drive_options(c, step));
  o.name = "hold";
  o.to = hold.flow.value_or(flow);
  o.from = o.to;
  o.hold = o.hold_limit = hold.duration;
  o.ramps = false;
  return o;
}

}  // namespace packbed::setup
