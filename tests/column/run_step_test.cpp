// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/run_step.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/beads.hpp"
#include "tests/support/message_of.hpp"

namespace packbed::column {
namespace {

using namespace test;  // NOLINT
using testing::HasSubstr;

TEST(PlanRun, CutsTheDurationIntoEqualWholeSteps) {
  const auto plan = plan_run(1e-5, 3e-8, 1e-6);
  EXPECT_EQ(plan.steps, 334);
  EXPECT_DOUBLE_EQ(plan.step * 334, 1e-5);
  EXPECT_EQ(plan.output_every, 33);
  EXPECT_EQ(plan_run(1e-5, 1e-8, 1e-6).steps, 1000);
  EXPECT_EQ(plan_run(0.0, 1e-8, 1e-6).steps, 0);
  EXPECT_EQ(plan_run(1e-9, 1e-8, 1e-6).steps, 1);
}

TEST(RunStep, EndsAtItsDurationAndCallsForOutput) {
  dem::Dem dem(options(hooke(0.5), 1.0), head_on(0.1), {});
  int outputs = 0;
  run_step(dem, plan_run(1e-5, 1e-8, 3e-6), false, [&] { ++outputs; });
  EXPECT_DOUBLE_EQ(dem.time(), 1e-5);
  EXPECT_EQ(outputs, 4);  // 3, 6, 9, 10 us
}

TEST(RunStep, StopsAtAStepAboveTheStableOneUnlessForced) {
  const auto press = [](bool force) {
    dem::Dem dem(options(hooke(0.5), 1.0), {bead(4, {0, 0, 0.49 * diameter_s})}, {floor_at(0)});
    run_step(dem, plan_run(4e-6, 4e-6, 4e-6), force, [] {});
  };
  const auto message = message_of([&] { press(false); });
  EXPECT_THAT(message, HasSubstr("above the stable one"));
  EXPECT_THAT(message, HasSubstr("bead 4 at (0, 0, 0.042581) mm with 1 contacts"));
  EXPECT_NO_THROW(press(true));
}

}  // namespace
}  // namespace packbed::column
