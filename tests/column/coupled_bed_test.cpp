// SPDX-License-Identifier: BSD-3-Clause
// A small bed in a flow: what carries it, and what the interval of coupling and the scheme do.
#include "column/coupled_bed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "column/protocol/bed_look.hpp"
#include "column/protocol/flow_stage.hpp"
#include "core/error.hpp"
#include "dem/step_choice.hpp"
#include "tests/support/settling.hpp"

namespace packbed::column {
namespace {

using namespace test;  // NOLINT

constexpr mesh::Slice slice{.inner_diameter = 2e-3, .depth = 0.7e-3, .height = 5e-3};
constexpr double area = 2e-3 * 0.7e-3;
constexpr double cm_h = 0.01 / 3600.0;

/// 300 grains, settled, as the state of a bed at rest.
const dem::DemState& settled() {
  static const dem::DemState state = [] {
    auto s = cloud_of(300, 0.1, Ranks::alone(), firm);
    Settle settle(s.options, s.start);
    while (settle.advance(s.dem)) {}
    return s.dem.state();
  }();
  return state;
}

dem::Dem bed_at_rest(double inertia_scale) {
  const auto s = cloud_of(300, 0.1, Ranks::alone(), firm);
  dem::Dem dem(s.dem.options(), settled(), dem::Dem::Lists::as_saved);
  dem.set_background_damping(0.0);
  dem.set_inertia_scale(inertia_scale);
  choose_step({.longest_step = 1.0, .fixed_step = {}}, dem);
  return dem;
}

CoupledBed liquid(coupling::Scheme scheme = coupling::Scheme::frozen_flux,
                  const fluid::Boundaries& boundaries = {}) {
  const mesh::ColumnMesh mesh(slice, mesh::cell_counts(slice, {}));
  CoupledOptions o;
  o.fluid.boundaries = boundaries;
  o.coupling.scheme = scheme;
  o.coupling.widths = {.reach = 0.75e-3, .reach_z = 0.75e-3};
  return {mesh, slice, o, Ranks::alone()};
}

void run(CoupledBed& bed, dem::Dem& dem, double time, double interval) {
  const auto count = static_cast<std::int64_t>(std::ceil(interval / dem.options().step));
  dem.set_step(interval / static_cast<double>(count));
  const auto intervals = std::llround(time / interval);
  for (std::int64_t k = 0; k < intervals; ++k) bed.advance(dem, count);
}

double mean_force(const dem::Snapshot& s, const dem::Dem& dem, bool floor) {
  double sum = 0.0;
  for (std::size_t w = 0; w < s.wall_force.size(); ++w) {
    if ((dem.walls()[w].name == "floor") == floor) sum -= s.wall_force[w].z;
  }
  return sum;
}

// K3: what presses on the bed is carried by floor, walls, and the liquid's own friction on the walls.
TEST(CoupledBed, IsCarriedByFloorAndWalls) {
  auto dem = bed_at_rest(100.0);
  auto bed = liquid();
  bed.start(dem);
  bed.set_flow(fluid::FlowProgram::steady(1000 * cm_h));
  run(bed, dem, 0.4, 2e-3);
  const auto f = bed.figures();
  EXPECT_NEAR(f.superficial_velocity, 1000 * cm_h, 1e-12);
  EXPECT_LT(f.continuity_error, 1e-6);
  const auto s = dem.snapshot();
  double weight = 0.0;
  for (const auto& b : s.beads) weight += b.weight;
  const double carried = mean_force(s, dem, true) + mean_force(s, dem, false) + f.wall_shear;
  EXPECT_NEAR(carried / (weight + f.pressure_force), 1.0, 1e-3);
  EXPECT_GT(f.pressure_force, 2.0 * weight);
}

TEST(CoupledBed, TellsThePressureDropOfItsFritsBesides) {
  const auto figures = [](double inlet_resistance, double outlet_resistance) {
    auto s = cloud_of(50, 0.1, Ranks::alone(), firm);
    fluid::Boundaries b;
    b.inlet = fluid::Inlet{.superficial = {}, .frit_resistance = inlet_resistance};
    b.outlet = fluid::Outlet{.pressure = 0.0, .frit_resistance = outlet_resistance};
    auto bed = liquid(coupling::Scheme::frozen_flux, b);
    bed.start(s.dem);
    bed.set_flow(fluid::FlowProgram::steady(500 * cm_h));
    run(bed, s.dem, 4e-3, 1e-3);
    return bed.figures();
  };
  const auto without = figures(0.0, 0.0);
  const auto with = figures(1e9, 2e9);
  const double mu = CoupledOptions{}.fluid.mu_f;
  EXPECT_EQ(without.frit_pressure_drop, 0.0);
  EXPECT_NEAR(with.frit_pressure_drop, mu * 3e9 * 500 * cm_h, 1e-5 * mu * 3e9 * 500 * cm_h);
}

// The pressure drop is that of Koch and Hill at the porosities that the liquid sees, layer by layer, for beads
// of several sizes: <d><d^3> / <d^2>^2 times that of their Sauter mean (D7).
TEST(CoupledBed, HasThePressureDropOfItsLayers) {
  auto dem = bed_at_rest(100.0);
  auto bed = liquid();
  bed.start(dem);
  bed.set_flow(fluid::FlowProgram::steady(100 * cm_h));
  run(bed, dem, 0.2, 2e-3);
  std::array<double, 3> sums{};
  for (const auto& p : dem.particles().properties) {
    for (std::size_t k = 0; k < 3; ++k) sums[k] += std::pow(p.diameter, k + 1);
  }
  const double spread = sums[0] * sums[2] / (sums[1] * sums[1]);
  const double d32 = sums[2] / sums[1];
  const auto& mesh = bed.fluid().domain().mesh;
  const auto cells = static_cast<std::size_t>(mesh.cells_per_layer());
  // Between the middles of two layers inside the bed, away from its ends, which the kernel smears.
  constexpr std::size_t low = 3;
  constexpr std::size_t high = 6;
  const auto mean = [&](std::size_t layer, auto value) {
    double sum = 0.0;
    for (std::size_t c = layer * cells; c < (layer + 1) * cells; ++c) sum += value(c);
    return sum / static_cast<double>(cells);
  };
  double expected = 0.0;
  for (std::size_t layer = low; layer <= high; ++layer) {
    const double permeability =
        mean(layer, [&](std::size_t c) {  // over viscosity; cells side by side
          const double phi = 1.0 - bed.fluid().eps()[c];
          return d32 * d32 / (18e-3 * spread * phi * coupling::KochHill::f0(phi));
        });
    const double share = layer == low || layer == high ? 0.5 : 1.0;
    expected += share * 100 * cm_h * (mesh.level(1) - mesh.level(0)) / permeability;
  }
  const auto p = [&](std::size_t c) { return bed.fluid().dynamic_pressure()[c]; };
  EXPECT_GT(look_at_bed(dem, area).height,
            mesh.level(static_cast<std::int32_t>(high) + 1) + 0.75e-3);
  // Some 100 beads: their <d> / <d^3> is that of all within 3 %.
  EXPECT_NEAR((mean(high, p) - mean(low, p)) / expected, 1.0, 0.04);
}

struct WallFlow {
  LiquidFigures figures;
  double speed = 0.0;  ///< mean velocity in the cells at a wall, inside the bed [m/s]
};
WallFlow flow_along(const fluid::Wall& wall) {
  fluid::Boundaries boundaries;
  boundaries.x_low = boundaries.x_high = wall;
  auto dem = bed_at_rest(100.0);
  auto bed = liquid(coupling::Scheme::frozen_flux, boundaries);
  bed.start(dem);
  bed.set_flow(fluid::FlowProgram::steady(100 * cm_h));
  run(bed, dem, 0.2, 2e-3);
  WallFlow flow{.figures = bed.figures()};
  const auto cells = static_cast<std::size_t>(bed.fluid().domain().mesh.cells_per_layer());
  for (std::size_t layer = 3; layer <= 6; ++layer) {
    EXPECT_LT(bed.fluid().domain().part.center[layer * cells].x, -0.8e-3);
    flow.speed -= 0.25 * bed.fluid().u()[layer * cells].z;
  }
  return flow;
}

// Thesis table B.3. Beads resist so much more than walls do that the liquid moves on nearly as it did; where there is a
// bed, here of a void fraction of 0.50 at the wall, the wall takes nearly twice the shear.
TEST(CoupledBed, BearsMoreShearAtWallsOfVoidFractionOne) {
  const auto same = flow_along({});
  const auto one = flow_along({.velocity = {}, .void_fraction = 1.0});

  EXPECT_NEAR(one.speed / same.speed, 0.997, 0.001);
  EXPECT_NEAR(one.figures.pressure_drop / same.figures.pressure_drop, 1.004, 0.002);
  // Free liquid above the bed, whose walls are of 1 anyway, has its share.
  EXPECT_NEAR(one.figures.wall_shear / same.figures.wall_shear, 1.79, 0.1);
}

struct Noise {
  double mean = 0.0;
  double deviation = 0.0;  ///< of the pressure drop, over it
  double height = 0.0;
};

/// From 0.12 to 0.18 s at 500 cm/h. Drift is no noise: second differences.
Noise noise_of(coupling::Scheme scheme, double interval, double inertia_scale) {
  auto dem = bed_at_rest(inertia_scale);
  auto bed = liquid(scheme);
  bed.start(dem);
  bed.set_flow(fluid::FlowProgram::steady(500 * cm_h));
  run(bed, dem, 0.12, interval);
  std::vector<double> drops;
  for (int k = 0; k < std::lround(0.06 / interval); ++k) {
    run(bed, dem, interval, interval);
    drops.push_back(bed.figures().pressure_drop);
  }
  Noise n{.mean = drops.back(), .height = look_at_bed(dem, area).height};
  for (std::size_t k = 2; k < drops.size(); ++k) {
    n.deviation =
        std::max(n.deviation, std::abs(drops[k] - 2.0 * drops[k - 1] + drops[k - 2]) / n.mean);
  }
  return n;
}

// Design section 4: with the flux frozen neither noise nor result depend on the interval; with the velocity
// of the liquid frozen and inertia unscaled the bed is torn apart.
TEST(CoupledBed, IsQuietWithTheFluxFrozenAndNotWithTheVelocity) {
  const auto fine = noise_of(coupling::Scheme::frozen_flux, 0.5e-3, 1.0);
  const auto coarse = noise_of(coupling::Scheme::frozen_flux, 4e-3, 1.0);
  EXPECT_NEAR(coarse.mean / fine.mean, 1.0, 5e-3);  // a bed of 300 grains that starts with a jump
  EXPECT_NEAR(coarse.height, fine.height, 1e-3 * fine.height);  // likewise
  EXPECT_LT(fine.deviation, 1e-3);
  EXPECT_LT(coarse.deviation, 1e-3);
  try {  // beads are thrown about
    EXPECT_GT(noise_of(coupling::Scheme::frozen_velocity, 4e-3, 1.0).deviation, 0.1);
  } catch (const DivergenceError&) {}
}

TEST(CoupledBed, GoesOnFromASavedStateWithTheSameBits) {
  auto dem = bed_at_rest(100.0);
  auto bed = liquid();
  bed.start(dem);
  bed.set_flow(fluid::FlowProgram::steady(500 * cm_h));
  run(bed, dem, 0.02, 2e-3);
  dem::Dem resumed(dem.options(), dem.state(), dem::Dem::Lists::as_saved);
  auto liquid_resumed = liquid();
  liquid_resumed.load(bed.save(), resumed);
  liquid_resumed.set_flow(fluid::FlowProgram::steady(500 * cm_h));
  run(bed, dem, 0.02, 2e-3);
  run(liquid_resumed, resumed, 0.02, 2e-3);
  EXPECT_EQ(bed.figures().pressure_drop, liquid_resumed.figures().pressure_drop);
  const auto a = dem.snapshot();
  const auto b = resumed.snapshot();
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    ASSERT_EQ(a.x[i], b.x[i]);
    ASSERT_EQ(a.v[i], b.v[i]);
    ASSERT_EQ(a.drag[i], b.drag[i]);
  }
}

/// Jumps from rest to a flow.
FlowOptions jumps(double to, std::int64_t steps, double hold, double coupling_interval) {
  FlowOptions o;
  o.to = to;
  o.steps = steps;
  o.hold = hold;
  o.ramps = false;
  o.interval = 1.0;
  o.area = area;
  o.coupling_interval = coupling_interval;
  o.inertia_scale = 100.0;
  o.stepping = {.longest_step = 1.0, .fixed_step = {}};
  return o;
}

TEST(FlowStage, GoesThroughItsPlateausAndTellsWhichWereNotSteady) {
  auto dem = bed_at_rest(1.0);
  auto bed = liquid();
  const auto o = jumps(600 * cm_h, 3, 0.05, 2e-3);
  FlowStage stage(o, bed);
  const double start = dem.time();
  stage.begin(dem);
  std::vector<double> drops;
  std::vector<Plateau> plateaus;
  for (auto after = After::goes_on; after != After::end;) {
    after = stage.advance(dem);
    const auto plateau = stage.finished_plateau();
    EXPECT_EQ(plateau.has_value(), after != After::goes_on);
    if (after != After::goes_on) drops.push_back(bed.figures().pressure_drop);
    if (plateau) plateaus.push_back(*plateau);
  }
  ASSERT_EQ(drops.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(plateaus[k].end - plateaus[k].start, 0.05, 1e-9);
    EXPECT_EQ(plateaus[k].start, k > 0 ? plateaus[k - 1].end : start);
    EXPECT_GT(plateaus[k].noise.value(), 0.0);
    EXPECT_LT(plateaus[k].noise.value(), 0.05);  // a small bed that still settles after a jump
  }
  EXPECT_NEAR(drops[1] / drops[0], 2.0, 0.2);
  EXPECT_GT(drops[1], drops[0]);
  EXPECT_GT(drops[2], drops[1]);
  EXPECT_NEAR(dem.time() - start, 0.15, 1e-9);
  EXPECT_EQ(dem.options().inertia_scale, 100.0);
  EXPECT_NE(stage.result(dem).find("600 cm/h"), std::string::npos) << stage.result(dem);
}

// Exchanges that are asked for every 0.1 s come so often that the liquid passes at most a cell in between, also in the
// first interval after a jump of the flow.
TEST(FlowStage, KeepsTheCourantNumberAtItsLimit) {
  auto dem = bed_at_rest(1.0);
  auto bed = liquid();
  const auto o = jumps(1000 * cm_h, 2, 0.3, 0.1);
  FlowStage stage(o, bed);
  stage.begin(dem);
  double largest = 0.0;
  int intervals = 0;
  for (auto after = After::goes_on; after != After::end; ++intervals) {
    after = stage.advance(dem);
    largest = std::max(largest, bed.figures().courant);
  }
  EXPECT_GT(intervals, 6);
  EXPECT_LT(largest, 1.02 * largest_courant);
  EXPECT_GT(largest, 0.6 * largest_courant);
}

// A bed that closes would be stepped on for ever, ever more slowly: grains grow until one cell is full.
TEST(CoupledBed, StopsAtAFullCell) {
  auto dem = bed_at_rest(100.0);
  double solid = 0.0;
  try {
    for (int k = 0; k < 100; ++k) {
      auto bed = liquid();
      bed.start(dem);
      solid = bed.figures().largest_solid_fraction;
      dem.set_in_liquid(false);
      dem.scale_diameters(1.002);
    }
    FAIL() << "no error";
  } catch (const DivergenceError& error) {
    EXPECT_NE(std::string(error.what()).find("beads fill the cell"), std::string::npos)
        << error.what();
  }
  EXPECT_LT(solid, 1.0 - coupling::least_void_fraction);
  EXPECT_GT(solid, 0.97);  // a step of growth makes 0.6 % more
}

// Inertia and interval follow the bed: as the rule has it for the state in which a plateau begins, up and down.
TEST(FlowStage, ChoosesInertiaAndIntervalForEachPlateau) {
  auto dem = bed_at_rest(1.0);
  auto bed = liquid();
  auto o = jumps(3000 * cm_h, 4, 0.1, 0.0);
  o.coupling_interval.reset();
  o.inertia_scale.reset();
  o.grains = {.viscosity = 1e-3,
              .density = 1100.0,
              .bead_diameter = 90e-6,
              .diameter = 260e-6,
              .stiffness = 100.0};
  const auto rule = [&] {
    return dem::dragged_inertia_scale(
               dragged_bed(bed_state(o, dem).value(), o.grains, true, o.hold.value()))
        .scale;
  };
  const auto rule_of_interval = [&] {
    const auto dragged = dragged_bed(bed_state(o, dem).value(), o.grains, true, o.hold.value());
    return std::min({longest_interval, interval_of_plateau * o.hold.value(),
                     interval_of_consolidation * dem::consolidation_time(dragged)});
  };
  const auto scales_of = [&](const FlowOptions& options) {
    FlowStage stage(options, bed);
    std::vector<double> scales;
    double expected = rule();
    double interval = rule_of_interval();
    stage.begin(dem);
    for (auto after = After::goes_on; after != After::end;) {
      if (after != After::goes_on || scales.empty()) {
        scales.push_back(dem.options().inertia_scale);
        EXPECT_EQ(scales.back(), expected);
        EXPECT_EQ(stage.save().at("interval"), interval);
      }
      after = stage.advance(dem);
      expected = rule();
      interval = rule_of_interval();
    }
    return scales;
  };
  const auto up = scales_of(o);
  ASSERT_EQ(up.size(), 4U);
  EXPECT_GT(up.back(), 1.02 * up.front());
  o.from.reset();
  o.to = 0.0;
  const auto down = scales_of(o);
  ASSERT_EQ(down.size(), 4U);
  EXPECT_LT(down.back(), 0.99 * down.front());
}

// Grains of 200 to 320 um. Steps are longer where small grains are scaled more, a tenth here, and the bed ends as the
// other one does: pressure drop 0.1 %, height 0.005 % apart.
TEST(FlowStage, ScalesInertiaBySizeAndTakesLongerSteps) {
  const auto end_of = [](bool by_size) {
    auto dem = bed_at_rest(1.0);
    auto bed = liquid();
    auto o = jumps(1000 * cm_h, 2, 0.1, 2e-3);
    o.ramps = true;
    o.inertia_by_size = by_size;
    o.grains.inertia_diameter = 267e-6;  // of sizes that are all as frequent
    o.longest_step_per_diameter = 1.0;   // as far as the bed stays at rest
    o.smallest_diameter = 200e-6;
    FlowStage stage(o, bed);
    stage.begin(dem);
    const auto before = dem.steps();
    while (stage.advance(dem) != After::end) {}
    return std::array{bed.figures().pressure_drop, look_at_bed(dem, area).height,
                      static_cast<double>(dem.steps() - before)};
  };
  const auto alike = end_of(false);
  const auto by_size = end_of(true);
  EXPECT_NEAR(by_size[0] / alike[0], 1.0, 2e-3);
  EXPECT_NEAR(by_size[1] / alike[1], 1.0, 1e-4);
  EXPECT_LT(by_size[2], 0.95 * alike[2]);
}

// No contact of two grains lasts less than ten of the longest steps.
TEST(BedRules, LongestStepResolvesContactsOfAllSizes) {
  const auto law = hooke(0.5, false);
  std::vector<dem::BeadProperties> beads;
  for (std::int64_t id = 0; id < 40; ++id) beads.push_back(grain(id, firm));
  const auto choice = dem::choose_step(law, beads, {}, 1.0);
  DriveOptions o;
  o.stepping.longest_step = choice.contact_time / dem::fewest_steps_per_contact;
  o.longest_step_per_diameter = choice.contact_time_per_diameter / dem::fewest_steps_per_contact;
  o.smallest_diameter = choice.smallest_diameter;
  for (const double s : {1.0, 3.0, 1e4}) {
    const dem::InertiaScale inertia{.scale = s, .diameter = 267e-6};
    double shortest = 1.0;
    for (const auto& i : beads) {
      for (const auto& j : beads) {
        const double m_i = inertia.of(i.diameter) * i.mass;
        const double m_j = inertia.of(j.diameter) * j.mass;
        const dem::Pair pair{.i = firm,
                             .j = firm,
                             .r_eff = dem::effective(0.5 * i.diameter, 0.5 * j.diameter),
                             .m_eff = dem::effective(i.mass, j.mass),
                             .m_scaled = dem::effective(m_i, m_j)};
        const double k_n = law.coefficients(pair).a;
        shortest = std::min(shortest, std::numbers::pi * std::sqrt(pair.m_scaled / k_n));
      }
    }
    const double longest = longest_step(o, inertia);
    EXPECT_LE(longest, 0.1 * shortest * (1.0 + 1e-9)) << s;
    EXPECT_GT(longest, 0.098 * shortest) << s;
  }
  const dem::InertiaScale alike{.scale = 9.0};
  EXPECT_NEAR(longest_step(o, alike) / o.stepping.longest_step, 3.0, 1e-12);
}

// A stage that is saved within a plateau tells the same of it as one that was not interrupted.
TEST(FlowStage, GoesOnWithinAPlateauWithTheSameNoise) {
  auto dem = bed_at_rest(1.0);
  auto bed = liquid();
  FlowOptions o;
  o.to = 300 * cm_h;
  o.hold = 0.04;
  o.hold_limit = 0.04;
  o.interval = 1.0;
  o.area = area;
  o.coupling_interval = 2e-3;
  o.inertia_scale = 100.0;
  o.stepping = {.longest_step = 1.0, .fixed_step = {}};
  FlowStage stage(o, bed);
  stage.begin(dem);
  for (int k = 0; k < 17; ++k) ASSERT_EQ(stage.advance(dem), After::goes_on);

  dem::Dem resumed(dem.options(), dem.state(), dem::Dem::Lists::as_saved);
  auto liquid_resumed = liquid();
  liquid_resumed.load(bed.save(), resumed);
  FlowStage other(o, liquid_resumed);
  other.load(nlohmann::ordered_json::parse(stage.save().dump()));

  while (stage.advance(dem) != After::end) {}
  while (other.advance(resumed) != After::end) {}
  const auto one = stage.finished_plateau();
  const auto two = other.finished_plateau();
  ASSERT_TRUE(one && two);
  EXPECT_GT(one->noise.value(), 0.0);  // six samples, from 0.03 s on
  EXPECT_EQ(one->noise, two->noise);
  EXPECT_EQ(one->start, two->start);
  EXPECT_EQ(one->end, two->end);
  EXPECT_EQ(one->is_steady, two->is_steady);
}

}  // namespace
}  // namespace packbed::column
