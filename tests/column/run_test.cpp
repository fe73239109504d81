// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/beads.hpp"
#include "tests/support/message_of.hpp"

namespace packbed::column {
namespace {

using namespace test;  // NOLINT
using testing::HasSubstr;

/// Carries a stage out from where it is; returns how many outputs were due.
int finish(Stage& stage, dem::Dem& dem) {
  int outputs = 0;
  for (auto after = After::goes_on; after != After::end;) {
    after = stage.advance(dem);
    if (after != After::goes_on) ++outputs;
  }
  return outputs;
}

TEST(PlanRun, CutsTheDurationIntoEqualWholeSteps) {
  const auto plan = plan_run(1e-5, 3e-8, 1e-6);
  EXPECT_EQ(plan.steps, 334);
  EXPECT_DOUBLE_EQ(plan.step * 334, 1e-5);
  EXPECT_EQ(plan.output_every, 33);
  EXPECT_EQ(plan_run(1e-5, 1e-8, 1e-6).steps, 1000);
  EXPECT_EQ(plan_run(0.0, 1e-8, 1e-6).steps, 0);
  EXPECT_EQ(plan_run(1e-9, 1e-8, 1e-6).steps, 1);
}

TEST(RunStage, EndsAtItsDurationAndCallsForOutput) {
  dem::Dem dem(options(hooke(0.5), 1.0), head_on(0.1), {});
  RunStage stage(plan_run(1e-5, 1e-8, 3e-6), false);
  stage.begin(dem);
  EXPECT_EQ(finish(stage, dem), 4);  // 3, 6, 9, 10 us
  EXPECT_DOUBLE_EQ(dem.time(), 1e-5);
  EXPECT_EQ(stage.share_done(dem), 1.0);
}

TEST(RunStage, GoesOnAfterASliceFromWhatItSaved) {
  const auto plan = plan_run(5e-5, 1e-8, 1.2e-5);
  dem::Dem dem(options(hooke(0.5), 1.0), head_on(0.1), {});
  RunStage stage(plan, false);
  stage.begin(dem);
  ASSERT_EQ(stage.advance(dem), After::goes_on);
  RunStage resumed(plan, false);
  resumed.load(stage.save());
  EXPECT_EQ(finish(resumed, dem), 5);  // 12, 24, 36, 48, 50 us
  EXPECT_DOUBLE_EQ(dem.time(), 5e-5);
}

TEST(RunStage, StopsAtAStepAboveTheStableOneUnlessForced) {
  const auto press = [](bool force) {
    dem::Dem dem(options(hooke(0.5), 1.0), {bead(4, {0, 0, 0.49 * diameter_s})}, {floor_at(0)});
    RunStage stage(plan_run(4e-6, 4e-6, 4e-6), force);
    stage.begin(dem);
    finish(stage, dem);
  };
  const auto message = message_of([&] { press(false); });
  EXPECT_THAT(message, HasSubstr("above the stable one"));
  EXPECT_THAT(message, HasSubstr("bead 4 at (0, 0, 0.042581) mm with 1 contacts"));
  EXPECT_NO_THROW(press(true));
}

}  // namespace
}  // namespace packbed::column
