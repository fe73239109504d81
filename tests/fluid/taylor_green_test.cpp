// SPDX-License-Identifier: BSD-3-Clause
// F1: decaying vortices in a doubly periodic box, an exact solution of the Navier-Stokes equations.
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/fluid.hpp"

namespace packbed::fluid {
namespace {

using namespace test;  // NOLINT

constexpr double side = 1e-3;
constexpr double rho = 1000.0;
constexpr double mu = 1e-3;
constexpr double speed = 10e-3;  // Reynolds number 10
constexpr double wave = 2.0 * std::numbers::pi / side;

// u = U sin kx cos kz, w = -U cos kx sin kz, p = rho U^2 / 4 (cos 2kx + cos 2kz), all decaying with
// exp(-2 nu k^2 t), p with its square.
Vec3 velocity(const Vec3& x, double t) {
  const double decay = speed * std::exp(-2.0 * mu / rho * wave * wave * t);
  return {decay * std::sin(wave * x.x) * std::cos(wave * x.z), 0.0,
          -decay * std::cos(wave * x.x) * std::sin(wave * x.z)};
}
double pressure(const Vec3& x, double t) {
  const double decay = speed * std::exp(-2.0 * mu / rho * wave * wave * t);
  return rho * decay * decay / 4.0 * (std::cos(2 * wave * x.x) + std::cos(2 * wave * x.z));
}

Fluid vortices(int n, double crank_nicolson, Convection convection) {
  FluidOptions o{.rho_f = rho, .mu_f = mu, .gravity = {}};
  o.crank_nicolson = crank_nicolson;
  o.convection = convection;
  o.pressure_tolerance = 1e-10;
  o.momentum_tolerance = 1e-10;
  const BoxCase box{{side, side / 4, side},
                    {n, 1, n},
                    {Boundary::periodic, Boundary::periodic, Boundary::periodic}};
  auto fluid = make_fluid(o, box.mesh());
  fluid.start({}, field(fluid, [](const Vec3& x) { return velocity(x, 0.0); }), 0.0);
  return fluid;
}

constexpr double end = 5e-3;

struct Errors {
  double u, p;
};
Errors errors(int n, int steps, double crank_nicolson, Convection convection) {
  auto fluid = vortices(n, crank_nicolson, convection);
  for (int k = 0; k < steps; ++k) fluid.step(end / steps, {});
  const double t = fluid.time();
  return {
      velocity_error(fluid, [&](const Vec3& x) { return velocity(x, t); }) / speed,
      pressure_error(fluid, [&](const Vec3& x) { return pressure(x, t); }) / (rho * speed * speed)};
}

TEST(TaylorGreen, DecaysWithOrderTwoInSpace) {
  for (const auto convection : {Convection::central, Convection::limited}) {
    std::vector<double> h;
    std::vector<double> u;
    std::vector<double> p;
    for (const int n : {8, 16, 32, 64}) {
      const auto e = errors(n, n, 1.0, convection);
      h.push_back(1.0 / n);
      u.push_back(e.u);
      p.push_back(e.p);
    }

    EXPECT_GT(fitted_order(h, u), 1.9);
    EXPECT_GT(fitted_order(h, p), 1.8);
    EXPECT_LT(u.back(), 1e-3);
  }
}

// From above: at Reynolds number 10 the error of second order of the viscous term counts on coarse meshes.
TEST(TaylorGreen, ComesToOrderOneWithUpwind) {
  double error = errors(8, 8, 1.0, Convection::upwind).u;
  double order = 2.0;
  for (const int n : {16, 32, 64}) {
    const double finer = errors(n, n, 1.0, Convection::upwind).u;
    const double of_pair = std::log2(error / finer);
    EXPECT_GT(of_pair, 1.0);
    EXPECT_LT(of_pair, order);
    order = of_pair;
    error = finer;
  }
  EXPECT_LT(order, 1.2);
}

// Against a run of very small steps on the same mesh, from a state that it has passed: what was started from
// velocities alone has no pressure in its first step.
TEST(TaylorGreen, HasTheOrderOfItsTimeScheme) {
  const struct { double crank_nicolson, order; } schemes[] = {{0.0, 1.0}, {0.3, 1.0}, {1.0, 2.0}};
  auto fine = vortices(16, 1.0, Convection::central);
  for (int k = 0; k < 640; ++k) fine.step(end / 640, {});
  const auto begin = fine.save();
  for (int k = 0; k < 640; ++k) fine.step(end / 640, {});
  for (const auto& scheme : schemes) {
    std::vector<double> dt;
    std::vector<double> u;
    for (const int steps : {10, 20, 40, 80}) {
      auto fluid = vortices(16, scheme.crank_nicolson, Convection::central);
      fluid.load(begin);
      for (int k = 0; k < steps; ++k) fluid.step(end / steps, {});
      dt.push_back(1.0 / steps);
      u.push_back(l2_norm(fluid, [&](std::size_t c) { return norm(fluid.u()[c] - fine.u()[c]); }));
    }

    EXPECT_NEAR(fitted_order(dt, u), scheme.order, 0.1) << scheme.crank_nicolson;
  }
}

}  // namespace
}  // namespace packbed::fluid
