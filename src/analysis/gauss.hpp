// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Gauss-Legendre quadrature on (-1, 1).

#include <array>
#include <cstddef>

namespace packbed::analysis {

inline constexpr std::size_t gauss_points = 32;

struct GaussRule {
  std::array<double, gauss_points> node{};
  std::array<double, gauss_points> weight{};
};

const GaussRule& gauss_rule();

}  // namespace packbed::analysis
