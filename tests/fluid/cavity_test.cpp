// SPDX-License-Identifier: BSD-3-Clause
// F3: cavity with a moving lid, Reynolds number 100, against U. Ghia, K. N. Ghia, C. T. Shin, J. Comput. Phys. 48
// (1982) 387, tables I and II.
#include <array>

#include <gtest/gtest.h>

#include "tests/support/fluid.hpp"

namespace packbed::fluid {
namespace {

using namespace test;  // NOLINT

struct Value {
  double at, velocity;
};
// Along the lid on the vertical line through the center; across it on the horizontal one. Lid at z = 1, towards x.
constexpr std::array<Value, 15> along = {{{0.9766, 0.84123},
                                          {0.9688, 0.78871},
                                          {0.9609, 0.73722},
                                          {0.9531, 0.68717},
                                          {0.8516, 0.23151},
                                          {0.7344, 0.00332},
                                          {0.6172, -0.13641},
                                          {0.5000, -0.20581},
                                          {0.4531, -0.21090},
                                          {0.2813, -0.15662},
                                          {0.1719, -0.10150},
                                          {0.1016, -0.06434},
                                          {0.0703, -0.04775},
                                          {0.0625, -0.04192},
                                          {0.0547, -0.03717}}};
constexpr std::array<Value, 15> across = {{{0.9688, -0.05906},
                                           {0.9609, -0.07391},
                                           {0.9531, -0.08864},
                                           {0.9453, -0.10313},
                                           {0.9063, -0.16914},
                                           {0.8594, -0.22445},
                                           {0.8047, -0.24533},
                                           {0.5000, 0.05454},
                                           {0.2344, 0.17527},
                                           {0.2266, 0.17507},
                                           {0.1563, 0.16077},
                                           {0.0938, 0.12317},
                                           {0.0781, 0.10890},
                                           {0.0703, 0.10091},
                                           {0.0625, 0.09233}}};

constexpr int n = 64;

/// Velocity at (x, z) between the centers of four cells.
Vec3 velocity_at(const Fluid& fluid, double x, double z) {
  const double i = std::clamp(x * n - 0.5, 0.0, n - 1.000001);
  const double k = std::clamp(z * n - 0.5, 0.0, n - 1.000001);
  const int i0 = static_cast<int>(i);
  const int k0 = static_cast<int>(k);
  const auto u = [&](int a, int b) { return fluid.u()[static_cast<std::size_t>(b * n + a)]; };
  const double a = i - i0;
  const double b = k - k0;
  return (1 - b) * ((1 - a) * u(i0, k0) + a * u(i0 + 1, k0)) +
         b * ((1 - a) * u(i0, k0 + 1) + a * u(i0 + 1, k0 + 1));
}

TEST(Cavity, HasTheVelocitiesOfGhiaGhiaAndShin) {
  FluidOptions o{.rho_f = 1.0, .mu_f = 0.01, .gravity = {}};
  o.convection = Convection::central;
  o.crank_nicolson = 0.0;
  o.boundaries.inlet = Wall{.velocity = {1, 0, 0}};
  o.boundaries.outlet = Wall{};
  o.pressure_tolerance = 1e-7;
  o.momentum_tolerance = 1e-7;
  const BoxCase box{{1, 1, 1}, {n, 1, n}};
  auto fluid = make_fluid(o, box.mesh());

  EXPECT_TRUE(run_to_rest(fluid, 0.1, {}, 1e-5, 400));

  // 1 % of the lid's velocity; the table itself was made on 129 x 129 points.
  for (const auto& v : along)
    EXPECT_NEAR(velocity_at(fluid, 0.5, v.at).x, v.velocity, 0.01) << v.at;
  for (const auto& v : across) {
    EXPECT_NEAR(velocity_at(fluid, v.at, 0.5).z, v.velocity, 0.01) << v.at;
  }
}

}  // namespace
}  // namespace packbed::fluid
