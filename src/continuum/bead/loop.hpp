// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

namespace packbed::continuum {

/// Work put into a bead and given back over one loading and unloading.
struct LoopWork {
  double loading = 0.0;    ///< W [J]
  double unloading = 0.0;  ///< W' [J], while the force is positive

  /// e = sqrt(W' / W). Thesis eq. 3.22.
  [[nodiscard]] double restitution() const;
};

/// Integrals of F dDelta by the trapezium rule (thesis eqs 3.6, 3.10) over rows in the order of time: W up to
/// the largest Delta, W' from there until the force is no longer positive. Both of the same length.
/// Throws ValueError if there is no loading or no unloading in it.
LoopWork loop_work(std::span<const double> approach, std::span<const double> force);

}  // namespace packbed::continuum
