// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The boundary conditions face by face. Border face b is face part.inner + b.

#include <cstdint>
#include <vector>

#include "core/vec3.hpp"
#include "fluid/boundary.hpp"
#include "fluid/domain.hpp"

namespace packbed::fluid {

enum class BorderKind : std::uint8_t { slip, wall, inlet, outlet };

/// One entry per border face. Empty sides count as slip walls.
struct Border {
  std::vector<BorderKind> kind;
  std::vector<mesh::Patch> patch;
  std::vector<Vec3> wall_velocity;  ///< along the face; 0 where there is no wall [m/s]
  std::vector<double> wall_eps;     ///< void fraction at a wall; 0: that of the cell
  std::vector<double> inward;    ///< superficial velocity into the column, through the patch [m/s]
  std::vector<double> pressure;  ///< dynamic pressure at outlets, behind the frit [Pa]
  std::vector<double> frit_resistance;  ///< of inlets and outlets, else 0 [1/m]
  bool has_outlet = false;              ///< of any rank

  [[nodiscard]] std::size_t size() const { return kind.size(); }
};

Border border(const Boundaries& boundaries, const Domain& domain);

/// Brings inlet velocities to a time [s] and outlet pressures to the place of the faces: p - rho g.x.
void update(Border& border,
            const Boundaries& boundaries,
            const Domain& domain,
            double time,
            const Vec3& rho_g);

/// Interstitial velocity at border face b, in a cell of velocity `u` and void fraction `eps`, `normal_flux`
/// (eps u).n passing it.
inline Vec3 border_velocity(
    const Border& border, std::size_t b, const Vec3& n, const Vec3& u, double normal_velocity) {
  switch (border.kind[b]) {
    case BorderKind::wall:
      return border.wall_velocity[b] + normal_velocity * n;
    case BorderKind::slip:
      return u + (normal_velocity - dot(u, n)) * n;
    case BorderKind::inlet:
    case BorderKind::outlet:
      break;
  }
  // What flows in has no velocity along the patch; what flows out keeps it.
  return normal_velocity < 0.0 ? normal_velocity * n : u + (normal_velocity - dot(u, n)) * n;
}

}  // namespace packbed::fluid
