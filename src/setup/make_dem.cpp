// SPDX-License-Identifier: BSD-3-Clause
#include "setup/make_dem.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "resin/size_statistics.hpp"
#include "setup/make_settle.hpp"

namespace packbed::setup {
namespace {

dem::Material material_of(const Material& m) {
  return {.youngs_modulus = m.youngs_modulus, .poisson_ratio = m.poisson_ratio};
}

dem::Wall plane(const char* name,
                const Vec3& point,
                const Vec3& normal,
                const Material& material,
                double friction) {
  return {.name = name,
          .surface = dem::Plane{.point = point, .normal = normal},
          .material = material_of(material),
          .velocity = {},
          .friction = friction};
}

void add_ends(const Case& c, double height, std::vector<dem::Wall>& walls) {
  const double friction = c.resin.wall_friction;
  walls.push_back(plane("floor", {}, {0, 0, 1}, c.column.frit, friction));
  walls.push_back(plane("lid", {0, 0, height}, {0, 0, -1}, c.column.frit, friction));
}

void add_walls(const Case& c, const mesh::Slice& slice, std::vector<dem::Wall>& walls) {
  const double x = 0.5 * slice.inner_diameter;
  walls.push_back(plane("x_low", {-x, 0, 0}, {1, 0, 0}, c.column.wall, c.resin.wall_friction));
  walls.push_back(plane("x_high", {x, 0, 0}, {-1, 0, 0}, c.column.wall, c.resin.wall_friction));
  add_ends(c, slice.height, walls);
}

void add_walls(const Case& c, const mesh::Cylinder& cylinder, std::vector<dem::Wall>& walls) {
  walls.push_back({.name = "tube",
                   .surface = dem::Tube{.radius = 0.5 * cylinder.inner_diameter},
                   .material = material_of(c.column.wall),
                   .velocity = {},
                   .friction = c.resin.wall_friction});
  add_ends(c, cylinder.height, walls);
}

void add_walls(const Case& c, const mesh::Box& box, std::vector<dem::Wall>& walls) {
  constexpr const char* names[3][2] = {{"x_low", "x_high"}, {"y_low", "y_high"}, {"floor", "lid"}};
  constexpr Vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (box.boundaries[axis] != mesh::Boundary::wall) continue;
    const Vec3 n = axes[axis];
    const double friction = c.resin.wall_friction;
    walls.push_back(plane(names[axis][0], {}, n, c.column.wall, friction));
    walls.push_back(plane(names[axis][1], box.size[axis] * n, -n, c.column.wall, friction));
  }
}

dem::Domain domain_of(const mesh::ColumnShape& shape) {
  dem::Domain domain;
  if (const auto* slice = std::get_if<mesh::Slice>(&shape)) {
    domain.low = {-0.5 * slice->inner_diameter, -0.5 * slice->depth, 0.0};
    domain.size = {slice->inner_diameter, slice->depth, slice->height};
    domain.periodic = {false, true, false};
  } else if (const auto* cylinder = std::get_if<mesh::Cylinder>(&shape)) {
    const double d = cylinder->inner_diameter;
    domain.low = {-0.5 * d, -0.5 * d, 0.0};
    domain.size = {d, d, cylinder->height};
  } else {
    const auto& box = std::get<mesh::Box>(shape);
    domain.size = box.size;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      domain.periodic[axis] = box.boundaries[axis] == mesh::Boundary::periodic;
    }
  }
  return domain;
}

/// Value i of a column of the bead file, or that of the resin.
double value(const std::vector<double>& column, std::size_t i, const std::optional<double>& resin) {
  return column.empty() ? *resin : column[i];
}

}  // namespace

dem::BeadProperties bead_properties(const Case& c,
                                    std::int64_t id,
                                    double diameter,
                                    double density,
                                    const dem::Material& material) {
  const double volume = std::numbers::pi / 6.0 * diameter * diameter * diameter;
  const double displaced = c.liquid ? c.liquid->density : 0.0;
  dem::BeadProperties p;
  p.id = id;
  p.diameter = diameter;
  p.density = density;
  p.mass = density * volume;
  p.weight = c.numerics.gravity ? (density - displaced) * volume * gravity : 0.0;
  p.material = material;
  return p;
}

