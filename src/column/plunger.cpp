// SPDX-License-Identifier: BSD-3-Clause
#include "column/plunger.hpp"

#include <algorithm>

#include "dem/state.hpp"

namespace packbed::column {
namespace {

template <class Walls>
auto find_plunger(Walls& walls) {
  return std::ranges::find_if(walls, [](const dem::Wall& wall) {
    return wall.name == "lid" && std::holds_alternative<dem::Plane>(wall.surface);
  });
}

/// Upwards [N]; 0 where there is no such wall.
double force_on(std::vector<dem::Wall>::const_iterator wall, const dem::Dem& dem) {
  if (wall == dem.walls().end()) return 0.0;
  return dem.wall_forces()[static_cast<std::size_t>(wall - dem.walls().begin())].z;
}

}  // namespace

std::optional<double> plunger_position(const std::vector<dem::Wall>& walls) {
  const auto lid = find_plunger(walls);
  if (lid == walls.end()) return std::nullopt;
  const double z = std::get<dem::Plane>(lid->surface).point.z;
  return z < lid_away ? std::optional(z) : std::nullopt;
}

void set_plunger_speed(double speed, dem::Dem& dem) {
  const auto lid = find_plunger(dem.walls());
  if (lid != dem.walls().end()) lid->velocity = {0.0, 0.0, speed};
}

double plunger_force(const dem::Dem& dem) { return force_on(find_plunger(dem.walls()), dem); }

double floor_force(const dem::Dem& dem) {
  return -force_on(std::ranges::find(dem.walls(), "floor", &dem::Wall::name), dem);
}

void place_plunger(double height, dem::Dem& dem) {
  auto state = dem::whole(dem.state(), dem.ranks());
  const auto lid = find_plunger(state.walls);
  if (lid == state.walls.end()) return;
  std::get<dem::Plane>(lid->surface).point.z = height;
  const auto options = dem.options();
  const auto ranks = dem.ranks();
  dem = dem::Dem(options, state, dem::Dem::Lists::anew, ranks);
}

}  // namespace packbed::column
