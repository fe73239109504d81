// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Where the normal forces between beads point (thesis fig. 10.8): axial, along the flow, or lateral. Only
/// contacts between beads that push (`pushes`) count; n is the contact normal.

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/contact_force.hpp"
#include "analysis/symmetric.hpp"

namespace packbed::analysis {

/// Contacts whose normal makes an angle asin(|n_z|) with the xy plane between low and high. A contact has no
/// direction, so 0 (lateral) to 90 degrees (axial) say all.
struct DirectionBin {
  double low = 0.0;            ///< [deg]
  double high = 0.0;           ///< [deg]
  std::int64_t contacts = 0;   ///< in it
  double density = 0.0;        ///< share of the contacts / (sin high - sin low); 1 if isotropic
  double mean_force = 0.0;     ///< over <F> of all
  double largest_force = 0.0;  ///< over <F> of all
  double above_share = 0.0;    ///< of the contacts in it, with F > multiple <F>
};

struct DirectionOptions {
  double width = 5.0;     ///< of a bin, > 0, the last one takes what is left [deg]
  double multiple = 3.0;  ///< for `above_share`
};

/// 0 to 90 degrees. ValueError for bins without width.
std::vector<DirectionBin> force_directions(std::span<const ContactForce> contacts,
                                           const DirectionOptions& options = {});

/// Mean of n n^T over contacts, and the same with each contact counted by its force:
///   fabric = <n n^T>,   force_fabric = sum F n n^T / sum F
/// Both have trace 1 and all of zz, xx, yy = 1/3 if isotropic.
struct Fabric {
  Symmetric contacts;
  Symmetric forces;

  /// Axial over lateral, sum F n_z^2 / (sum F (n_x^2 + n_y^2) / 2): 1 if balanced; 0 without lateral part.
  [[nodiscard]] double axial_to_lateral() const;
};
Fabric fabric(std::span<const ContactForce> contacts);

/// zz - trace / 3: how far a fabric is axial (> 0) or lateral (< 0).
double axial_excess(const Symmetric& fabric);

/// Size of the deviator a' = a - trace/3, sqrt(3/2 a':a'): 0 if isotropic, 1 if all normals are parallel.
double anisotropy(const Symmetric& fabric);

}  // namespace packbed::analysis
