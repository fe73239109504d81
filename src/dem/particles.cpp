// SPDX-License-Identifier: BSD-3-Clause
#include "dem/particles.hpp"

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

template <class Vector>
void permute(Vector& values, const std::vector<std::int32_t>& order) {
  Vector old = values;
  for (std::size_t k = 0; k < order.size(); ++k) {
    values[k] = old[static_cast<std::size_t>(order[k])];
  }
}

}  // namespace

void clear(Particles& particles) {
  const auto rank = particles.rank;
  particles = {};
  particles.rank = rank;
  add_dummies(particles);
}

void add(Particles& particles,
         const Motion& motion,
         const Spin& spin,
         const BeadProperties& properties,
         std::int32_t owner) {
  const auto place = static_cast<std::ptrdiff_t>(particles.size());
  particles.motion.insert(particles.motion.begin() + place, motion);
  particles.spin.insert(particles.spin.begin() + place, spin);
  particles.load.insert(
      particles.load.begin() + place,
      {.force = {0.0, 0.0, -properties.weight}, .weight = properties.weight, .torque = {}});
  particles.reference.insert(particles.reference.begin() + place, motion.x);
  particles.properties.push_back(properties);
  particles.owner.push_back(owner);
}

Particles make_particles(const std::vector<BeadStart>& beads, double inertia_scale) {
  Particles p;
  clear(p);
  for (const auto& bead : beads) {
    const auto& b = bead.properties;
    const double mass = inertia_scale * b.mass;
    const double inertia = 0.1 * mass * b.diameter * b.diameter;  // 2/5 m R^2
    const Motion motion{.x = bead.x,
                        .v = bead.v,
                        .inv_mass = b.fixed ? 0.0 : 1.0 / mass,
                        .inv_inertia = b.fixed ? 0.0 : 1.0 / inertia};
    add(p, motion, {.w = bead.w, .half_radius = 0.25 * b.diameter}, b, 0);
  }
  return p;
}

void reorder(Particles& particles, const std::vector<std::int32_t>& order) {
  permute(particles.motion, order);
  permute(particles.spin, order);
  permute(particles.load, order);
  permute(particles.reference, order);
  permute(particles.properties, order);
  permute(particles.owner, order);
}

}  // namespace packbed::dem
