// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Manufactured solutions of the volume-averaged equations (F4): eps, p and A = eps u with div A = -d(eps)/dt are given;
/// the force that makes them a solution follows by differences of fourth order.

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <type_traits>

#include "tests/support/fluid.hpp"

namespace packbed::test {

struct Manufactured {
  std::function<double(const Vec3&, double)> eps, p;
  std::function<Vec3(const Vec3&, double)> superficial;
  double rho, mu, exchange;
  double length;  ///< over which fields change [m]
  double time;    ///< likewise [s]

  [[nodiscard]] Vec3 u(const Vec3& x, double t) const {
    return (1.0 / eps(x, t)) * superficial(x, t);
  }

  /// rho [d(A)/dt + div(A u)] + eps grad p - div(eps tau) + exchange u
  [[nodiscard]] Vec3 force(const Vec3& x, double t) const {
    Vec3 f = rho * along_time(t, [&](double s) { return superficial(x, s); }) + exchange * u(x, t);
    for (int j = 0; j < 3; ++j) {
      f += along(x, j, [&](const Vec3& y) {
        return (rho * component(superficial(y, t), j)) * u(y, t) - traction(y, t, j);
      });
      f += (eps(x, t) * along(x, j, [&](const Vec3& y) { return p(y, t); })) * unit(j);
    }
    return f;
  }

