// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace packbed::coupling {

/// Di Felice 1994 with the drag coefficient of Dallavalle:
///   F = C_d Re / 24 alpha_f^-chi,  C_d = (0.63 + 4.8 / sqrt(Re))^2
///   chi = 3.7 - 0.65 exp(-(1.5 - log10 Re)^2 / 2)
struct DiFelice {
  static constexpr const char* name = "di_felice";

  double operator()(double solid_fraction, double reynolds) const {
    const double root = 0.63 * std::sqrt(reynolds) + 4.8;
    const double decades = reynolds > 0.0 ? 1.5 - std::log10(reynolds) : 1e3;
    const double chi = 3.7 - 0.65 * std::exp(-0.5 * decades * decades);
    return root * root / 24.0 * std::pow(1.0 - solid_fraction, -chi);
  }
};

}  // namespace packbed::coupling
