// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Stress that the contacts of the beads carry, in horizontal slabs of a column.

#include <span>
#include <vector>

#include "analysis/bead.hpp"
#include "analysis/contact_force.hpp"
#include "analysis/symmetric.hpp"

namespace packbed::analysis {

/// Mean stress of a slab, compression positive.
struct StressBin {
  Range z;           ///< [m]
  Symmetric stress;  ///< symmetric part [Pa]

  [[nodiscard]] double axial() const { return stress.zz; }                        ///< [Pa]
  [[nodiscard]] double lateral() const { return 0.5 * (stress.xx + stress.yy); }  ///< [Pa]
  /// K = lateral / axial; 0 where there is no axial compression.
  [[nodiscard]] double lateral_ratio() const { return axial() > 0.0 ? lateral() / axial() : 0.0; }
};

/// Love and Weber's mean over each slab between consecutive `edges` (heights, ascending, at least two) of a
/// column of cross-section `area` [m2]:
///   sigma = -1 / (A dz) sum over contacts of s F l^T,  symmetric part,
/// F the force on bead i, l the branch from i to j or to the wall, s the part of l that lies in the slab; a
/// level branch lies in one slab. Walls count as contacts. With s the mean is exact for the forces as
/// they pass along straight branches: sigma_zz A is the mean over the slab's heights of the force through
/// the plane there. `tangential` holds the tangential forces on i, one per contact, or is empty:
/// frames hold their amounts alone, and the stress is then that of the normal forces. Branches that reach
/// beyond the edges count with the part within them; a column that is periodic in z is not wrapped.
/// ValueError if edges, area or the number of tangential forces do not fit.
/// Source: Love, A Treatise on the Mathematical Theory of Elasticity (1927), note B; Weber, Bulletin de
/// liaison P. et Ch. 20 (1966) 1.
std::vector<StressBin> stress_profile(std::span<const ContactForce> contacts,
                                      std::span<const Vec3> tangential,
                                      std::span<const double> edges,
                                      double area);

}  // namespace packbed::analysis
