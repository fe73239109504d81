// SPDX-License-Identifier: BSD-3-Clause
#include "dem/particles.hpp"

#include <utility>

namespace packbed::dem {
namespace {

// Two beads far from everything and from each other, which no force moves.
void add_dummies(Particles& particles) {
  for (const double far : {1e3, 2e3}) {
    particles.motion.push_back(
        {.x = {far, far, far}, .v = {}, .inv_mass = 0.0, .inv_inertia = 0.0});
    particles.spin.push_back({.w = {}, .half_radius = 1e-5});
    particles.load.push_back({});
    particles.reference.push_back({far, far, far});
  }
}

/// What follows the beads (the dummies) is kept behind them.
template <class Vector>
void permute(Vector& values, const std::vector<std::int32_t>& order, std::size_t beads) {
  Vector chosen;
  chosen.reserve(order.size() + values.size() - beads);
  for (const auto k : order) chosen.push_back(values[static_cast<std::size_t>(k)]);
  for (std::size_t k = beads; k < values.size(); ++k) chosen.push_back(values[k]);
  values = std::move(chosen);
}

void reserve(Particles& p, std::size_t beads) {
  constexpr std::size_t dummies = 2;
  p.motion.reserve(beads + dummies);
  p.spin.reserve(beads + dummies);
  p.load.reserve(beads + dummies);
  p.reference.reserve(beads + dummies);
  p.properties.reserve(beads);
  p.owner.reserve(beads);
}

}  // namespace

void add(Particles& particles,
         const Motion& motion,
         const Spin& spin,
         const BeadProperties& properties,
         std::int32_t owner,
         const Drag& drag,
         const CouplingMark& coupled_at) {
  const auto place = static_cast<std::ptrdiff_t>(particles.size());
  particles.motion.insert(particles.motion.begin() + place, motion);
  particles.spin.insert(particles.spin.begin() + place, spin);
  particles.load.insert(
      particles.load.begin() + place,
      {.force = {0.0, 0.0, -properties.weight}, .weight = properties.weight, .torque = {}});
  particles.reference.insert(particles.reference.begin() + place, motion.x);
  particles.properties.push_back(properties);
  particles.owner.push_back(owner);
  if (!particles.in_liquid) return;
  particles.drag.push_back(drag);
  particles.coupled_at.push_back(coupled_at);
}

Particles make_particles(std::span<const BeadStart> beads,
                         const InertiaScale& inertia,
                         std::int32_t rank) {
  Particles p;
  p.rank = rank;
  reserve(p, beads.size());
  add_dummies(p);
  for (const auto& bead : beads) {
    const auto& b = bead.properties;
    const double mass = inertia.of(b.diameter) * b.mass;
    const double moment = 0.1 * mass * b.diameter * b.diameter;  // 2/5 m R^2
    const Motion motion{.x = bead.x,
                        .v = bead.v,
                        .inv_mass = b.fixed ? 0.0 : 1.0 / mass,
                        .inv_inertia = b.fixed ? 0.0 : 1.0 / moment};
    add(p, motion, {.w = bead.w, .half_radius = 0.25 * b.diameter}, b, rank);
  }
  return p;
}

void reorder(Particles& particles, const std::vector<std::int32_t>& order) {
  const std::size_t beads = particles.size();
  permute(particles.motion, order, beads);
  permute(particles.spin, order, beads);
  permute(particles.load, order, beads);
  permute(particles.reference, order, beads);
  permute(particles.properties, order, beads);
  permute(particles.owner, order, beads);
  if (!particles.in_liquid) return;
  permute(particles.drag, order, beads);
  permute(particles.coupled_at, order, beads);
}

void set_in_liquid(bool in_liquid, Particles& particles) {
  if (in_liquid == particles.in_liquid) return;
  particles.in_liquid = in_liquid;
  particles.drag.assign(in_liquid ? particles.size() : 0, Drag{});
  particles.coupled_at.clear();
  if (!in_liquid) return;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    particles.coupled_at.push_back({.x = particles.motion[i].x});
  }
}

}  // namespace packbed::dem
