// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/settle.hpp"

#include <cmath>
#include <memory>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "column/protocol/settle_stage.hpp"
#include "core/error.hpp"
#include "dem/state.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/settling.hpp"

namespace packbed::column {
namespace {

using namespace test;  // NOLINT
using testing::HasSubstr;

SettleState settle(Settling& s) {
  Settle step(s.options, s.start);
  while (step.advance(s.dem)) {}
  return step.state();
}

TEST(Settle, BringsACloudToRestInTheLiquid) {
  auto s = cloud_of(300);
  s.options.friction = 0.3;
  s.options.damping_after = 7.0;
  const auto end = settle(s);
  EXPECT_EQ(end.phase, SettlePhase::done);
  const auto now = s.dem.snapshot();
  EXPECT_LT(now.mean_unbalanced_force / now.mean_contact_force, 1e-6);
  double top = 0.0;
  for (const auto& x : now.x) top = std::max(top, x.z);
  EXPECT_NEAR(end.bed_height, top, 320e-6);
  EXPECT_GT(end.porosity, 0.36);
  EXPECT_LT(end.porosity, 0.50);
  // What settling alone had is put back.
  EXPECT_EQ(s.dem.options().model.friction, 0.1);
  EXPECT_EQ(s.dem.options().background_damping, 7.0);
  const auto& bead = s.dem.particles().properties[0];
  const double volume = std::numbers::pi / 6.0 * std::pow(bead.diameter, 3);
  EXPECT_NEAR(bead.weight, (density_s - 998.0) * volume * 9.81, 1e-12 * bead.mass * 9.81);
  // The floor carries what the walls do not.
  EXPECT_LT(now.wall_force[0].z, 0.0);
}

TEST(Settle, ChangesTheNumberOfBeadsForTheHeight) {
  for (const double height : {2.0e-3, 3.2e-3}) {
    auto s = cloud_of(240);
    s.options.bed_height = height;
    const auto end = settle(s);
    EXPECT_NEAR(end.bed_height, height, 260e-6) << height;
    EXPECT_GT(end.count_changes, 0) << height;
    const bool more = height > 3e-3;
    EXPECT_EQ(s.dem.bead_count() > 240, more) << height;
    EXPECT_EQ(end.next_id > 240, more) << height;
    for (const auto& bead : s.dem.particles().properties) {
      EXPECT_EQ(bead.diameter, grain(bead.id).diameter);
    }
  }
}

TEST(Settle, GoesOnFromASavedStateWithTheSameBits) {
  auto whole = cloud_of(150);
  whole.options.bed_height = 2.0e-3;
  settle(whole);

  auto parts = cloud_of(150);
  parts.options.bed_height = 2.0e-3;
  auto state = parts.start;
  for (bool more = true; more;) {
    Settle step(parts.options, state);
    for (int slice = 0; slice < 7 && more; ++slice) more = step.advance(parts.dem);
    state = step.state();
    const auto options = parts.dem.options();
    parts.dem = dem::Dem(options, parts.dem.state(), dem::Dem::Lists::as_saved);
  }
  EXPECT_GT(state.count_changes, 0);
  const auto a = whole.dem.snapshot();
  const auto b = parts.dem.snapshot();
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(a.elastic_energy, b.elastic_energy);
}

TEST(Settle, ReachesAPorosityBelowThatOfItsFriction) {
  auto loose = cloud_of(300);
  loose.options.liquid_density = 0.0;
  const auto before = settle(loose);
  auto s = cloud_of(300);
  s.options.liquid_density = 0.0;
  s.options.porosity = before.porosity - 0.012;
  const auto end = settle(s);
  EXPECT_NEAR(end.porosity, before.porosity - 0.012, 1e-3);
  EXPECT_LE(end.falls, 2);
  EXPECT_GT(end.coordination, before.coordination);
  EXPECT_EQ(s.dem.options().model.friction, 0.1);
  EXPECT_EQ(std::get<dem::ElasticPlastic>(s.dem.options().model.rolling).mu_r, 0.35);
}

// What a checkpoint holds of the stage, where the bed is made denser, too.
TEST(SettleStage, GoesOnFromWhatItSavedWithTheSameBits) {
  auto loose = cloud_of(150);
  const double porosity = settle(loose).porosity - 0.012;
  const auto centers = [&](int slices_at_a_time) {
    auto s = cloud_of(150);
    s.options.porosity = porosity;
    auto stage = std::make_unique<SettleStage>(s.options, 1.0);
    stage->begin(s.dem);
    int slices = 0;
    while (stage->advance(s.dem) != After::end) {
      if (++slices % slices_at_a_time != 0) continue;
      const auto saved = nlohmann::ordered_json::parse(stage->save().dump());
      stage = std::make_unique<SettleStage>(s.options, 1.0);
      stage->load(saved);
    }
    return s.dem.snapshot().x;
  };
  const auto whole = centers(1'000'000);
  const auto parts = centers(1);
  ASSERT_EQ(parts.size(), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_EQ(parts[i].x, whole[i].x) << i;
    EXPECT_EQ(parts[i].y, whole[i].y) << i;
    EXPECT_EQ(parts[i].z, whole[i].z) << i;
  }
}

TEST(Settle, SaysWhichPorositiesCannotBe) {
  auto dense = cloud_of(200);
  dense.options.porosity = 0.30;
  EXPECT_THAT(message_of([&] { settle(dense); }), HasSubstr("0.3 is too dense"));
  auto airy = cloud_of(200);
  airy.options.porosity = 0.60;
  EXPECT_THAT(message_of([&] { settle(airy); }), HasSubstr("0.6 is too loose"));
}

TEST(Settle, PutsTheLidOnOrSaysThatTheBedIsTooHigh) {
  auto s = cloud_of(100);
  s.options.lid = 4e-3;
  settle(s);
  EXPECT_EQ(std::get<dem::Plane>(s.dem.walls()[3].surface).point.z, 4e-3);
  auto high = cloud_of(100);
  high.options.lid = 0.8e-3;
  EXPECT_THAT(message_of([&] { settle(high); }), HasSubstr("above the lid"));
}

TEST(Settle, KeepsToTheStableStep) {
  auto s = cloud_of(150);
  Settle step(s.options, s.start);
  while (step.advance(s.dem)) EXPECT_LE(s.dem.options().step, s.dem.stable().step);
  auto forced = cloud_of(150);
  forced.options.stepping.fixed_step = 1e-3;
  EXPECT_THAT(message_of([&] { settle(forced); }), HasSubstr("above the stable one"));
}

TEST(Settle, NeedsBeads) {
  auto s = cloud_of(0);
  EXPECT_THAT(message_of([&] { settle(s); }), HasSubstr("no beads"));
}

// A grain that rolls between others does not keep the bed waiting for ever: all count as rolling here.
TEST(Settle, WaitsForRollingGrainsTenFallingTimes) {
  auto s = cloud_of(60);
  s.options.speed_limit = 0.0;
  Settle settle(s.options, s.start);
  double since = -1.0;  // when all but the rolling came to rest for the last time
  while (settle.advance(s.dem)) since = settle.state().resting_since;

  ASSERT_GT(since, 0.0);
  const double waited = s.dem.time() - since;
  const double ten_falling_times = 10.0 * std::sqrt(0.26e-3 / 9.81);  // of a grain of mean size
  EXPECT_NEAR(waited, ten_falling_times, 0.1 * ten_falling_times);

  auto quick = cloud_of(60);
  quick.options.speed_limit = 1.0;
  Settle at_once(quick.options, quick.start);
  while (at_once.advance(quick.dem)) EXPECT_LT(at_once.state().resting_since, 0.0);
}

}  // namespace
}  // namespace packbed::column
