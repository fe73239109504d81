// SPDX-License-Identifier: BSD-3-Clause
#include "dem/leapfrog.hpp"

#include <cassert>

namespace packbed::dem {
namespace {

// A vector of space and what stands behind it in the record, in one register (GCC vector type).
using Four = double __attribute__((vector_size(32), aligned(8), may_alias));

Four& four(double& first) { return reinterpret_cast<Four&>(first); }

/// The first three numbers of a, the fourth of b.
Four with_fourth(Four a, Four b) { return __builtin_shufflevector(a, b, 0, 1, 2, 7); }

template <bool in_liquid>
Vec3 move(Particles& particles, std::size_t first, std::size_t last, const Leapfrog& step) {
  const double damp = 0.5 * step.kick * step.damping;
  const double keep = (1.0 - damp) / (1.0 + damp);
  const double push = step.kick / (1.0 + damp);
  Four largest{};
  Four spoiled{};  // a number that is none spoils it
  // Four numbers are read of each reference: the dummies at the end make that safe.
  assert(last < particles.reference.size());
  for (std::size_t i = first; i < last; ++i) {
    Motion& m = particles.motion[i];
    Four& w = four(particles.spin[i].w.x);
    Load& load = particles.load[i];
    Four& force = four(load.force.x);
    Four& torque = four(load.torque.x);
    const double kept = m.inv_mass > 0.0 ? keep : 1.0;

    const Four v = four(m.v.x);
    const double moved_by = push * m.inv_mass;
    Four next = kept * v + moved_by * force;
    if constexpr (in_liquid) {  // implicit: (v' - v) m / kick = F + rate (target - v')
      Drag& drag = particles.drag[i];
      next = (next + moved_by * drag.rate * four(drag.target.x)) / (1.0 + moved_by * drag.rate);
    }
    const Four new_v = with_fourth(next, v);
    const Four new_w = with_fourth(kept * w + (push * m.inv_inertia) * torque, w);
    const Four new_x = four(m.x.x) + step.drift * new_v;
    const Four d = new_x - four(particles.reference[i].x);
    four(m.x.x) = new_x;  // its fourth number is v.x, which is written next
    four(m.v.x) = new_v;
    w = new_w;
    const double weight = load.weight;
    force = Four{0.0, 0.0, -weight, weight};
    torque = Four{};

    const Four far = d < 0.0 ? -d : d;
    largest = far > largest ? far : largest;
    spoiled += 0.0 * d;
  }
  largest += spoiled;
  return {largest[0], largest[1], largest[2]};
}

}  // namespace

Vec3 move_beads(Particles& particles, std::size_t first, std::size_t last, const Leapfrog& step) {
  return particles.in_liquid ? move<true>(particles, first, last, step)
                             : move<false>(particles, first, last, step);
}

}  // namespace packbed::dem
