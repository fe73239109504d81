// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "coupling/drag/ergun.hpp"

namespace packbed::coupling {

/// Gidaspow 1994: Ergun up to a solid fraction of 0.2, below it Wen and Yu 1966,
///   F = alpha_f^-3.65 C_d Re / 24,  C_d = 24 (1 + 0.15 Re^0.687) / Re,  0.44 from Re = 1000 on.
/// Jumps at 0.2, as published.
struct Gidaspow {
  static constexpr const char* name = "gidaspow";

  double operator()(double solid_fraction, double reynolds) const {
    if (solid_fraction > 0.2) return Ergun{}(solid_fraction, reynolds);
    const double single =
        reynolds < 1000.0 ? 1.0 + 0.15 * std::pow(reynolds, 0.687) : 0.44 * reynolds / 24.0;
    return single * std::pow(1.0 - solid_fraction, -3.65);
  }
};

}  // namespace packbed::coupling
