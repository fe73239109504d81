// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// One contact from its kinematics: normal law, tangential spring with Coulomb limit, rolling.
/// The same function serves beads on beads, beads on walls, tests and reports.

#include <cmath>

#include "core/vec3.hpp"
#include "dem/contact/contact.hpp"
#include "dem/rolling/rolling_law.hpp"

namespace packbed::dem {

/// Relative motion of two bodies; signs in contact.hpp.
struct Kinematics {
  Vec3 normal;
  double overlap = 0.0;  ///< [m]
  Vec3 velocity;         ///< v_i - v_j [m/s]
  Vec3 surface;          ///< c_i w_i + c_j w_j [m/s]
  Vec3 spin;             ///< w_i - w_j [rad/s]
  double r_eff = 0.0;    ///< R* [m]
};

/// Springs of one contact, carried from step to step.
struct History {
  Vec3 spring;  ///< tangential [m]
  Vec3 angle;   ///< rolling [rad]
};

/// On body i; body j gets the opposite force and rolling torque, and its own lever arm.
struct ContactLoad {
  Vec3 normal;      ///< [N]
  Vec3 tangential;  ///< [N]
  Vec3 rolling;     ///< [N m]
};

// A contact in three parts: the normal law and the tangential spring as if it sticks, the Coulomb limit,
// rolling. evaluate_contact() does all of them.

/// Turns the spring into the present contact plane and moves it on by dt; gives the slip u_t [m/s].
template <class Law>
inline Response press(const Law& law,
                      double dt,
                      const Kinematics& c,
                      const Coefficients& k,
                      Vec3& spring,
                      Vec3& slip) {
  const Vec3 n = c.normal;
  const double v_n = dot(c.velocity, n);
  slip = c.velocity - v_n * n - cross(c.surface, n);
  spring = spring - dot(spring, n) * n + dt * slip;
  return law(c.overlap, v_n, k);
}

/// The Coulomb limit: cuts the spring back and returns the tangential force.
inline Vec3 hold(const Response& r, double mu, bool touches, const Vec3& slip, Vec3& spring) {
  constexpr double tiny = 1e-300;  // 0 / 0 of contacts without force gives 0
  const double trial = r.k_t * norm(spring);
  const double limit = mu * std::abs(r.f_n);
  const bool slides = trial >= limit;  // without friction there is no dashpot either
  const double keep = slides ? limit / (trial + tiny) : 1.0;
  spring *= touches ? keep : 0.0;
  const double gamma_t = slides || !touches ? 0.0 : r.gamma_t;
  return -r.k_t * spring - gamma_t * slip;
}

/// Rolling torque on i from the relative spin w_i - w_j; moves the rolling spring on.
template <class Rolling>
inline Vec3 roll(const Rolling& rolling,
                 const RollingContact& c,
                 bool touches,
                 const Vec3& n,
                 const Vec3& spin,
                 Vec3& angle) {
  angle = angle - dot(angle, n) * n;
  Vec3 torque = rolling(spin - dot(spin, n) * n, c, angle);
  angle *= touches ? 1.0 : 0.0;
  torque *= touches ? 1.0 : 0.0;
  return torque;
}

/// Evaluates one contact and moves its springs on by dt.
///
///   F_t = -k_t spring - gamma_t u_t    while k_t |spring| <  mu |F_n|  (sticking)
///   F_t = -k_t spring                  otherwise, the spring cut back to mu |F_n| / k_t (sliding)
///
/// The springs are turned into the present contact plane before they are moved. A contact that does
/// not touch has no force and loses its springs.
/// Source: thesis eq. 4.13 and the Coulomb limit below it; cut-back as in LIGGGHTS (history).
template <class Law, class Rolling>
inline ContactLoad evaluate_contact(const Law& law,
                                    const Rolling& rolling,
                                    double mu,
                                    double dt,
                                    const Kinematics& c,
                                    const Coefficients& k,
                                    History& history) {
  Vec3 slip;
  const Response r = press(law, dt, c, k, history.spring, slip);
  const Vec3 tangential = hold(r, mu, c.overlap > 0.0, slip, history.spring);
  const RollingContact rc{.r_eff = c.r_eff,
                          .f_n = std::abs(r.f_n),
                          .f_elastic = law(c.overlap, 0.0, k).f_n,
                          .k_t = r.k_t,
                          .dt = dt};
  const Vec3 torque = roll(rolling, rc, c.overlap > 0.0, c.normal, c.spin, history.angle);
  return {.normal = r.f_n * c.normal, .tangential = tangential, .rolling = torque};
}

}  // namespace packbed::dem
