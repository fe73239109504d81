// SPDX-License-Identifier: BSD-3-Clause
#include "io/dem_state_file.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::io {
namespace {

/// One value per item.
template <class T, class Item, class Get>
std::vector<T> column(const std::vector<Item>& items, Get get) {
  std::vector<T> values;
  values.reserve(items.size());
  for (const auto& item : items) values.push_back(get(item));
  return values;
}

constexpr std::size_t property_width = 6;

std::vector<double> properties_of(const std::vector<dem::BeadState>& beads) {
  std::vector<double> values;
  values.reserve(property_width * beads.size());
  for (const auto& b : beads) {
    const auto& p = b.properties;
    values.insert(values.end(), {p.diameter, p.density, p.mass, p.weight, p.material.youngs_modulus,
                                 p.material.poisson_ratio});
  }
  return values;
}

dem::BeadProperties properties_from(std::int64_t id, const double* v, bool fixed) {
  return {.id = id,
          .diameter = v[0],
          .density = v[1],
          .mass = v[2],
          .weight = v[3],
          .material = {.youngs_modulus = v[4], .poisson_ratio = v[5]},
          .fixed = fixed};
}

/// Names and values of the counters and lengths, in one place for both directions.
template <class Progress, class Integer, class Number>
void visit_progress(Progress& p, Integer integer, Number number) {
  integer("steps", p.steps);
  integer("steps_before", p.steps_before);
  integer("near_listed", p.near_listed);
  integer("renewals", p.renewals);
  integer("repartitions", p.repartitions);
  number("time_before_s", p.time_before);
  number("step_s", p.step);
  number("last_step_s", p.last_step);
  number("skin_m", p.skin);
  number("near_skin_m", p.near_skin);
  number("moved_m", p.moved);
  number("far_moved_m", p.far_moved);
  number("walls_moved_m", p.walls_moved);
  number("cell_m", p.cell);
  number("inertia_scale", p.inertia_scale);
  number("inertia_diameter_m", p.inertia_diameter);
  number("background_damping_1_s", p.background_damping);
  number("friction", p.friction);
  number("rolling_friction", p.rolling_friction);
  integer("in_liquid", p.in_liquid);
}

// A tube does not move.
Vec3* place_of(dem::Wall& wall) {
  if (auto* plane = std::get_if<dem::Plane>(&wall.surface)) return &plane->point;
  if (auto* disc = std::get_if<dem::Disc>(&wall.surface)) return &disc->center;
  return nullptr;
}

constexpr std::size_t wall_width = 7;

std::vector<double> walls_of(std::vector<dem::Wall> walls, bool writes) {
  std::vector<double> values;
  if (!writes) return values;
  for (auto& wall : walls) {
    const Vec3* place = place_of(wall);
    const Vec3 x = place != nullptr ? *place : Vec3{};
    values.insert(values.end(), {x.x, x.y, x.z, wall.velocity.x, wall.velocity.y, wall.velocity.z,
                                 wall.friction});
  }
  return values;
}

void read_walls(const CheckpointReader& reader, std::vector<dem::Wall>& walls) {
  const auto values = reader.read<double>("dem/walls");
  if (values.size() != wall_width * walls.size()) {
    throw DataError(fmt::format("the checkpoint has {} walls, the case {}",
                                values.size() / wall_width, walls.size()));
  }
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const double* v = &values[wall_width * w];
    if (Vec3* place = place_of(walls[w])) *place = {v[0], v[1], v[2]};
    walls[w].velocity = {v[3], v[4], v[5]};
    walls[w].friction = v[6];
  }
}

}  // namespace

