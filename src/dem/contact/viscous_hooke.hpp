// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <numbers>
#include <string_view>

#include "dem/contact/hooke.hpp"

namespace packbed::dem {

/// The linear law with a restitution that a viscous liquid lowers, after Legendre et al. 2005 in
/// the form of LIGGGHTS ("viscous stokes"):
///
///   e = e_max exp(-St_c / St),   St = m* |v_n| / (6 pi eta R*^2)
///   gamma = 2 sqrt(m* k_n) L / sqrt(pi^2 + L^2),   L = -ln e = St_c / St - ln e_max
///
/// St is taken from the speed of the instant, by its absolute value (LIGGGHTS keeps the sign, which
/// damps the rebound less) and with the true mass. Written without a division by v_n: at rest the
/// damping is critical, gamma = 2 sqrt(m* k_n), so the stable step of a bed is several times smaller
/// than with a fixed e = 0.5.
///
/// Source: thesis section 8.3, eqs 4.21, 4.22; Legendre et al. 2005, as cited there.
struct ViscousHooke {
  static constexpr std::string_view name = "hooke_viscous";

  double characteristic_velocity = 0.0;  ///< V [m/s]
  double restitution_max = 0.0;          ///< e_max, (0, 1]
  double critical_stokes = 0.0;          ///< St_c
  double viscosity = 0.0;                ///< eta of the liquid [Pa s]
  bool tension = false;

  /// a = k_n [N/m], b = 2 sqrt(m* k_n) [kg/s], c = St_c |v_n| / St [m/s].
  [[nodiscard]] Coefficients coefficients(const Pair& pair) const {
    const double k_n = Hooke{.characteristic_velocity = characteristic_velocity, .restitution = 1.0}
                           .coefficients(pair)
                           .a;
    return {.a = k_n,
            .b = 2.0 * std::sqrt(pair.m_scaled * k_n),
            .c = critical_stokes * 6.0 * std::numbers::pi * viscosity * pair.r_eff * pair.r_eff /
                 pair.m_eff};
  }

  Response operator()(double overlap, double v_n, const Coefficients& k) const noexcept {
    const double speed = std::abs(v_n);
    const double l = k.c - std::log(restitution_max) * speed;  // L |v_n|
    constexpr double tiny = 1e-300;  // c = 0 and v_n = 0 together: no damping
    const double pi_v = std::numbers::pi * speed;
    const double gamma = k.b * l / std::sqrt(pi_v * pi_v + l * l + tiny);
    return {.f_n = touching_force(k.a * overlap - gamma * v_n, overlap, tension),
            .k_t = k.a,
            .gamma_t = gamma};
  }

  [[nodiscard]] double stiffness(double /*overlap*/, const Coefficients& k) const { return k.a; }
  [[nodiscard]] double damping(double /*overlap*/, const Coefficients& k) const { return k.b; }
  /// Stored by the normal spring at an overlap >= 0 [J].
  [[nodiscard]] double energy(double overlap, const Coefficients& k) const {
    return 0.5 * k.a * overlap * overlap;
  }
};

static_assert(ContactLawType<ViscousHooke>);

}  // namespace packbed::dem
