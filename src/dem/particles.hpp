// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The beads in the records that the contact loop wants: one cache line of motion, half a line of
/// spin, one line of load. Beads stand in the order of the last renewal (dem/neighbors.hpp); two
/// dummies that touch nothing follow the last one and fill up blocks of contacts.

#include <cstdint>
#include <span>
#include <vector>

#include "core/aligned.hpp"
#include "core/vec3.hpp"
#include "dem/material.hpp"

namespace packbed::dem {

/// Factor on mass and moment of inertia of the beads that move, not on their weight or stiffness: `scale` for
/// all; or, above 1 and with a `diameter` D [m], 1 + (scale - 1) (D / d + (D / d)^2) / 2 for a bead of diameter d, so that
/// the contacts of a small bead ask for no shorter a step than those of a large one. docs/theory/contact.md,
/// section 6.
struct InertiaScale {
  double scale = 1.0;
  double diameter = 0.0;  ///< 0: all alike

  [[nodiscard]] double of(double d) const {
    if (diameter <= 0.0 || scale <= 1.0) return scale;
    const double ratio = diameter / d;
    return 1.0 + (scale - 1.0) * 0.5 * (ratio + ratio * ratio);
  }
};

/// Velocities belong to half steps while a run is under way (dem/dem.hpp).
struct alignas(64) Motion {
  Vec3 x;                    ///< center [m]
  Vec3 v;                    ///< [m/s]
  double inv_mass = 0.0;     ///< 1 / (inertia scale m) [1/kg]; 0 for a fixed bead
  double inv_inertia = 0.0;  ///< 1 / (inertia scale I) [1/(kg m2)]; 0 for a fixed bead
};

struct alignas(32) Spin {
  Vec3 w;                    ///< [rad/s]
  double half_radius = 0.0;  ///< R / 2 [m]
};

/// Forces and torques of a step, gathered; between steps the weight alone.
struct alignas(64) Load {
  Vec3 force;          ///< [N]
  double weight = 0;   ///< weight less buoyancy, downwards [N]: what the force starts from
  Vec3 torque;         ///< [N m]
  double nothing = 0;  ///< stays 0
};

/// Pull of a liquid on a bead: the force rate (target - v), taken implicitly in v. Forces that do not depend
/// on v are in the target.
struct alignas(32) Drag {
  Vec3 target;        ///< velocity at which it vanishes [m/s]
  double rate = 0.0;  ///< [kg/s]
};

/// What a bead is made of; one value per bead.
struct BeadProperties {
  std::int64_t id = 0;
  double diameter = 0.0;  ///< [m]
  double density = 0.0;   ///< [kg/m3]
  double mass = 0.0;      ///< true mass [kg]
  double weight = 0.0;    ///< weight less buoyancy, downwards [N]
  Material material;
  bool fixed = false;
};

/// What the last coupling with a liquid knew of a bead.
struct CouplingMark {
  Vec3 x;             ///< center [m]
  double lens = 0.0;  ///< volume in its contacts that did not count then [m3]
};

struct Particles {
  AlignedVector<Motion> motion{};
  AlignedVector<Spin> spin{};
  AlignedVector<Load> load{};
  AlignedVector<Vec3> reference{};           ///< centers when pairs were last listed
  AlignedVector<Drag> drag{};                ///< one per bead in a liquid, else empty; no dummies
  AlignedVector<CouplingMark> coupled_at{};  ///< likewise
  std::vector<BeadProperties> properties{};
  std::vector<std::int32_t> owner{};  ///< rank that owns the bead
  std::int32_t rank = 0;              ///< this one
  bool in_liquid = false;             ///< whether beads have a drag

  [[nodiscard]] bool is_own(std::size_t i) const { return owner[i] == rank; }
  /// Own and halo beads, without the two dummies.
  [[nodiscard]] std::size_t size() const { return properties.size(); }
  [[nodiscard]] double radius(std::size_t i) const { return 2.0 * spin[i].half_radius; }
};

/// How a bead starts.
struct BeadStart {
  BeadProperties properties;
  Vec3 x;  ///< [m]
  Vec3 v;  ///< [m/s]
  Vec3 w;  ///< [rad/s]
};

/// Particles from their start, all own beads of `rank`.
Particles make_particles(std::span<const BeadStart> beads,
                         const InertiaScale& inertia,
                         std::int32_t rank = 0);

/// Adds a bead before the dummies.
void add(Particles& particles,
         const Motion& motion,
         const Spin& spin,
         const BeadProperties& properties,
         std::int32_t owner,
         const Drag& drag = {},
         const CouplingMark& coupled_at = {});

/// From now on beads have a drag, zero at first, and are coupled where they are; or no longer.
void set_in_liquid(bool in_liquid, Particles& particles);

/// Puts bead order[k] at place k; beads that `order` does not name are taken away.
void reorder(Particles& particles, const std::vector<std::int32_t>& order);

}  // namespace packbed::dem
