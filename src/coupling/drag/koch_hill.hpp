// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace packbed::coupling {

/// Koch and Hill 2001 in the simplified form of thesis eqs 4.6-4.9:
///   F  = alpha_f (F_0 + F_3 Re / 2)
///   F_0 = (1 + 3 sqrt(a/2) + 135/64 a ln a + 16.14 a) / (1 + 0.681 a - 8.48 a^2 + 8.16 a^3)   a < 0.4
///       = 10 a / alpha_f^3                                                                    a >= 0.4
///   F_3 = 0.0673 + 0.212 a + 0.0232 / alpha_f^5
/// with a the solid fraction. At a >= 0.4 and Re -> 0 a bed then has the pressure drop of Kozeny and
/// Carman with the factor 180, exactly. F_0 jumps by 1.04 % at 0.4, as published.
struct KochHill {
  static constexpr const char* name = "koch_hill";

  static double f0(double a) {
    const double alpha_f = 1.0 - a;
    if (a >= 0.4) return 10.0 * a / (alpha_f * alpha_f * alpha_f);
    const double log_term = a > 0.0 ? 135.0 / 64.0 * a * std::log(a) : 0.0;
    return (1.0 + 3.0 * std::sqrt(0.5 * a) + log_term + 16.14 * a) /
           (1.0 + a * (0.681 + a * (-8.48 + a * 8.16)));
  }

  static double f3(double a) {
    const double alpha_f = 1.0 - a;
    return 0.0673 + 0.212 * a + 0.0232 / (alpha_f * alpha_f * alpha_f * alpha_f * alpha_f);
  }

  double operator()(double solid_fraction, double reynolds) const {
    return (1.0 - solid_fraction) * (f0(solid_fraction) + 0.5 * f3(solid_fraction) * reynolds);
  }
};

}  // namespace packbed::coupling
