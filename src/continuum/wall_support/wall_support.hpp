// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// One-dimensional bed in a column, compressed by the liquid and carried in part by the wall. z points down from
/// the top of the bed. Thesis eqs 7.6 to 7.10:
///   d sigma/dz = -dp/dz - (4/D) mu_w nu/(1 - nu) sigma + delta_rho (1 - eps) g,   sigma(0) = 0
///   -dp/dz = 180 mu_f (1 - eps)^2 u / (d^2 eps^3)
///   sigma = S(lambda) (bed_modulus.hpp),  eps = (eps0 - lambda) / (1 - lambda)
/// lambda is per undeformed length (eq. 7.9), so dz = (1 - lambda) dZ with Z from 0 to the settled height H0. The
/// thesis does not say over which height it integrated; `Reading` has both ways. docs/theory/wall_support.md.

#include <limits>
#include <optional>
#include <vector>

#include "continuum/wall_support/bed_modulus.hpp"

namespace packbed::continuum {

/// What the column is filled with.
struct CompressibleBed {
  BedModulus modulus;
  double diameter = 0.0;            ///< d, hydrodynamically relevant bead size [m]
  double wall_friction = 0.0;       ///< mu_w [-]
  double poisson = 0.0;             ///< nu of the bed [-], below 1
  double density_difference = 0.0;  ///< bead less liquid [kg/m3]
  double eps0 = 0.0;                ///< porosity settled by gravity [-]
};

/// Which height is given.
enum class Reading {
  material,  ///< the settled height H0: the bed gets lower
  fixed,     ///< the height of the bed under flow, as if it were kept
};

struct WallSupportColumn {
  double diameter = std::numeric_limits<double>::infinity();  ///< D [m]; infinite: no wall
  double height = 0.0;                                        ///< [m], see Reading
  double mu_f = 1e-3;                                         ///< [Pa s]
  double gravity = 9.81;                                      ///< [m/s2]; thesis table B.1
  Reading reading = Reading::material;
};

/// State of the bed at one depth.
struct BedDepth {
  double z = 0.0;        ///< below the top of the compressed bed [m]
  double settled = 0.0;  ///< the same material in the settled bed, Z [m]
  double stress = 0.0;   ///< sigma [Pa]
  double compression = 0.0;
  double porosity = 0.0;
  double pressure = 0.0;  ///< lost since the top [Pa]
};

struct WallSupportResult {
  double pressure_drop = 0.0;             ///< [Pa], thesis eq. 7.10
  double pressure_drop_per_height = 0.0;  ///< over the height under flow [Pa/m]
  double compression = 0.0;    ///< material: (H0 - H) / H0; fixed: mean of lambda over the height
  double bottom_stress = 0.0;  ///< [Pa]
  double bottom_compression = 0.0;  ///< the largest of the bed, but for gravity alone
  double height = 0.0;              ///< of the bed under flow [m]
  double settled_height = 0.0;      ///< of the same bed without flow [m]
  std::vector<BedDepth> profile;    ///< `points` depths, top and bottom among them
};

/// Steady bed at superficial velocity u [m/s] >= 0. Throws DivergenceError "no steady state above u_crit = ..."
/// if u is at or above critical_velocity; never a number.
WallSupportResult wall_support(const CompressibleBed& bed,
                               const WallSupportColumn& column,
                               double u,
                               int points = 101);

/// The same, and nothing if the integration meets closed pores: quicker where many beds are tried, as the critical
/// velocity is not worked out. `tolerance` is relative.
std::optional<WallSupportResult> try_wall_support(const CompressibleBed& bed,
                                                  const WallSupportColumn& column,
                                                  double u,
                                                  int points,
                                                  double tolerance);

/// The velocity [m/s] at which the pores close at the bottom of the bed: above it there is no steady state. 0 if
/// the bed collapses under its own weight.
double critical_velocity(const CompressibleBed& bed, const WallSupportColumn& column);

/// u_crit H0 without wall and gravity for a constant modulus, B d^2 I(eps0) / (180 mu_f c^2) with c = 1 - eps0 and
///   I(lambda) = [w^2/2 - 3 c w + 3 c^2 ln w + c^3 / w] from w = 1 - lambda to 1
/// in closed form [m2/s].
double critical_velocity_times_height(double modulus, double diameter, double eps0, double mu_f);

}  // namespace packbed::continuum
