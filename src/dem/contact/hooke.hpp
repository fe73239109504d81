// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string_view>

#include "dem/contact/contact.hpp"

namespace packbed::dem {

/// Linear spring and dashpot whose stiffness follows from a characteristic impact velocity V:
///
///   F_n = k_n overlap - gamma v_n          F_t = -k_t spring - gamma u_t,   k_t = k_n
///   k_n = 16/15 sqrt(R*) Y* (15 m* V^2 / (16 sqrt(R*) Y*))^(1/5)
///   gamma = sqrt(4 m* k_n / (1 + (pi / ln e)^2))
///
/// An undamped impact at V stores the same energy as Hertz's law. k_n scales with the diameter,
/// so overlap / diameter is the same for coarse grains. k_n takes the true mass, gamma the
/// moving one, so that e holds for scaled inertia too.
///
/// With tension the restitution is e exactly; without it 0.5 becomes 0.5503 (0.9: 0.9020).
///
/// Source: thesis eqs 4.21 (misprinted: its roots hold R* alone, by units and by the Hertz limit)
/// and 4.22.
struct Hooke {
  static constexpr std::string_view name = "hooke";

  double characteristic_velocity = 0.0;  ///< V [m/s]
  double restitution = 0.0;              ///< e, (0, 1]
  bool tension = false;                  ///< whether the damped force may pull

  /// a = k_n [N/m], b = gamma [kg/s].
  [[nodiscard]] Coefficients coefficients(const Pair& pair) const {
    const double y = effective_modulus(pair.i, pair.j);
    const double v = characteristic_velocity;
    const double c = std::sqrt(pair.r_eff) * y;
    const double k_n = 16.0 / 15.0 * c * std::pow(15.0 * pair.m_eff * v * v / (16.0 * c), 0.2);
    return {.a = k_n, .b = 2.0 * damping_ratio(restitution) * std::sqrt(pair.m_scaled * k_n)};
  }

  Response operator()(double overlap, double v_n, const Coefficients& k) const noexcept {
    return {.f_n = touching_force(k.a * overlap - k.b * v_n, overlap, tension),
            .k_t = k.a,
            .gamma_t = k.b};
  }

  [[nodiscard]] double stiffness(double /*overlap*/, const Coefficients& k) const { return k.a; }
  [[nodiscard]] double damping(double /*overlap*/, const Coefficients& k) const { return k.b; }
  /// Stored by the normal spring at an overlap >= 0 [J].
  [[nodiscard]] double energy(double overlap, const Coefficients& k) const {
    return 0.5 * k.a * overlap * overlap;
  }
};

static_assert(ContactLawType<Hooke>);

}  // namespace packbed::dem
