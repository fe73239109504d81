// SPDX-License-Identifier: BSD-3-Clause
// The plunger on a small bed, dry and in a liquid.
#include "column/protocol/plunger_stage.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "column/plunger.hpp"
#include "column/protocol/bed_look.hpp"
#include "core/error.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/settling.hpp"

namespace packbed::column {
namespace {

using namespace test;  // NOLINT
using ::testing::HasSubstr;

constexpr mesh::Slice slice{.inner_diameter = 2e-3, .depth = 0.7e-3, .height = 5e-3};
constexpr double area = 2e-3 * 0.7e-3;

/// Settled grains below a plunger at the upper end of the column.
dem::DemState settle_grains(Settling s) {
  Settle settle(s.options, s.start);
  while (settle.advance(s.dem)) {}
  s.dem.set_background_damping(0.0);
  place_plunger(slice.height, s.dem);
  return s.dem.state();
}

const dem::DemState& settled() {
  static const auto state = settle_grains(cloud_of(300));
  return state;
}

dem::Dem bed(const dem::DemState& state) {
  return {cloud_of(300).dem.options(), state, dem::Dem::Lists::as_saved};
}

PlungerOptions options() {
  PlungerOptions o;
  o.interval = 1.0;
  o.area = area;
  o.coupling_interval = 2e-3;
  o.inertia_scale = 100.0;
  o.stepping = {.longest_step = 1.0, .fixed_step = {}};
  o.speed = 2e-3;
  o.column_height = slice.height;
  return o;
}

CoupledBed liquid(double top = slice.height) {
  mesh::ColumnMesh mesh(slice, mesh::cell_counts(slice, {}));
  if (top != slice.height) mesh.set_top(top);
  CoupledOptions o;
  o.coupling.widths = {.reach = 0.75e-3, .reach_z = 0.75e-3};
  return {mesh, slice, o, Ranks::alone()};
}

void finish(PlungerStage& stage, dem::Dem& dem) {
  while (stage.advance(dem) != After::end) {}
}

double energy(const dem::Snapshot& s) {
  double sum = s.elastic_energy + s.kinetic_energy;
  for (std::size_t i = 0; i < s.beads.size(); ++i) sum += s.beads[i].weight * s.x[i].z;
  return sum;
}

double force_on_lid(const dem::Dem& dem) {
  double sum = 0.0;
  for (const auto& c : dem.touching_contacts()) {
    if (c.id_j == -4) sum -= c.normal.z + c.tangential.z;  // wall 3
  }
  return sum;
}

TEST(PlungerStage, GoesToAHeightAndFeelsItsContacts) {
  auto dem = bed(settled());
  auto o = options();
  const double top = look_at_bed(dem, area).top;
  o.value = 0.9 * top;
  PlungerStage stage(o, nullptr);
  stage.begin(dem);
  EXPECT_DOUBLE_EQ(*plunger_position(dem.walls()), top);  // it touches the bed at once
  finish(stage, dem);
  EXPECT_NEAR(*plunger_position(dem.walls()), o.value, 1e-12);
  EXPECT_EQ(dem.walls()[3].velocity, (Vec3{}));
  EXPECT_GT(plunger_force(dem), 0.0);
  EXPECT_NEAR(plunger_force(dem), force_on_lid(dem), 1e-12 * plunger_force(dem));
  EXPECT_THAT(stage.result(dem), HasSubstr("plunger at"));
}

/// Share of the plunger's work that friction and dashpots take, with this friction of beads and walls.
double dissipated_share(double friction) {
  auto dem = bed(settled());
  for (auto& wall : dem.walls()) wall.friction = friction;
  auto o = options();
  o.friction = friction;
  o.resin_friction = 0.1;
  o.speed = 0.5e-3;
  o.value = 0.87 * look_at_bed(dem, area).height;
  o.hold = 0.2;
  const double before = energy(dem.snapshot());
  PlungerStage stage(o, nullptr);
  stage.begin(dem);
  finish(stage, dem);
  EXPECT_EQ(dem.options().model.friction,
            friction);  // what is told of the end is of the bed as pressed
  stage.leave(dem);
  EXPECT_EQ(dem.options().model.friction, 0.1);  // of the resin again
  const double work = stage.save().at("work");
  return 1.0 - (energy(dem.snapshot()) - before) / work;
}

// Work = stored + dissipated + change of potential; most is stored without friction. Which loses more hangs on the bed:
// less friction means more grains that snap into new places.
TEST(PlungerStage, DoesTheWorkThatIsStoredAndDissipated) {
  const double smooth = dissipated_share(0.0);
  const double rough = dissipated_share(0.5);
  EXPECT_GT(smooth, 0.0);
  EXPECT_LT(smooth, 0.5);
  EXPECT_GT(rough, 0.0);
  EXPECT_LT(rough, 0.6);
}

/// Largest way of a grain from one state to another, over its diameter; the slice is periodic in y.
double largest_way(const dem::Snapshot& from, const dem::Snapshot& to) {
  double worst = 0.0;
  for (std::size_t i = 0; i < from.x.size(); ++i) {
    Vec3 way = to.x[i] - from.x[i];
    way.y -= slice.depth * std::round(way.y / slice.depth);
    worst = std::max(worst, norm(way) / from.beads[i].diameter);
  }
  return worst;
}

// A bed without friction that is pressed and let go a little, again and again, comes to a state to which it returns:
// once no grain snaps into a new place any more.
TEST(PlungerStage, BringsABedWithoutFrictionBack) {
  auto dem = bed(settle_grains(cloud_of(300, 0.0)));
  for (auto& wall : dem.walls()) wall.friction = 0.0;
  const double height = look_at_bed(dem, area).height;
  const auto go_to = [&](double share, double speed) {
    auto o = options();
    o.speed = speed;
    o.value = share * height;
    o.hold = 0.5;
    PlungerStage stage(o, nullptr);
    stage.begin(dem);
    finish(stage, dem);
    return dem.snapshot();
  };
  go_to(0.85, 2e-3);
  go_to(0.87, -1e-3);
  auto before = go_to(0.85, 1e-3);
  double way = 1.0;
  double change = 1.0;
  for (int cycle = 0; cycle < 4 && way >= 1e-4; ++cycle) {
    go_to(0.87, -1e-3);
    const auto now = go_to(0.85, 1e-3);
    way = largest_way(before, now);
    change = std::abs(now.elastic_energy / before.elastic_energy - 1.0);
    before = now;
  }
  EXPECT_LT(way, 1e-4);
  EXPECT_LT(change, 1e-6);
}

// Fewer slices than a plunger in a liquid waits.
TEST(PlungerStage, ScalesInertiaLessWhileTheBedIsLetGo) {
  auto dem = bed(settled());
  const double height = look_at_bed(dem, area).height;
  auto o = options();
  o.inertia_scale.reset();
  o.grains = {.viscosity = 0.0,
              .density = density_s,
              .bead_diameter = grain(0, soft).diameter,
              .diameter = grain(0, soft).diameter,
              .stiffness = 0.45};  // [N/m] about that of two of them
  o.speed = 5e-4;
  o.value = 0.87 * height;
  PlungerStage press(o, nullptr);
  press.begin(dem);
  finish(press, dem);
  o.value = 0.92 * height;
  o.speed = -5e-4;
  PlungerStage let_go(o, nullptr);
  let_go.begin(dem);
  const double before = dem.options().inertia_scale;
  finish(let_go, dem);
  EXPECT_GT(before, 10.0);
  EXPECT_LT(dem.options().inertia_scale, before / 4.0);
}

// Few grains, but firm: a bed of soft ones gives way to the liquid for long.
TEST(PlungerStage, ComesToAForceWithoutPassingIt) {
  const auto start = settle_grains(cloud_of(100, 0.1, Ranks::alone(), firm));
  struct Case {
    bool wet;
    double flow;  ///< through plunger and bed [m/s]
  };
  for (const auto [wet, flow] : {Case{false, 0.0}, Case{true, 0.0}, Case{true, 1e-3}}) {
    auto dem = bed(start);
    auto water = liquid();
    auto o = options();
    o.target = PlungerTarget::force;
    o.value = 2e-3;
    o.hold = 0.1;
    o.flow = flow;
    PlungerStage stage(o, wet ? &water : nullptr);
    stage.begin(dem);
    double highest = 0.0;
    double lowest_held = o.value;
    for (auto after = After::goes_on; after != After::end;) {
      after = stage.advance(dem);
      highest = std::max(highest, plunger_force(dem));
      if (stage.doing().starts_with("holding")) {
        lowest_held = std::min(lowest_held, plunger_force(dem));
      }
    }
    EXPECT_LT(highest, 1.02 * o.value) << wet << flow;
    EXPECT_GT(lowest_held, 0.98 * o.value) << wet << flow;
    EXPECT_NEAR(plunger_force(dem), o.value, 0.005 * o.value) << wet << flow;
  }
}

/// Sum of the weights of all beads [N].
double weight(const dem::Dem& dem) {
  double sum = 0.0;
  for (const auto& bead : dem.snapshot().beads) sum += bead.weight;
  return sum;
}

// A drained step: beads have their full weight, what is told of its end included; then the liquid carries them again.
TEST(PlungerStage, BeadsOfADrainedStepWeighWhatTheyDoInAir) {
  auto dem = bed(settled());
  auto o = options();
  o.drained = true;
  o.gravity = 9.81;
  o.liquid_density = 998.0;
  o.value = 0.95 * look_at_bed(dem, area).height;
  double in_air = 0.0;
  for (const auto& bead : dem.snapshot().beads) in_air += 9.81 * bead.mass;
  double in_liquid = in_air;
  for (const auto& bead : dem.snapshot().beads) {
    in_liquid -= 9.81 * o.liquid_density * std::numbers::pi / 6.0 * std::pow(bead.diameter, 3);
  }
  PlungerStage stage(o, nullptr);
  stage.begin(dem);
  EXPECT_NEAR(weight(dem), in_air, 1e-12 * in_air);
  finish(stage, dem);
  EXPECT_NEAR(weight(dem), in_air, 1e-12 * in_air);
  stage.leave(dem);
  EXPECT_NEAR(weight(dem), in_liquid, 1e-12 * in_air);
  EXPECT_LT(in_liquid, 0.5 * in_air);
}

// What the plunger displaces leaves below, and cells hold what the column holds.
TEST(PlungerStage, MovesTheUpperEndOfTheLiquidWithTheBeads) {
  auto dem = bed(settled());
  auto water = liquid();
  auto o = options();
  o.value = 0.9 * look_at_bed(dem, area).height;
  PlungerStage stage(o, &water);
  stage.begin(dem);
  double beads = 0.0;
  for (const auto& bead : dem.snapshot().beads) {
    beads += std::numbers::pi / 6.0 * std::pow(bead.diameter, 3);
  }
  double moved = 0.0;
  for (auto after = After::goes_on; after != After::end;) {
    const bool moves = stage.doing().starts_with("moving");
    after = stage.advance(dem);
    const double z = *plunger_position(dem.walls());
    const auto& domain = water.fluid().domain();
    EXPECT_EQ(domain.mesh.top(), z);
    double liquid_volume = 0.0;
    for (std::size_t c = 0; c < domain.own(); ++c) {
      liquid_volume += water.fluid().eps()[c] * domain.part.volume[c];
    }
    EXPECT_NEAR(liquid_volume + beads, area * z, 1e-12 * area * z);
    EXPECT_LT(water.figures().continuity_error, 1e-6);
    if (!moves) continue;
    EXPECT_NEAR(water.figures().superficial_velocity, o.speed, 1e-6 * o.speed);
    moved = z;
  }
  EXPECT_GT(moved, 0.0);
  EXPECT_GT(plunger_force(dem), 0.0);
  EXPECT_EQ(water.flow(), 0.0);
}

// A bed that is let go of is drawn up by the water that comes in below; the plunger leaves it in the end.
TEST(PlungerStage, WithdrawsThroughTheLiquid) {
  auto dem = bed(settled());
  auto water = liquid();
  auto o = options();
  o.value = 0.9 * look_at_bed(dem, area).height;
  PlungerStage down(o, &water);
  down.begin(dem);
  finish(down, dem);
  const double pressed = plunger_force(dem);
  o.speed = -2e-3;
  o.target = PlungerTarget::force;
  o.value = 0.0;
  o.withdraws = true;
  PlungerStage up(o, &water);
  up.begin(dem);
  bool was_released = false;
  for (auto after = After::goes_on; after != After::end;) {
    after = up.advance(dem);
    if (up.doing().starts_with("moving")) was_released = plunger_force(dem) < pressed;
  }
  EXPECT_TRUE(was_released);
  EXPECT_NEAR(*plunger_position(dem.walls()), slice.height, 1e-9);
  EXPECT_EQ(plunger_force(dem), 0.0);
}

TEST(PlungerStage, GoesOnFromASavedStateWithTheSameBits) {
  for (const int slices : {3, 60}) {  // while it approaches, and while it presses
    auto dem = bed(settled());
    auto water = liquid();
    water.set_flow(fluid::FlowProgram::steady(1e-3));
    auto o = options();
    o.flow = std::nullopt;
    o.value = 0.92 * look_at_bed(dem, area).height;
    o.hold = 0.01;
    PlungerStage stage(o, &water);
    stage.begin(dem);
    for (int k = 0; k < slices; ++k) ASSERT_NE(stage.advance(dem), After::end);

    dem::Dem resumed(dem.options(), dem.state(), dem::Dem::Lists::as_saved);
    auto water_resumed = liquid(*plunger_position(resumed.walls()));
    water_resumed.load(water.save(), resumed);
    PlungerStage other(o, &water_resumed);
    other.load(nlohmann::ordered_json::parse(stage.save().dump()));
    finish(stage, dem);
    finish(other, resumed);

    const auto a = dem.snapshot();
    const auto b = resumed.snapshot();
    for (std::size_t i = 0; i < a.x.size(); ++i) {
      ASSERT_EQ(a.x[i], b.x[i]) << slices;
      ASSERT_EQ(a.v[i], b.v[i]) << slices;
    }
    EXPECT_EQ(stage.save(), other.save());
    EXPECT_EQ(water.figures().pressure_drop, water_resumed.figures().pressure_drop);
    EXPECT_EQ(water.flow(), 1e-3);
  }
}

TEST(PlungerStage, RefusesATargetThatIsNotOnItsWay) {
  auto dem = bed(settled());
  auto o = options();
  o.value = 0.9 * look_at_bed(dem, area).height;
  PlungerStage down(o, nullptr);
  down.begin(dem);
  finish(down, dem);
  o.value *= 1.05;
  PlungerStage higher(o, nullptr);
  EXPECT_THAT(message_of([&] { higher.begin(dem); }), HasSubstr("away from its target"));
}

}  // namespace
}  // namespace packbed::column