dem::ContactModel contact_model(const Case& c) {
  const auto& r = c.resin;
  dem::ContactModel model{
      .contact = dem::HertzMindlin{.restitution = r.restitution, .tension = r.tension},
      .rolling = dem::NoRolling{},
      .friction = r.friction};
  if (r.contact == ContactLawName::hooke) {
    model.contact = dem::Hooke{.characteristic_velocity = *r.characteristic_velocity,
                               .restitution = r.restitution,
                               .tension = r.tension};
  }
  if (r.viscous) {
    model.contact = dem::ViscousHooke{.characteristic_velocity = *r.characteristic_velocity,
                                      .restitution_max = r.restitution_max,
                                      .critical_stokes = r.critical_stokes,
                                      .viscosity = c.liquid->viscosity,
                                      .tension = r.tension};
  }
  if (r.rolling == RollingLawName::cdt) model.rolling = dem::ConstantTorque{r.rolling_friction};
  if (r.rolling == RollingLawName::epsd) model.rolling = dem::ElasticPlastic{r.rolling_friction};
  return model;
}

std::vector<dem::Wall> make_walls(const Case& c) {
  std::vector<dem::Wall> walls;
  std::visit([&](const auto& shape) { add_walls(c, shape, walls); }, c.column.shape);
  return walls;
}

std::vector<dem::BeadStart> make_beads(const Case& c) {
  if (makes_beads(c)) return make_cloud_beads(c);
  const auto& t = c.beads.table;
  std::vector<dem::BeadStart> beads(t.size());
  for (std::size_t i = 0; i < t.size(); ++i) {
    const dem::Material material{
        .youngs_modulus = value(t.youngs_modulus, i, c.resin.youngs_modulus),
        .poisson_ratio = value(t.poisson_ratio, i, c.resin.poisson_ratio)};
    beads[i].properties =
        bead_properties(c, t.id.empty() ? static_cast<std::int64_t>(i) : t.id[i], t.diameter[i],
                        value(t.density, i, c.resin.density), material);
    beads[i].properties.fixed = !t.fixed.empty() && t.fixed[i];
    beads[i].x = to_vec3(t.x[i]);
    beads[i].v = to_vec3(t.v[i]);
    beads[i].w = to_vec3(t.omega[i]);
  }
  return beads;
}

dem::StepChoice step_of(const Case& c) {
  std::vector<dem::BeadProperties> beads;
  if (c.resin.sizes) {
    const auto sizes = resin::statistics(*c.resin.sizes);
    for (const double d : {sizes.smallest, sizes.mean}) {
      beads.push_back(bead_properties(
          c, 0, c.resin.coarse_grain * d, *c.resin.density,
          {.youngs_modulus = *c.resin.youngs_modulus, .poisson_ratio = *c.resin.poisson_ratio}));
    }
  } else {
    for (const auto& bead : make_beads(c)) beads.push_back(bead.properties);
  }
  std::vector<dem::Material> walls;
  for (const auto& wall : make_walls(c)) walls.push_back(wall.material);
  auto choice = dem::choose_step(contact_model(c).contact, beads, walls,
                                 c.numerics.inertia_scale.value_or(1.0));
  if (c.numerics.step) choice.step = *c.numerics.step;
  return choice;
}

dem::DemOptions options_of(const Case& c, double step) {
  dem::DemOptions options;
  options.domain = domain_of(c.column.shape);
  options.model = contact_model(c);
  options.step = step;
  options.overlap_limit = c.numerics.overlap_limit;
  options.inertia_scale = c.numerics.inertia_scale.value_or(1.0);
  if (c.numerics.background_damping)
    options.background_damping = 1.0 / *c.numerics.background_damping;
  if (c.column.mesh && Ranks::all().size() > 1) {  // beads belong to ranks like the liquid's cells
    options.mesh = std::make_shared<mesh::ColumnMesh>(
        c.column.shape, mesh::cell_counts(c.column.shape, *c.column.mesh));
  }
  return options;
}

dem::Dem make_dem(const Case& c, double step, const Ranks& ranks) {
  auto walls = make_walls(c);
  if (makes_beads(c) && settles_first(c)) {
    for (auto& wall : walls) {
      if (wall.name == "lid") std::get<dem::Plane>(wall.surface).point.z = column::lid_away;
    }
  }
  return {options_of(c, step), make_beads(c), std::move(walls), ranks};
}

}  // namespace packbed::setup
