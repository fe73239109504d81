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

FluidOptions options(double u0, double tolerance) {
  FluidOptions o;
  o.pressure_tolerance = tolerance;
  o.momentum_tolerance = tolerance;
  o.boundaries.inlet = Inlet{FlowProgram::steady(u0)};
  o.boundaries.wall = o.boundaries.x_low = o.boundaries.x_high = SlipWall{};
  return o;
}

mesh::ColumnMesh cylinder() {
  return {mesh::Cylinder{.inner_diameter = 2e-3, .height = 5e-3},
          {.core = 4, .ring = 2, .layers = 6}};
}

double largest_difference(const Fluid& fluid, const Vec3& u) {
  double worst = 0.0;
  for (const auto& v : fluid.u()) worst = std::max(worst, norm(v - u));
  return worst;
}

/// Through the top that goes down faster and slower, so that liquid of `eps` always flows at `down`.
FlowProgram through_the_top(double down, double eps) {
  std::vector<FlowProgram::Point> program;
  for (int k = 1; k <= 10; ++k) {
    const double relative = eps * (down + (falling(k) - falling(k - 1)) / dt);
    if (k == 1) program.push_back({0.5 * dt, relative});
    program.push_back({k * dt, relative});
  }
  program.insert(program.begin(), {0.0, eps * down});
  return FlowProgram::through(program);
}

// What the scheme does, without what a linear solver leaves: fluxes of the uniform flow through faces that move close
// all cells to 1e-14 of what passes them, so no solve takes an iteration, and the flow stays as it was to rounding of the
// speed of the mesh, 0.15 m/s.
TEST(MovingMesh, KeepsUniformFlowWithoutASolve) {
  constexpr double down = 2e-3;
  constexpr double eps = 0.4;
  const auto box = BoxCase{{2e-3, 1e-3, 5e-3}, {4, 2, 7}}.mesh();
  for (const auto& mesh : {box, cylinder()}) {
    for (const double cn : {0.0, 0.3, 1.0}) {
      auto o = options(0, 1e-8);
      o.crank_nicolson = cn;
      o.boundaries.inlet = Inlet{through_the_top(down, eps)};
      auto fluid = make_fluid(o, mesh);
      Bed bed;
      bed.eps.assign(fluid.domain().own(), eps);
      const Vec3 u{0, 0, -down};
      fluid.start(bed, std::vector<Vec3>(fluid.domain().own(), u), 0.0);

      for (int k = 1; k <= 10; ++k) {
        const auto report = fluid.step(dt, bed, falling(k));
        for (const auto& solve : report.pressure) EXPECT_EQ(solve.iterations, 0);
        EXPECT_LT(report.continuity_error, 1e-14);
      }

      EXPECT_LT(largest_difference(fluid, u), 1e-16);
    }
  }
}

TEST(MovingMesh, KeepsUniformFlowAcrossItsMotion) {
  // Along x at 1 mm/s too, where periodic sides pass it. What comes in has no velocity along x: here all flows out of the
  // top. The first step begins with a flux at the top that the mesh does not have yet, so there is something to solve.
  using enum Boundary;
  constexpr double down = 2e-3;
  std::vector<FlowProgram::Point> program;
  for (int k = 1; k <= 10; ++k) {
    program.push_back({k * dt, down + (falling(k) - falling(k - 1)) / dt});
    ASSERT_LT(program.back().velocity, 0.0);
  }
  for (const double cn : {0.0, 0.3, 1.0}) {
    auto o = options(0, 1e-14);
    o.crank_nicolson = cn;
    o.boundaries.inlet = Inlet{FlowProgram::through(program)};
    o.boundaries.outlet = Inlet{FlowProgram::steady(-down)};
    const BoxCase box{{2e-3, 1e-3, 5e-3}, {4, 2, 7}, {periodic, periodic, wall}};
    auto fluid = make_fluid(o, box.mesh());
    const Vec3 u{1e-3, 0, -down};
    fluid.start({}, std::vector<Vec3>(fluid.domain().own(), u), 0.0);

    for (int k = 1; k <= 10; ++k) fluid.step(dt, {}, falling(k));

    // The solver's 1e-14 of what passes the cells, 0.15 m/s.
    EXPECT_LT(largest_difference(fluid, u), 1e-15);
  }
}

TEST(MovingMesh, KeepsUniformFlowThatAPlungerDrives) {
  // At rest at first: liquid that flows in beside liquid at rest would leave shear behind.
  auto o = options(0, 1e-14);
  o.boundaries.inlet = Inlet{FlowProgram::through({{0.0, 0.0}, {0.1 * dt, 1e-3}})};
  auto fluid = make_fluid(o, cylinder());

  for (int k = 1; k <= 10; ++k) {
    fluid.step(dt, {}, top_at(k));
    // The top displaces what it sweeps, besides what passes it: 0.23 m/s at most.
    const double down = 1e-3 - (top_at(k) - top_at(k - 1)) / dt;
    EXPECT_LT(largest_difference(fluid, {0, 0, -down}), 4e-15);
  }
}

TEST(MovingMesh, ClosesWithBedAndSource) {
  // A bed that is compressed with the mesh: eps V changes, liquid comes out of the beads.
  auto o = options(1e-3, 1e-12);
  o.boundaries.wall = Wall{};
  auto fluid = make_fluid(o, cylinder());
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
