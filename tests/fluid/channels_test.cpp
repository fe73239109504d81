// SPDX-License-Identifier: BSD-3-Clause
// F2, F8: developed flow between plates, in a pipe, and in a bed between plates.
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/support/fluid.hpp"

namespace packbed::fluid {
namespace {

using namespace test;  // NOLINT

constexpr double rho = 1000.0;
constexpr double mu = 1e-3;
constexpr double mean = 1e-3;  // m/s

FluidOptions options() {
  FluidOptions o{.rho_f = rho, .mu_f = mu, .gravity = {}};
  o.crank_nicolson = 0.0;
  o.pressure_tolerance = 1e-10;
  o.momentum_tolerance = 1e-10;
  return o;
}

/// Between plates at x = 0 and x = width, periodic in z, driven by a force.
Fluid plates(int n, double width, const Bed& bed) {
  const BoxCase box{{width, width, width}, {n, 1, 2}, {Boundary::wall, Boundary::wall, Boundary::periodic}};
  auto fluid = make_fluid(options(), box.mesh());
  auto all = bed;
  all.force.assign(fluid.domain().own(), bed.force.front());
  if (!bed.exchange.empty()) {
    all.eps.assign(fluid.domain().own(), bed.eps.front());
    all.exchange.assign(fluid.domain().own(), bed.exchange.front());
  }
  fluid.start(all, std::vector<Vec3>(fluid.domain().own()), 0.0);
  EXPECT_TRUE(run_to_rest(fluid, 1e3, all, 1e-10, 200));
  return fluid;
}

TEST(Poiseuille, BetweenPlates) {
  const double width = 1e-3;
  const auto exact = [&](const Vec3& x) {
    return Vec3{0, 0, -6.0 * mean * x.x * (width - x.x) / (width * width)};
  };
  std::vector<double> h, e;
  for (const int n : {8, 16, 32, 64}) {
    const auto fluid = plates(n, width, {.force = {{0, 0, -12.0 * mu * mean / (width * width)}}});
    h.push_back(1.0 / n);
    e.push_back(velocity_error(fluid, exact) / mean);
    std::printf("%d %g\n", n, e.back());
  }
  std::printf("order %g\n", fitted_order(h, e));
}

TEST(Brinkman, LayerAtAWall) {
  const double eps = 0.95;
  const double d = 1e-3;
  const double layer = 0.777 * d;
  const double exchange = eps * mu / (layer * layer);
  const double width = 8e-3;
  const double far = 1e-3;
  const auto exact = [&](const Vec3& x) {
    return Vec3{0, 0, -far * (1.0 - std::cosh((x.x - 0.5 * width) / layer) / std::cosh(0.5 * width / layer))};
  };
  std::vector<double> h, e;
  for (const int n : {16, 32, 64, 128}) {
    const auto fluid = plates(n, width, {.eps = {eps}, .exchange = {exchange}, .force = {{0, 0, -exchange * far}}});
    h.push_back(1.0 / n);
    e.push_back(velocity_error(fluid, exact) / far);
    std::printf("%d %g\n", n, e.back());
  }
  std::printf("order %g\n", fitted_order(h, e));
}

TEST(Poiseuille, InADuct) {
  for (const double dt : {1e-2, 1e-1, 1.0}) for (int corr : {1, 2, 3}) {
    const double w = 1e-3;
    const BoxCase box{{w, w, 2 * w}, {12, 12, 16}};
    auto o = options();
    o.boundaries.y_low = o.boundaries.y_high = Wall{}; o.correctors = corr; if (getenv("NOC")) o.convection = Convection::none;
    o.boundaries.inlet = Inlet{FlowProgram::steady(mean)};
    auto fluid = make_fluid(o, box.mesh());
    bool good = run_to_rest(fluid, dt, {}, 1e-7, 200);
    double lowest = 0;
    for (const auto& u : fluid.u()) lowest = std::min(lowest, u.z);
    std::printf("dt %g good %d t %g max %g\n", dt, good, fluid.time(), -lowest / mean);
  }
}

TEST(Poiseuille, InAPipe) {
  const double radius = 0.5e-3;
  std::vector<double> h, e;
  for (const int core : {4, 6, 8, 12, 16, 24}) {
    const mesh::ColumnMesh mesh(mesh::Cylinder{.inner_diameter = 2 * radius, .height = 6 * radius},
                                {.core = core, .ring = core / 2, .layers = 12});
    auto o = options();
    o.boundaries.inlet = Inlet{FlowProgram::steady(mean)};
    auto fluid = make_fluid(o, mesh);
    EXPECT_TRUE(run_to_rest(fluid, 1e-2, {}, 1e-5, 100));
    // Developed: the lower half.
    double sum = 0, volume = 0;
    for (std::size_t c = 0; c < fluid.domain().own(); ++c) {
      const auto& x = fluid.domain().part.center[c];
      if (x.z > 2 * radius) continue;
      const double exact = -2 * mean * (1 - (x.x * x.x + x.y * x.y) / (radius * radius));
      const double v = fluid.domain().part.volume[c];
      sum += v * norm(fluid.u()[c] - Vec3{0, 0, exact}) * norm(fluid.u()[c] - Vec3{0, 0, exact});
      volume += v;
    }
    h.push_back(1.0 / core);
    e.push_back(std::sqrt(sum / volume) / mean);
    double lowest = 0;
    for (const auto& u : fluid.u()) lowest = std::min(lowest, u.z);
    std::printf("%d %g max %g\n", core, e.back(), -lowest / mean);
  }
  std::printf("order %g\n", fitted_order(h, e));
}

}  // namespace
}  // namespace packbed::fluid
