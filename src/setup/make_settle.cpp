// SPDX-License-Identifier: BSD-3-Clause
#include "setup/make_settle.hpp"

#include <numbers>

#include <fmt/format.h>

#include "column/protocol/settled_porosity.hpp"
#include "core/error.hpp"
#include "dem/cloud.hpp"
#include "resin/size_statistics.hpp"
#include "setup/case_figures.hpp"

namespace packbed::setup {
namespace {

constexpr double cloud_solid_fraction = 0.5;

const Settle* first_settle(const std::vector<ProtocolStep>& steps) {
  for (const auto& step : steps) {
    if (const auto* settle = std::get_if<Settle>(&step.what)) return settle;
    const auto* repeat = std::get_if<Repeat>(&step.what);
    const auto* inner = repeat != nullptr ? first_settle(repeat->steps) : nullptr;
    if (inner != nullptr) return inner;
  }
  return nullptr;
}

double sphere(double diameter) { return std::numbers::pi / 6.0 * diameter * diameter * diameter; }

double rolling_friction(const Case& c) {
  return c.resin.rolling == RollingLawName::none ? 0.0 : c.resin.rolling_friction;
}

/// Solid volume of a bed of this height, from the porosity that it will have [m3].
double solid_volume(const Case& c, const Settle& settle) {
  double porosity = settle.porosity.value_or(assumed_porosity);
  if (settle.friction) {
    porosity = column::settled_porosity(*settle.friction, rolling_friction(c));
  }
  return (1.0 - porosity) * mesh::cross_section(c.column.shape) * *settle.bed_height;
}

std::vector<dem::BeadProperties> beads_to_make(const Case& c) {
  std::vector<dem::BeadProperties> beads;
  if (c.beads.count) {
    for (std::int64_t id = 0; id < *c.beads.count; ++id) beads.push_back(bead_of(c, id));
    return beads;
  }
  const double wanted = solid_volume(c, *first_settle(c.protocol));
  for (double sum = 0.0; sum < wanted; sum += sphere(beads.back().diameter)) {
    beads.push_back(bead_of(c, static_cast<std::int64_t>(beads.size())));
  }
  return beads;
}

bool has_lid(const mesh::ColumnShape& shape) {
  const auto* box = std::get_if<mesh::Box>(&shape);
  return box == nullptr || box->boundaries[2] == mesh::Boundary::wall;
}

void check_height(const Case& c, const dem::Cloud& cloud) {
  const double height = mesh::height(c.column.shape);
  if (settles_first(c) || !has_lid(c.column.shape) || cloud.high <= height) return;
  throw ConfigError(fmt::format(
      "{}: {} grains without overlap take a height of {:.4g} mm, and the column has {:.4g} mm; let "
      "the protocol begin with a step \"settle\", which needs no room above the bed, or make the "
      "column higher, or give a smaller beads.count",
      c.file.string(), cloud.x.size(), 1e3 * cloud.high, 1e3 * height));
}

column::SteppingOptions stepping(const Case& c, const dem::StepChoice& step) {
  return {.longest_step = step.contact_time / dem::fewest_steps_per_contact,
          .fixed_step = c.numerics.step,
          .force_step = c.numerics.force_step};
}

double damping_rate(const Case& c) {
  return c.numerics.background_damping ? 1.0 / *c.numerics.background_damping : 0.0;
}

}  // namespace

bool makes_beads(const Case& c) {
  const auto* settle = first_settle(c.protocol);
  return !c.beads.csv && !c.beads.run &&
         (c.beads.count || (settle != nullptr && settle->bed_height));
}

bool settles_first(const Case& c) {
  return !c.protocol.empty() && std::holds_alternative<Settle>(c.protocol.front().what);
}

dem::BeadProperties bead_of(const Case& c, std::int64_t id) {
  const double diameter = c.resin.coarse_grain * resin::sample(*c.resin.sizes, c.numerics.seed,
                                                               static_cast<std::uint64_t>(id));
  return bead_properties(
      c, id, diameter, *c.resin.density,
      {.youngs_modulus = *c.resin.youngs_modulus, .poisson_ratio = *c.resin.poisson_ratio});
}

std::vector<dem::BeadStart> make_cloud_beads(const Case& c) {
  const auto beads = beads_to_make(c);
  std::vector<double> diameters;
  diameters.reserve(beads.size());
  for (const auto& bead : beads) diameters.push_back(bead.diameter);
  const auto cloud = dem::make_cloud(
      {.shape = c.column.shape, .solid_fraction = cloud_solid_fraction, .seed = c.numerics.seed},
      diameters);
  check_height(c, cloud);
  std::vector<dem::BeadStart> starts(beads.size());
  for (std::size_t k = 0; k < beads.size(); ++k) {
    starts[k].properties = beads[k];
    starts[k].x = cloud.x[k];
  }
  return starts;
}

column::SettleOptions settle_options(const Case& c,
                                     const Settle& settle,
                                     const dem::StepChoice& step,
                                     bool first) {
  column::SettleOptions o;
  o.shape = c.column.shape;
  o.gravity = gravity;
  o.liquid_density = c.liquid ? c.liquid->density : 0.0;
  o.bed_height = settle.bed_height;
  o.porosity = settle.porosity;
  o.friction = settle.friction;
  o.resin_friction = c.resin.friction;
  o.resin_rolling_friction = rolling_friction(c);
  if (c.resin.sizes) o.bead = [c](std::int64_t id) { return bead_of(c, id); };
  o.seed = c.numerics.seed;
  o.cloud_solid_fraction = cloud_solid_fraction;
  if (first && makes_beads(c) && has_lid(c.column.shape)) o.lid = mesh::height(c.column.shape);
  o.stepping = stepping(c, step);
  o.fall_damping = c.numerics.background_damping;
  o.damping_after = damping_rate(c);
  return o;
}

column::SettleState settle_start(std::int64_t bead_count) {
  column::SettleState state;
  state.next_id = bead_count;
  return state;
}

column::TapOptions tap_options(const Case& c, const Tap& tap, const dem::StepChoice& step) {
  column::TapOptions o;
  o.amplitude = tap.amplitude;
  o.frequency = tap.frequency;
  o.count = tap.count;
  o.area = mesh::cross_section(c.column.shape);
  o.gravity = gravity;
  o.liquid_density = c.liquid ? c.liquid->density : 0.0;
  o.stepping = stepping(c, step);
  o.damping_after = damping_rate(c);
  return o;
}

}  // namespace packbed::setup
