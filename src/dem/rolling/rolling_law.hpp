// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The laws of rolling resistance. Conventions of all of them:
///
///   w_r     relative spin w_i - w_j without its part along the normal (torsion is left out)
///   angle   rolling spring: integral of w_r, kept in the contact plane by the caller [rad]
///   torque  acts on i against w_r; j receives its opposite [N m]
///
/// Branch-free and on plain doubles, like the contact laws.

#include <cmath>
#include <string_view>
#include <variant>

#include "core/vec3.hpp"

namespace packbed::dem {

/// What a rolling law is given of a contact, besides w_r.
struct RollingContact {
  double r_eff;      ///< R* [m]
  double f_n;        ///< normal force, absolute value [N]; 0 where the bodies do not touch
  double f_elastic;  ///< its elastic part [N]
  double k_t;        ///< tangential stiffness [N/m]
  double dt;         ///< [s]
};

struct NoRolling {
  static constexpr std::string_view name = "none";

  Vec3 operator()(const Vec3& /*w_r*/, const RollingContact& /*c*/, Vec3& angle) const noexcept {
    angle = {};
    return {};
  }
};

/// Constant directional torque, torque = -mu_r F_elastic R* w_r / |w_r|.
/// At rest it chatters about zero with spins of the order of torque dt / I: for moving beads.
/// Source: LIGGGHTS rolling_model_cdt; thesis section 8.3 (mu_R).
struct ConstantTorque {
  static constexpr std::string_view name = "cdt";
  double mu_r;  ///< coefficient of rolling friction

  Vec3 operator()(const Vec3& w_r, const RollingContact& c, Vec3& angle) const noexcept {
    constexpr double tiny = 1e-300;  // no spin, no torque
    const double torque = c.f_n > 0.0 ? mu_r * c.f_elastic * c.r_eff : 0.0;
    angle = {};
    return (-torque / std::sqrt(dot(w_r, w_r) + tiny)) * w_r;
  }
};

/// Elastic-plastic spring without dashpot (EPSD2): comes to rest.
///   torque = -k_r angle,  k_r = k_t R*^2,  |torque| <= mu_r R* |F_n|
/// Beyond the limit the spring is cut back to it. Source: LIGGGHTS rolling_model_epsd2.
struct ElasticPlastic {
  static constexpr std::string_view name = "epsd";
  double mu_r;  ///< coefficient of rolling friction

  Vec3 operator()(const Vec3& w_r, const RollingContact& c, Vec3& angle) const noexcept {
    constexpr double tiny = 1e-300;
    const double k_r = c.k_t * c.r_eff * c.r_eff;
    angle += c.dt * w_r;
    const double trial = k_r * std::sqrt(dot(angle, angle));
    const double limit = mu_r * c.r_eff * c.f_n;
    angle *= trial > limit ? limit / (trial + tiny) : 1.0;
    return -k_r * angle;
  }
};

using RollingLaw = std::variant<NoRolling, ConstantTorque, ElasticPlastic>;

}  // namespace packbed::dem