void write_dem_state(CheckpointWriter& writer, const dem::DemState& share) {
  const auto& beads = share.beads;
  writer.array("dem/id", column<std::int64_t>(beads, [](auto& b) { return b.properties.id; }));
  writer.array("dem/x_m", column<Vec3>(beads, [](auto& b) { return b.x; }));
  writer.array("dem/v_m_s", column<Vec3>(beads, [](auto& b) { return b.v; }));
  writer.array("dem/w_rad_s", column<Vec3>(beads, [](auto& b) { return b.w; }));
  writer.array("dem/reference_m", column<Vec3>(beads, [](auto& b) { return b.reference; }));
  writer.array("dem/far_reference_m", column<Vec3>(beads, [](auto& b) { return b.far_reference; }));
  writer.array("dem/drag_target_m_s", column<Vec3>(beads, [](auto& b) { return b.drag.target; }));
  writer.array("dem/coupled_at_m", column<Vec3>(beads, [](auto& b) { return b.coupled_at.x; }));
  writer.array("dem/coupled_lens_m3",
               column<double>(beads, [](auto& b) { return b.coupled_at.lens; }));
  writer.array("dem/drag_rate_kg_s", column<double>(beads, [](auto& b) { return b.drag.rate; }));
  writer.array("dem/properties", properties_of(beads), property_width);
  writer.array("dem/fixed", column<std::uint8_t>(beads, [](auto& b) -> std::uint8_t {
                 return b.properties.fixed ? 1 : 0;
               }));

  const auto& contacts = share.contacts;
  writer.array("dem/contact_id_i", column<std::int64_t>(contacts, [](auto& c) { return c.id_i; }));
  writer.array("dem/contact_id_j", column<std::int64_t>(contacts, [](auto& c) { return c.id_j; }));
  std::vector<std::int8_t> images;
  for (const auto& c : contacts) images.insert(images.end(), c.image.begin(), c.image.end());
  writer.array("dem/contact_image", images, 3);
  writer.array("dem/contact_spring_m",
               column<Vec3>(contacts, [](auto& c) { return c.history.spring; }));
  writer.array("dem/contact_angle_rad",
               column<Vec3>(contacts, [](auto& c) { return c.history.angle; }));

  const auto& near = share.wall_contacts;
  writer.array("dem/wall_contact_id", column<std::int64_t>(near, [](auto& c) { return c.id; }));
  writer.array("dem/wall_contact_wall", column<std::int32_t>(near, [](auto& c) { return c.wall; }));
  writer.array("dem/wall_contact_spring_m",
               column<Vec3>(near, [](auto& c) { return c.history.spring; }));
  writer.array("dem/wall_contact_angle_rad",
               column<Vec3>(near, [](auto& c) { return c.history.angle; }));

  writer.array("dem/walls", walls_of(share.walls, Ranks::all().is_first()), wall_width);
  visit_progress(
      share.progress,
      [&](const char* name, std::int64_t value) {
        writer.integer(std::string("dem/") + name, value);
      },
      [&](const char* name, double value) { writer.number(std::string("dem/") + name, value); });
}

dem::DemState read_dem_state(const CheckpointReader& reader, std::vector<dem::Wall> walls) {
  dem::DemState s;
  s.walls = std::move(walls);
  read_walls(reader, s.walls);
  visit_progress(
      s.progress,
      [&](const char* name, std::int64_t& value) {
        value = reader.integer(std::string("dem/") + name);
      },
      [&](const char* name, double& value) {
        const auto key = std::string("dem/") + name;
        const bool is_older = &value == &s.progress.inertia_diameter && !reader.has_number(key);
        if (!is_older)
          value = reader.number(key);  // before there was a choice all were scaled alike
      });

  const auto id = reader.read<std::int64_t>("dem/id");
  const auto properties = reader.read<double>("dem/properties");
  const auto fixed = reader.read<std::uint8_t>("dem/fixed");
  const auto x = reader.read<Vec3>("dem/x_m");
  const auto v = reader.read<Vec3>("dem/v_m_s");
  const auto w = reader.read<Vec3>("dem/w_rad_s");
  const auto reference = reader.read<Vec3>("dem/reference_m");
  const auto far_reference = reader.read<Vec3>("dem/far_reference_m");
  const auto drag_target = reader.read<Vec3>("dem/drag_target_m_s");
  const auto drag_rate = reader.read<double>("dem/drag_rate_kg_s");
  const auto coupled_at = reader.read<Vec3>("dem/coupled_at_m");
  const auto coupled_lens = reader.read<double>("dem/coupled_lens_m3");
  for (std::size_t i = 0; i < id.size(); ++i) {
    s.beads.push_back({properties_from(id[i], &properties[property_width * i], fixed[i] != 0),
                       x[i],
                       v[i],
                       w[i],
                       reference[i],
                       far_reference[i],
                       {drag_target[i], drag_rate[i]},
                       {coupled_at[i], coupled_lens[i]}});
  }
  const auto id_i = reader.read<std::int64_t>("dem/contact_id_i");
  const auto id_j = reader.read<std::int64_t>("dem/contact_id_j");
  const auto image = reader.read<std::int8_t>("dem/contact_image");
  const auto spring = reader.read<Vec3>("dem/contact_spring_m");
  const auto angle = reader.read<Vec3>("dem/contact_angle_rad");
  for (std::size_t k = 0; k < id_i.size(); ++k) {
    s.contacts.push_back({id_i[k],
                          id_j[k],
                          {image[3 * k], image[3 * k + 1], image[3 * k + 2]},
                          {spring[k], angle[k]}});
  }
  const auto near_id = reader.read<std::int64_t>("dem/wall_contact_id");
  const auto near_wall = reader.read<std::int32_t>("dem/wall_contact_wall");
  const auto near_spring = reader.read<Vec3>("dem/wall_contact_spring_m");
  const auto near_angle = reader.read<Vec3>("dem/wall_contact_angle_rad");
  for (std::size_t k = 0; k < near_id.size(); ++k) {
    s.wall_contacts.push_back({near_id[k], near_wall[k], {near_spring[k], near_angle[k]}});
  }
  return s;
}

}  // namespace packbed::io
