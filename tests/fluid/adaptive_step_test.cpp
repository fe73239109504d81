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

struct Taken {
  double start, dt, courant;  ///< [s], [s], -
};
std::vector<Taken> steps_of(const FlowProgram& program, const StepControl& control, double end) {
  auto [fluid, bed] = flow(program);
  std::vector<Taken> steps;
  double dt = 1e-3;
  while (fluid.time() < end) {
    const double start = fluid.time();
    steps.push_back({start, dt, fluid.step(dt, bed).courant});
    dt = next_step(control, dt, steps.back().courant);
  }
  return steps;
}

// From rest up a ramp, then three times as fast at once.
TEST(NextStep, KeepsAFlowAtItsLimit) {
  const StepControl control{.courant = 0.5, .largest = 20e-3, .growth = 1.2};
  constexpr double jump = 0.2;
  const auto steps = steps_of(
      FlowProgram::through({{0.0, 0.0}, {0.1, 10e-3}, {jump, 10e-3}, {jump, 30e-3}}), control, 0.4);
  for (std::size_t k = 1; k < steps.size(); ++k) {
    const auto& [start, dt, courant] = steps[k];
    EXPECT_LE(dt, std::min(control.largest, 1.2 * steps[k - 1].dt) * (1 + 1e-12));
    const bool jumps = start < jump && start + dt >= jump;
    EXPECT_LT(courant, jumps ? 3.1 * control.courant : 1.25 * control.courant) << start;
    if (start > 0.15 && !jumps && steps[k - 1].courant < 0.6) {
      EXPECT_NEAR(courant, control.courant, 0.02 * control.courant) << start;
    }
  }
  EXPECT_GT(steps.back().start, 0.35);
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
