// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Walls given by formulas: planes, discs, the inside of a tube; each fixed or moving. A wall is
/// body j of its contacts, rigid and of infinite radius and mass.

#include <string>
#include <variant>
#include <vector>

#include "core/vec3.hpp"
#include "dem/contact/friction.hpp"
#include "dem/material.hpp"
#include "dem/particles.hpp"

namespace packbed::dem {

/// Half space whose border goes through `point`; `normal` (a unit vector) points to the beads.
struct Plane {
  Vec3 point;  ///< [m]
  Vec3 normal;
};

/// Round plate; beads beside it touch its rim. Only the side that `normal` points to is a wall.
struct Disc {
  Vec3 center;  ///< [m]
  Vec3 normal;
  double radius;  ///< [m]
};

/// Inside of a round tube whose axis goes through the origin.
struct Tube {
  double radius;          ///< [m]
  Vec3 axis = {0, 0, 1};  ///< unit vector
};

struct Wall {
  std::string name;  ///< for messages and outputs: "floor", "x_low"
  std::variant<Plane, Disc, Tube> surface;
  Material material;
  Vec3 velocity;    ///< [m/s]; planes and discs move with it; a tube slides along its axis
  double friction;  ///< with the beads
};

/// Where a bead stands to a wall.
struct WallDistance {
  double distance = 0.0;  ///< of the center from the surface, positive inside [m]
  Vec3 normal;            ///< unit vector from the wall towards the bead
};
WallDistance distance_to(const Wall& wall, const Vec3& x);

/// A bead near a wall, with its springs.
struct WallContact {
  std::int32_t bead = 0;
  Coefficients coefficients;
  History history;
};

/// Contacts of one wall, sorted by bead.
using WallContacts = std::vector<WallContact>;

/// Beads closer than `skin` [m] to a wall; springs of the old list are taken over (`place` is the new
/// place of each old bead). New ones have coefficient a = -1.
WallContacts find_wall_contacts(const Wall& wall,
                                const Particles& particles,
                                double skin,
                                const WallContacts& old,
                                const std::vector<std::int32_t>& place);

/// Relative motion of a bead and a wall; the arm reaches to the rigid wall, c = R - overlap.
Kinematics wall_kinematics(const Wall& wall, const Motion& motion, const Spin& spin);

}  // namespace packbed::dem
