// SPDX-License-Identifier: BSD-3-Clause
// Steps that follow the Courant number.
#include <gtest/gtest.h>

#include "fluid/figures.hpp"
#include "tests/support/fluid.hpp"

namespace packbed::fluid {
namespace {

using namespace test;  // NOLINT

TEST(NextStep, FollowsTheCourantNumber) {
  const StepControl control{.courant = 0.5, .largest = 1e-3, .growth = 1.2};
  EXPECT_DOUBLE_EQ(next_step(control, 1e-4, 2.0), 0.25e-4);
  EXPECT_DOUBLE_EQ(next_step(control, 1e-4, 0.01), 1.2e-4);
  EXPECT_DOUBLE_EQ(next_step(control, 9.9e-4, 0.0), 1e-3);
}

/// A column with a denser half, and what flows through it.
struct Flow {
  Fluid fluid;
  Bed bed;
};
Flow flow(const FlowProgram& program) {
  FluidOptions o;
  o.boundaries.inlet = Inlet{program};
  Flow flow{make_fluid(o, BoxCase{{2e-3, 1e-3, 10e-3}, {4, 1, 20}}.mesh()), {}};
  flow.bed.eps = field(flow.fluid, [](const Vec3& x) { return x.z > 5e-3 ? 1.0 : 0.4; });
  flow.bed.exchange = field(flow.fluid, [](const Vec3& x) { return x.z > 5e-3 ? 0.0 : 1e7; });
  flow.fluid.start(flow.bed, std::vector<Vec3>(flow.fluid.domain().own()), 0.0);
  return flow;
}

// From rest up a ramp, then three times as fast at once.
TEST(NextStep, KeepsAFlowAtItsLimit) {
  const StepControl control{.courant = 0.5, .largest = 20e-3, .growth = 1.2};
  constexpr double jump = 0.2;
  auto [fluid, bed] =
      flow(FlowProgram::through({{0.0, 0.0}, {0.1, 10e-3}, {jump, 10e-3}, {jump, 30e-3}}));
  double dt = 1e-3;
  double before = 0.0;  // Courant number of the last step
  int steps_of_jump = 0;
  while (fluid.time() < 0.4) {
    const double start = fluid.time();
    const double courant = fluid.step(dt, bed).courant;

    const bool jumps = start < jump && fluid.time() >= jump;
    if (jumps) ++steps_of_jump;
    EXPECT_LT(courant, jumps ? 3.1 * control.courant : 1.25 * control.courant) << start;
    if (start > 0.15 && !jumps && before < 0.6) {
      EXPECT_NEAR(courant, control.courant, 0.02 * control.courant) << start;
    }
    const double next = next_step(control, dt, courant);
    EXPECT_LE(next, std::min(control.largest, 1.2 * dt) * (1 + 1e-12));
    dt = next;
    before = courant;
  }
  EXPECT_EQ(steps_of_jump, 1);
}

TEST(CourantRate, IsThatOfAStepOrOfAFlowThroughTheDensestCell) {
  auto [fluid, bed] = flow(FlowProgram::steady(10e-3));
  double courant = 0.0;
  for (int k = 0; k < 5; ++k) courant = fluid.step(1e-3, bed).courant;

  EXPECT_NEAR(courant_rate(fluid, 0.0), courant / 1e-3, 1e-9 * courant / 1e-3);
  EXPECT_NEAR(courant_rate(fluid, 0.1), 1.5 * 0.1 / (0.4 * 0.5e-3), 1e-6);
  EXPECT_EQ(courant_rate(fluid, -0.1), courant_rate(fluid, 0.1));
}

}  // namespace
}  // namespace packbed::fluid
