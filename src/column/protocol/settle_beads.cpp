// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/settle_beads.hpp"

#include <algorithm>
#include <numbers>
#include <tuple>
#include <unordered_set>

#include "column/protocol/weight.hpp"
#include "dem/cloud.hpp"
#include "dem/state.hpp"

namespace packbed::column {
namespace {

double sphere(double diameter) { return std::numbers::pi / 6.0 * diameter * diameter * diameter; }

dem::DemState state_of(const dem::Dem& dem) { return dem::whole(dem.state(), dem.ranks()); }

void take_over(const dem::DemState& state, dem::Dem& dem) {
  const auto options = dem.options();
  const auto ranks = dem.ranks();
  dem = dem::Dem(options, state, dem::Dem::Lists::anew, ranks);
}

}  // namespace

std::int64_t add_beads(
    const SettleOptions& options, double low, double volume, std::int64_t next_id, dem::Dem& dem) {
  std::vector<dem::BeadProperties> beads;
  std::vector<double> diameters;
  for (double sum = 0.0; sum < volume; sum += sphere(diameters.back())) {
    beads.push_back(options.bead(next_id++));
    beads.back().weight = weight_of(beads.back(), options.gravity, 0.0);
    diameters.push_back(beads.back().diameter);
  }
  const auto cloud =
      dem::make_cloud({.shape = options.shape,
                       .low = low,
                       .solid_fraction = options.cloud_solid_fraction,
                       .seed = options.seed,
                       .first_index = static_cast<std::uint64_t>(beads.empty() ? 0 : beads[0].id)},
                      diameters);
  auto state = state_of(dem);
  for (std::size_t k = 0; k < beads.size(); ++k) {
    const auto& x = cloud.x[k];
    state.beads.push_back({beads[k], x, {}, {}, x, x, {}, {}});
  }
  take_over(state, dem);
  return next_id;
}

void remove_highest(double volume, dem::Dem& dem) {
  auto state = state_of(dem);
  std::ranges::sort(state.beads, [](const dem::BeadState& a, const dem::BeadState& b) {
    return std::tuple(a.x.z, a.properties.id) < std::tuple(b.x.z, b.properties.id);
  });
  std::unordered_set<std::int64_t> gone;
  for (double sum = 0.0; sum < volume && state.beads.size() > 1;) {
    const auto& bead = state.beads.back().properties;
    sum += sphere(bead.diameter);
    gone.insert(bead.id);
    state.beads.pop_back();
  }
  std::erase_if(state.contacts,
                [&](const auto& c) { return gone.contains(c.id_i) || gone.contains(c.id_j); });
  std::erase_if(state.wall_contacts, [&](const auto& c) { return gone.contains(c.id); });
  take_over(state, dem);
}

void make_new_cloud(const SettleOptions& options, std::uint64_t number, dem::Dem& dem) {
  auto state = state_of(dem);
  std::ranges::sort(state.beads, {}, [](const auto& bead) { return bead.properties.id; });
  std::vector<double> diameters;
  for (const auto& bead : state.beads) diameters.push_back(bead.properties.diameter);
  constexpr std::uint64_t another = 0x9e3779b97f4a7c15;  // far from the seeds that users give
  const auto cloud = dem::make_cloud({.shape = options.shape,
                                      .solid_fraction = options.cloud_solid_fraction,
                                      .seed = options.seed + another * number},
                                     diameters);
  for (std::size_t k = 0; k < state.beads.size(); ++k) {
    auto& bead = state.beads[k];
    bead = {bead.properties, cloud.x[k], {}, {}, cloud.x[k], cloud.x[k], {}, {}};
  }
  state.contacts.clear();
  state.wall_contacts.clear();
  take_over(state, dem);
}

}  // namespace packbed::column
