// SPDX-License-Identifier: BSD-3-Clause
// F5 to F7, F9, F10, D3, D4, D9: beds as given fields.
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/support/fluid.hpp"

namespace packbed::fluid {
namespace {

using namespace test;  // NOLINT

constexpr double rho = 1000.0;
constexpr double mu = 1e-3;

// Exchange coefficient of Kozeny and Carman, 180 mu (1 - eps)^2 / (eps d^2): dp/dz = exchange u0 / eps^2.
double kozeny(double eps, double d) { return 180.0 * mu * (1 - eps) * (1 - eps) / (eps * d * d); }

FluidOptions options(double u0) {
  FluidOptions o{.rho_f = rho, .mu_f = mu, .gravity = {}};
  o.pressure_tolerance = 1e-12;
  o.boundaries.inlet = Inlet{FlowProgram::steady(u0)};
  o.boundaries.x_low = o.boundaries.x_high = SlipWall{};
  o.boundaries.y_low = o.boundaries.y_high = SlipWall{};
  return o;
}

double pressure_drop(const Fluid& fluid) {
  double in = 0, n = 0;
  for (std::size_t b = 0; b < fluid.border().size(); ++b) {
    if (fluid.border().patch[b] != mesh::Patch::inlet) continue;
    in += fluid.border_pressure()[b];
    n += 1;
  }
  return in / n;
}

TEST(Darcy, TwoLayers) {
  const double u0 = 1e-3;
  for (const double dt : {1e-5, 1e-3, 1.0}) {
    const BoxCase box{{1e-3, 1e-3, 20e-3}, {2, 2, 20}};
    auto fluid = make_fluid(options(u0), box.mesh());
    Bed bed;
    bed.eps = field(fluid, [](const Vec3& x) { return x.z > 10e-3 ? 0.4 : 0.3; });
    bed.exchange = field(fluid, [](const Vec3& x) { return kozeny(x.z > 10e-3 ? 0.4 : 0.3, 100e-6); });
    fluid.start(bed, std::vector<Vec3>(fluid.domain().own()), 0.0);
    StepReport r;
    for (int k = 0; k < 20; ++k) r = fluid.step(dt, bed);
    double worst = 0;
    for (std::size_t c = 0; c < fluid.domain().own(); ++c) {
      worst = std::max(worst, norm(fluid.eps()[c] * fluid.u()[c] + Vec3{0, 0, u0}));
    }
    std::printf("dt %g dp %.10g (4279.1667) worst %g cont %g its %d\n", dt, pressure_drop(fluid), worst / u0, r.continuity_error, r.pressure[0].iterations);
  }
}

TEST(Darcy, StillLiquid) {
  FluidOptions o;
  o.boundaries.inlet = Inlet{};
  o.boundaries.outlet = Outlet{101325.0};
  const BoxCase box{{2e-3, 2e-3, 5e-3}, {4, 4, 10}};
  auto fluid = make_fluid(o, box.mesh());
  Bed bed;
  bed.eps = field(fluid, [](const Vec3& x) { return 0.5 + 0.4 * std::sin(3e3 * x.x) * std::cos(2e3 * x.z + 1e3 * x.y); });
  bed.exchange = field(fluid, [](const Vec3& x) { return 1e6 * x.z; });
  fluid.start(bed, std::vector<Vec3>(fluid.domain().own()), 0.0);
  for (int k = 0; k < 20; ++k) fluid.step(1e-3, bed);
  double worst = 0;
  for (const auto& u : fluid.u()) worst = std::max(worst, norm(u));
  std::printf("still %g, p %g\n", worst, fluid.pressure(0));
}

TEST(Bernoulli, Step) {
  const double u0 = 0.1;
  for (const double width : {1e-3}) {
    auto o = options(u0);
    o.convection = Convection::central;
    const BoxCase box{{width, width, 20e-3}, {1, 1, 20}};
    auto fluid = make_fluid(o, box.mesh());
    Bed bed;
    bed.eps = field(fluid, [](const Vec3& x) { return x.z > 10e-3 ? 0.8 : 0.4; });
    fluid.start(bed, std::vector<Vec3>(fluid.domain().own()), 0.0);
    for (int k = 0; k < 2000; ++k) fluid.step(1e-3, bed);
    double worst = 0;
    for (std::size_t c = 0; c < fluid.domain().own(); ++c) {
      worst = std::max(worst, norm(fluid.eps()[c] * fluid.u()[c] + Vec3{0, 0, u0}));
      std::printf("%g ", fluid.dynamic_pressure()[c]);
    }
    const double up = u0 / 0.8, down = u0 / 0.4;
    std::printf("dp %.10g exact %.10g worst %g\n", pressure_drop(fluid), 0.5 * rho * (down * down - up * up), worst / u0);
  }
}

}  // namespace
}  // namespace packbed::fluid
