// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace packbed::study {

/// Relaxation of one bead at one depth, as fitted.
struct Relaxation {
  double contact_radius = 0.0;     ///< a [m]
  double duration = 0.0;           ///< of the data [s]
  double shortest = 0.0;           ///< between rows [s]
  std::vector<double> amplitudes;  ///< B_i, in any scale
  std::vector<double> times;       ///< tau_i [s]

  /// (F - F_inf) / (F_0 - F_inf), F_0 at t = 0. Thesis eq. 3.38, left side.
  [[nodiscard]] double normalized(double t) const;
};

/// Test of thesis section 6.6: do relaxations at several depths fall on one curve over the time, as those of a
/// viscoelastic bead, or over time / a^2, as those of a poroelastic one?
struct Collapse {
  double spread_over_time =
      0.0;  ///< root mean square over the axis of the deviation between the curves [-]
  double spread_over_scaled = 0.0;  ///< the same over t / a^2
  [[nodiscard]] bool is_viscoelastic() const { return spread_over_time < spread_over_scaled; }
};

/// For two curves or more, with different contact radii; over the logarithm of the range that all curves cover.
/// Throws ValueError otherwise.
Collapse collapse(const std::vector<Relaxation>& curves);

}  // namespace packbed::study
