// SPDX-License-Identifier: BSD-3-Clause
// A mesh that is stretched by a moving top.
#include <gtest/gtest.h>

#include "fluid/figures.hpp"
#include "tests/support/fluid.hpp"

namespace packbed::fluid {
namespace {

using namespace test;  // NOLINT

constexpr double dt = 1e-3;
double falling(int k) { return 5e-3 - 0.1e-3 * k - 0.05e-3 * std::sin(0.7 * k); }
double top_at(int k) { return 5e-3 - 0.1e-3 * k - 0.2e-3 * std::sin(0.7 * k); }

FluidOptions options(double u0) {
  FluidOptions o;
  o.pressure_tolerance = 1e-13;
  o.momentum_tolerance = 1e-13;
  o.boundaries.inlet = Inlet{FlowProgram::steady(u0)};
  o.boundaries.wall = o.boundaries.x_low = o.boundaries.x_high = SlipWall{};
  return o;
}

TEST(MovingMesh, KeepsUniformFlow) {
  // The top goes down faster and slower, and lets out so much that the liquid in space always goes down at 2 mm/s
  // and along x at 1 mm/s.
  using enum Boundary;
  const double down = 2e-3;
  std::vector<FlowProgram::Point> program;
  for (int k = 1; k <= 10; ++k) {
    program.push_back({k * dt, down + (falling(k) - falling(k - 1)) / dt});
    ASSERT_LT(program.back().velocity, 0.0);  // what comes in has no velocity along x
  }
  for (const double cn : {0.0, 0.3, 1.0}) {
    auto o = options(0);
    o.crank_nicolson = cn;
    o.boundaries.inlet = Inlet{FlowProgram::through(program)};
    o.boundaries.outlet = Inlet{FlowProgram::steady(-down)};
    const BoxCase box{{2e-3, 1e-3, 5e-3}, {4, 2, 7}, {periodic, periodic, wall}};
    auto fluid = make_fluid(o, box.mesh());
    const Vec3 u{1e-3, 0, -down};
    fluid.start({}, std::vector<Vec3>(fluid.domain().own(), u), 0.0);

    for (int k = 1; k <= 10; ++k) fluid.step(dt, {}, falling(k));

    // 1e-12: the solver's 1e-13 of what passes the cells, which is up to 0.3 m/s.
    double worst = 0.0;
    for (const auto& v : fluid.u()) worst = std::max(worst, norm(v - u));
    EXPECT_LT(worst, 1e-12);
  }
}

TEST(MovingMesh, KeepsUniformFlowInACylinder) {
  const mesh::ColumnMesh mesh(mesh::Cylinder{.inner_diameter = 2e-3, .height = 5e-3},
                              {.core = 4, .ring = 2, .layers = 6});
  // At rest at first: liquid that flows in beside liquid at rest would leave shear behind.
  auto o = options(0);
  o.boundaries.inlet = Inlet{FlowProgram::through({{0.0, 0.0}, {0.1 * dt, 1e-3}})};
  auto fluid = make_fluid(o, mesh);

  for (int k = 1; k <= 10; ++k) {
    fluid.step(dt, {}, top_at(k));
    // The top displaces what it sweeps, besides what passes it.
    const double down = 1e-3 - (top_at(k) - top_at(k - 1)) / dt;
    double worst = 0.0;
    for (const auto& v : fluid.u()) worst = std::max(worst, norm(v + Vec3{0, 0, down}));
    EXPECT_LT(worst, 1e-12);
  }
}

TEST(MovingMesh, ClosesWithBedAndSource) {
  // A bed that is compressed with the mesh: eps V changes, liquid comes out of the beads.
  const mesh::ColumnMesh mesh(mesh::Cylinder{.inner_diameter = 2e-3, .height = 5e-3},
                              {.core = 4, .ring = 2, .layers = 6});
  auto o = options(1e-3);
  o.boundaries.wall = Wall{};
  o.pressure_tolerance = 1e-12;
  auto fluid = make_fluid(o, mesh);
  const double area = 3.14159265358979 * 1e-6;
  double held_before = area * 5e-3;
  for (int k = 1; k <= 10; ++k) {
    Bed bed;
    const double eps = 0.5 - 0.01 * k;
    bed.eps = field(fluid, [&](const Vec3& x) { return eps + 50.0 * x.x; });
    bed.exchange.assign(bed.eps.size(), 1e7);
    bed.source.assign(bed.eps.size(), 0.3);

    const auto report = fluid.step(dt, bed, top_at(k));

    EXPECT_LT(report.continuity_error, 1e-11);
    // In through the top, out of the beads, displaced: out below. Upward fluxes count positive.
    const double volume = area * top_at(k);
    const double held = eps * volume;
    const double out = 1e-3 * area + 0.3 * volume - (held - held_before) / dt;
    EXPECT_NEAR(level_fluxes(fluid).front(), -out, 1e-9 * out);
    held_before = held;
  }
}

}  // namespace
}  // namespace packbed::fluid
