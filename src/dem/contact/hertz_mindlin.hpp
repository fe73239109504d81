// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string_view>

#include "dem/contact/contact.hpp"

namespace packbed::dem {

/// Hertz normal force, Mindlin no-slip tangential stiffness, damping with constant restitution:
///
///   F_n = 4/3 Y* sqrt(R* overlap) overlap - gamma_n v_n       F_t = -k_t spring - gamma_t u_t
///   k_t = 8 G* sqrt(R* overlap)
///   gamma = 2 sqrt(5/6) beta sqrt(S m*)     S_n = 2 Y* sqrt(R* overlap),  S_t = 8 G* sqrt(R* overlap)
///   beta  = |ln e| / sqrt(ln^2 e + pi^2)
///
/// With tension the restitution is e at any speed and mass (sqrt(5) ln e form, exact to 4e-6);
/// without it the map is that of the linear law (0.5 becomes 0.5503).
/// Valid for contact radii well below the bead's (overlap below a few per cent of the radius).
///
/// Source: thesis eqs 4.14-4.20; Johnson, Contact Mechanics (1985).
struct HertzMindlin {
  static constexpr std::string_view name = "hertz";

  double restitution = 0.0;  ///< e, (0, 1]
  bool tension = false;      ///< whether the damped force may pull

  /// a = 4/3 Y* sqrt(R*) [N/m^1.5], b = gamma_n / overlap^(1/4), c = k_t / k_n = 6 G* / Y*.
  [[nodiscard]] Coefficients coefficients(const Pair& pair) const {
    const double y = effective_modulus(pair.i, pair.j);
    const double g = effective_shear_modulus(pair.i, pair.j);
    const double root_r = std::sqrt(pair.r_eff);
    return {.a = 4.0 / 3.0 * y * root_r,
            .b = 2.0 * std::sqrt(5.0 / 6.0) * damping_ratio(restitution) *
                 std::sqrt(2.0 * y * root_r * pair.m_scaled),
            .c = 6.0 * g / y};
  }

  Response operator()(double overlap, double v_n, const Coefficients& k) const noexcept {
    const double root = std::sqrt(overlap > 0.0 ? overlap : 0.0);
    const double k_n = k.a * root;
    const double gamma_n = k.b * std::sqrt(root);
    return {.f_n = touching_force(k_n * overlap - gamma_n * v_n, overlap, tension),
            .k_t = k.c * k_n,
            .gamma_t = gamma_n * std::sqrt(2.0 / 3.0 * k.c)};  // S_t / S_n = 4 G* / Y*
  }

  [[nodiscard]] double stiffness(double overlap, const Coefficients& k) const {
    return 1.5 * k.a * std::sqrt(overlap > 0.0 ? overlap : 0.0);
  }
  [[nodiscard]] double damping(double overlap, const Coefficients& k) const {
    return k.b * std::sqrt(std::sqrt(overlap > 0.0 ? overlap : 0.0));
  }
  /// Stored by the normal spring at an overlap >= 0 [J].
  [[nodiscard]] double energy(double overlap, const Coefficients& k) const {
    return 0.4 * k.a * std::sqrt(overlap) * overlap * overlap;
  }
};

static_assert(ContactLawType<HertzMindlin>);

}  // namespace packbed::dem
