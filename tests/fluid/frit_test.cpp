// SPDX-License-Identifier: BSD-3-Clause
// Frits: a sheet of given resistance before the inlet and behind the outlet.
#include <algorithm>

#include <gtest/gtest.h>

#include "fluid/figures.hpp"
#include "tests/support/fluid.hpp"

namespace packbed::fluid {
namespace {

using namespace test;  // NOLINT

constexpr double mu = 1e-3;

FluidOptions options(double u0, double outlet_resistance) {
  FluidOptions o{.rho_f = 1000.0, .mu_f = mu, .gravity = {}};
  o.pressure_tolerance = 1e-12;
  o.momentum_tolerance = 1e-13;
  o.convection = Convection::none;
  o.boundaries.inlet = Inlet{.superficial = FlowProgram::steady(u0)};
  o.boundaries.outlet = Outlet{.pressure = 50.0, .frit_resistance = outlet_resistance};
  o.boundaries.x_low = o.boundaries.x_high = SlipWall{};
  o.boundaries.y_low = o.boundaries.y_high = SlipWall{};
  return o;
}

/// Pressure drop and superficial velocities through the outlet of a bed with `exchange` [kg/(m3 s)] at x.
struct Flow {
  double drop, outlet_pressure;
  std::vector<double> out;
};
Flow through(const FluidOptions& o, const std::function<double(double)>& exchange) {
  auto fluid = make_fluid(o, BoxCase{{2e-3, 1e-3, 2e-3}, {8, 1, 8}}.mesh());
  Bed bed;
  bed.eps.assign(fluid.domain().own(), 0.4);
  bed.exchange = field(fluid, [&](const Vec3& x) { return exchange(x.x); });
  fluid.start(bed, std::vector<Vec3>(fluid.domain().own()), 0.0);
  for (int k = 0; k < 10; ++k) fluid.step(1.0, bed);
  Flow flow{pressure_drop(fluid), mean_pressure(fluid, mesh::Patch::outlet), {}};
  for (std::size_t b = 0; b < fluid.border().size(); ++b) {
    const auto f = fluid.domain().inner() + b;
    if (fluid.border().patch[b] == mesh::Patch::outlet) flow.out.push_back(fluid.q()[f]);
  }
  return flow;
}

TEST(Frit, AddsItsPressureDropToThatOfTheBedInBothDirections) {
  constexpr double exchange = 1e6;
  constexpr double resistance = 3e9;
  for (const double u0 : {2e-3, -2e-3}) {
    const auto flow = through(options(u0, resistance), [&](double) { return exchange; });
    const double bed = exchange * u0 / (0.4 * 0.4) * 2e-3;
    EXPECT_NEAR(flow.drop, bed, 1e-9 * std::abs(bed)) << u0;
    EXPECT_NEAR(flow.outlet_pressure, 50.0 + mu * resistance * u0, 1e-8) << u0;
  }
}

// Half of the bed lets three times as much pass: the frit at its end evens that out, the more the denser it is.
TEST(Frit, EvensOutWhatLeaves) {
  constexpr double u0 = 2e-3;
  const auto unevenness = [&](double resistance) {
    const auto flow =
        through(options(u0, resistance), [](double x) { return x < 1e-3 ? 3e6 : 1e6; });
    double sum = 0.0;
    for (const double q : flow.out) sum += q;
    EXPECT_NEAR(sum / 8.0, u0, 1e-10 * u0);
    const auto [low, high] = std::ranges::minmax(flow.out);
    return high / low;
  };
  const double none = unevenness(0.0);
  const double some = unevenness(1e10);
  const double dense = unevenness(1e13);
  EXPECT_GT(none, 2.0);
  EXPECT_LT(some, 0.8 * none);
  EXPECT_NEAR(dense, 1.0, 3e-3);
}

}  // namespace
}  // namespace packbed::fluid
