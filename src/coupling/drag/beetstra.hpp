// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace packbed::coupling {

/// Beetstra, van der Hoef and Kuipers 2007, equal beads, with a the solid fraction:
///   F = 10 a / alpha_f^2 + alpha_f^2 (1 + 1.5 sqrt(a))
///       + 0.413 Re / (24 alpha_f^2) (1 / alpha_f + 3 a alpha_f + 8.4 Re^-0.343)
///                                   / (1 + 10^(3 a) Re^(-(1 + 4 a) / 2))
struct Beetstra {
  static constexpr const char* name = "beetstra";

  double operator()(double a, double reynolds) const {
    const double alpha_f = 1.0 - a;
    const double square = alpha_f * alpha_f;
    const double slow = 10.0 * a / square + square * (1.0 + 1.5 * std::sqrt(a));
    if (reynolds <= 0.0) return slow;
    const double above = 1.0 / alpha_f + 3.0 * a * alpha_f + 8.4 * std::pow(reynolds, -0.343);
    const double below = 1.0 + std::pow(10.0, 3.0 * a) * std::pow(reynolds, -0.5 * (1.0 + 4.0 * a));
    return slow + 0.413 * reynolds / (24.0 * square) * above / below;
  }
};

}  // namespace packbed::coupling