 private:
  static Vec3 unit(int j) { return {j == 0 ? 1.0 : 0.0, j == 1 ? 1.0 : 0.0, j == 2 ? 1.0 : 0.0}; }
  static double component(const Vec3& v, int j) { return dot(v, unit(j)); }
  /// Column j of eps tau.
  [[nodiscard]] Vec3 traction(const Vec3& x, double t, int j) const {
    std::array<Vec3, 3> d{};  // d[k] = d u / d x_k
    for (int k = 0; k < 3; ++k) {
      d[static_cast<std::size_t>(k)] = along(x, k, [&](const Vec3& y) { return u(y, t); });
    }
    const Vec3 transposed{component(d[0], j), component(d[1], j), component(d[2], j)};
    const double divergence = d[0].x + d[1].y + d[2].z;
    return (eps(x, t) * mu) *
           (d[static_cast<std::size_t>(j)] + transposed - (2.0 / 3.0 * divergence) * unit(j));
  }
  // Fourth order, steps of a thousandth: right to 1e-11, rounding of nested ones to 1e-9.
  template <class Function>
  [[nodiscard]] std::invoke_result_t<Function, Vec3> along(const Vec3& x, int j, Function g) const {
    const double h = 1e-3 * length;
    const Vec3 e = h * unit(j);
    return (1.0 / (12.0 * h)) * (8.0 * (g(x + e) - g(x - e)) - 1.0 * (g(x + e + e) - g(x - e - e)));
  }
  template <class Function>
  [[nodiscard]] std::invoke_result_t<Function, double> along_time(double t, Function g) const {
    const double h = 1e-3 * time;
    return (1.0 / (12.0 * h)) * (8.0 * (g(t + h) - g(t - h)) - 1.0 * (g(t + 2 * h) - g(t - 2 * h)));
  }
};

inline constexpr double manufactured_speed = 1e-2;  // m/s; Reynolds number 10

/// Periodic in x and z with `side`: eps = 0.6 + 0.2 sin kx sin kz (1 + sin(w t))/2.
inline Manufactured manufactured_box(double side) {
  const double k = 2.0 * std::numbers::pi / side;
  const double w = 2.0 * std::numbers::pi / 50e-3;
  const double speed = manufactured_speed;
  const auto eps = [=](const Vec3& x, double t) {
    return 0.6 + 0.1 * (1.0 + std::sin(w * t)) * std::sin(k * x.x) * std::sin(k * x.z);
  };
  const auto superficial = [=](const Vec3& x, double t) {
    const double rate = 0.1 * w * std::cos(w * t) / (2.0 * k);
    const double turn = 0.5 * speed * std::cos(w * t);
    return Vec3{
        turn * std::sin(k * x.x) * std::cos(k * x.z) + rate * std::cos(k * x.x) * std::sin(k * x.z),
        0.0,
        -turn * std::cos(k * x.x) * std::sin(k * x.z) +
            rate * std::sin(k * x.x) * std::cos(k * x.z)};
  };
  const auto p = [=](const Vec3& x, double t) {
    return 1000.0 * speed * speed * std::cos(k * x.x) * std::cos(k * x.z) *
           (1.0 + 0.5 * std::sin(w * t));
  };
  return {eps, p, superficial, 1000.0, 1e-3, 1e5, side, 50e-3};
}

/// In a closed cylinder of radius and height `size`, no flow at its walls: eps = 0.6 + (1 + sin wt)/2 div V with V along
/// z; A = -d(eps)/dt part + two vortices, one across and one along the axis.
inline Manufactured manufactured_cylinder(double radius) {
  const double height = 2.0 * radius;
  const double w = 2.0 * std::numbers::pi / 50e-3;
  const double k = std::numbers::pi / height;
  const double speed = manufactured_speed;
  const auto bell = [=](const Vec3& x) {
    const double b = 1.0 - (x.x * x.x + x.y * x.y) / (radius * radius);
    return b * b;
  };
  const auto slope = [=](const Vec3& x) {  // of the bell over x and y, over x and y
    return -4.0 / (radius * radius) * (1.0 - (x.x * x.x + x.y * x.y) / (radius * radius));
  };
  const auto eps = [=](const Vec3& x, double t) {
    return 0.6 + 0.1 * (1.0 + std::sin(w * t)) * bell(x) * std::sin(2.0 * k * x.z);
  };
  const auto superficial = [=](const Vec3& x, double t) {
    const double sine = std::sin(k * x.z);
    const double height_part = sine * sine;
    const double swirl = 0.3 * speed * radius * std::cos(w * t);
    Vec3 a{-swirl * slope(x) * x.y * height_part, swirl * slope(x) * x.x * height_part, 0.0};
    const double roll = 0.3 * speed * height / std::numbers::pi;
    a += Vec3{-roll * bell(x) * k * std::sin(2.0 * k * x.z), 0.0,
              roll * slope(x) * x.x * height_part};
    a.z -= 0.1 * w * std::cos(w * t) / k * bell(x) * height_part;
    return a;
  };
  const auto p = [=](const Vec3& x, double t) {
    return 1000.0 * speed * speed * std::cos(k * x.z) * (1.0 + x.x / radius) *
           (1.0 + 0.5 * std::sin(w * t));
  };
  return {eps, p, superficial, 1000.0, 1e-3, 1e5, radius, 50e-3};
}

inline fluid::FluidOptions manufactured_options(const Manufactured& m) {
  fluid::FluidOptions o{.rho_f = m.rho, .mu_f = m.mu, .gravity = {}};
  o.boundaries.inlet = o.boundaries.outlet = fluid::Wall{};
  o.convection = fluid::Convection::central;
  o.pressure_tolerance = 1e-9;
  o.momentum_tolerance = 1e-9;
  return o;
}

struct SolutionErrors {
  double u, p;  ///< 2-norms over speed and rho speed^2
};

/// Errors after `steps` steps to `end` [s] from the exact state.
inline SolutionErrors manufactured_errors(const Manufactured& m,
                                          const mesh::ColumnMesh& mesh,
                                          double end,
                                          int steps) {
  auto fluid = make_fluid(manufactured_options(m), mesh);
  const auto bed_at = [&](double t) {
    fluid::Bed bed;
    bed.eps = field(fluid, [&](const Vec3& x) { return m.eps(x, t); });
    bed.exchange.assign(bed.eps.size(), m.exchange);
    bed.force = field(fluid, [&](const Vec3& x) { return m.force(x, t); });
    return bed;
  };
  fluid.start(bed_at(0.0), field(fluid, [&](const Vec3& x) { return m.u(x, 0.0); }), 0.0);
  for (int n = 1; n <= steps; ++n) fluid.step(end / steps, bed_at(n * end / steps));
  const double speed = manufactured_speed;
  return {
      velocity_error(fluid, [&](const Vec3& x) { return m.u(x, end); }) / speed,
      pressure_error(fluid, [&](const Vec3& x) { return m.p(x, end); }) / (m.rho * speed * speed)};
}

}  // namespace packbed::test
