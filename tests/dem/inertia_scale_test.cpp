// SPDX-License-Identifier: BSD-3-Clause
#include "dem/inertia_scale.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/beads.hpp"
#include "tests/support/message_of.hpp"

namespace packbed::dem {
namespace {

using namespace test;  // NOLINT
using testing::HasSubstr;

// C13: an affine packing of beads S with z = 6, phi = 0.64 has the bulk modulus 1.7446e5 Pa.
TEST(InertiaScale, EstimatedModulusIsThatOfAnAffinePacking) {
  EXPECT_NEAR(estimated_modulus(6.0, 0.64, 37.209127, diameter_s) / (9.0 / 5.0 * 1.7446e5), 1.0,
              1e-4);
}

TEST(InertiaScale, BySizeIsTheScaleItselfAtItsDiameterAndMoreForSmallerBeads) {
  const InertiaScale alike{.scale = 100.0};
  const InertiaScale by_size{.scale = 100.0, .diameter = 2.0};
  EXPECT_EQ(alike.of(1.0), 100.0);
  EXPECT_EQ(by_size.of(2.0), 100.0);
  EXPECT_EQ(by_size.of(1.0), 1.0 + 99.0 * 3.0);
  EXPECT_EQ(by_size.of(4.0), 1.0 + 99.0 * 0.375);
  const InertiaScale none{.scale = 1.0, .diameter = 2.0};
  const InertiaScale lighter{.scale = 0.5, .diameter = 2.0};
  for (const double d : {0.01, 1.0, 3.0}) {
    EXPECT_EQ(none.of(d), 1.0);
    EXPECT_EQ(lighter.of(d), 0.5);
  }
}

// Drag rate 1.6e5 1/s, M = 3e5 Pa, rho 1140: the figures of the trial beds of coarse grains.
DraggedBed trial_bed(double height) {
  return {.drag_rate = 1.6e5,
          .height = height,
          .modulus = 3e5,
          .bulk_density = 0.6 * density_s,
          .loose_drag_time = 1e-5,
          .flow_step = 0.4};
}

TEST(InertiaScale, DampingRatiosAreThoseOfTheTrialBeds) {
  const struct {
    double scale, ratio;
  } rows[] = {{1, 20}, {10, 6.5}, {100, 2.0}, {1000, 0.65}, {1e4, 0.20}, {1e5, 0.065}};
  for (const auto& [scale, ratio] : rows) {  // given to two digits
    EXPECT_NEAR(damping_ratio_of_bed(trial_bed(8.4e-3), scale) / ratio, 1.0, 0.03) << scale;
  }
}

TEST(InertiaScale, OfABedInLiquidKeepsItOverdamped) {
  const auto small = dragged_inertia_scale(trial_bed(8e-3));
  EXPECT_GT(small.scale, 300.0);  // "up to 500 for 8 mm, 5000 for 31 mm"
  EXPECT_LT(small.scale, 500.0);
  EXPECT_NEAR(damping_ratio_of_bed(trial_bed(8e-3), small.scale), 1.0, 1e-12);
  EXPECT_THAT(small.reason, HasSubstr("damping ratio"));
  EXPECT_NEAR(dragged_inertia_scale(trial_bed(31e-3)).scale / 5000.0, 1.0, 0.2);
}

TEST(InertiaScale, OfABedInLiquidLetsLooseBeadsFollowTheFlow) {
  auto bed = trial_bed(31e-3);
  bed.loose_drag_time = 4.78e-4;  // a single bead S in water
  const auto choice = dragged_inertia_scale(bed);
  EXPECT_NEAR(choice.scale, 0.4 / 4.78e-4, 1e-9);
  EXPECT_THAT(choice.reason, HasSubstr("loose beads"));
  bed.flow_step = 1e-5;
  EXPECT_EQ(dragged_inertia_scale(bed).scale, 1.0);
  EXPECT_THAT(dragged_inertia_scale(bed).reason, HasSubstr("not scaled"));
}

// 180 eta phi / (eps^3 d^2 rho) at phi 0.586, d 91.7 um, water: 1.6e5 1/s of the trial beds (two digits).
TEST(InertiaScale, DragRateIsThatOfKozenyAndCarman) {
  EXPECT_NEAR(kozeny_carman_drag_rate(0.586, 1e-3, 91.7e-6, density_s) / 1.6e5, 1.0, 0.05);
}

TEST(InertiaScale, OfADrivenBedKeepsBothRatios) {
  const DrivenBed slow{.speed = 5e-4, .modulus = 3e5, .bulk_density = 684.0, .strain = 0.1};
  const double wave = std::sqrt(3e5 / 684.0);
  const auto by_energy = driven_inertia_scale(slow);
  EXPECT_NEAR(by_energy.scale, 3e-4 * std::pow(0.1 * wave / 5e-4, 2), 1e-9 * by_energy.scale);
  EXPECT_THAT(by_energy.reason, HasSubstr("kinetic"));
  auto far = slow;
  far.strain = 0.7;
  EXPECT_NEAR(driven_inertia_scale(far).scale, std::pow(0.01 * wave / 5e-4, 2), 1.0);
  EXPECT_THAT(driven_inertia_scale(far).reason, HasSubstr("wave speed"));
  EXPECT_EQ(
      driven_inertia_scale({.speed = 10.0, .modulus = 3e5, .bulk_density = 684, .strain = 0.1})
          .scale,
      1.0);
  EXPECT_EQ(free_inertia_scale().scale, 1.0);
}

TEST(InertiaScale, RefusesNumbersThatAreNotPositive) {
  EXPECT_THAT(
      message_of([] {
        (void)driven_inertia_scale({.speed = 0, .modulus = 1, .bulk_density = 1, .strain = 1});
      }),
      HasSubstr("speed"));
  EXPECT_THAT(message_of([] {
                auto bed = trial_bed(0.0);
                (void)dragged_inertia_scale(bed);
              }),
              HasSubstr("height"));
}

TEST(InertiaMonitor, NamesStageFiguresLimitsAndAScaleThatWouldHaveBeenFine) {
  Snapshot s{};
  s.elastic_energy = 1.0;
  s.kinetic_energy = 5e-5;
  s.mean_contact_force = 1.0;
  s.mean_unbalanced_force = 5e-4;
  EXPECT_FALSE(inertia_warning("ramp", 1e6, s, BedMedium::dry));
  s.kinetic_energy = 4.5e-3;
  const auto warning = inertia_warning("compress", 1e6, s, BedMedium::dry);
  ASSERT_TRUE(warning);
  for (const auto* part : {"compress", "inertia scale 1e+06 was too large", "0.0045", "1e-04",
                           "0.0005", "1e-03", "2e+04"}) {
    EXPECT_THAT(*warning, HasSubstr(part));
  }
  EXPECT_FALSE(inertia_warning("ramp", 1e6, s, BedMedium::liquid));
  EXPECT_THAT(*inertia_warning("compress", 1.0, s, BedMedium::dry), HasSubstr("more slowly"));
  s.mean_unbalanced_force = 4e-3;
  const auto swings = inertia_warning("ramp", 1e6, s, BedMedium::liquid);
  ASSERT_TRUE(swings);
  EXPECT_THAT(*swings, AllOf(HasSubstr("0.004"), HasSubstr("2e+05"), Not(HasSubstr("kinetic"))));
  EXPECT_FALSE(inertia_warning("empty", 1.0, Snapshot{}, BedMedium::dry));
}

/// A disordered bed: beads of 60 to 100 % of S near the places of a simple cubic lattice, pressed
/// together sideways by a periodic box, under a lid that comes down.
constexpr int across = 3;
constexpr int layers = 6;

struct Pressed {
  double force = 0.0;  ///< mean on the lid over the last tenth of its way [N]
  double held = 0.0;   ///< the same after it has stopped [N]
  Snapshot end;
};

Pressed press(double scale, double speed, double strain, double friction, double mean = 0.0) {
  const double pitch = 0.86 * diameter_s;
  const double height = layers * pitch;
  std::vector<BeadStart> beads;
  for (int k = 0; k < across * across * layers; ++k) {
    const auto u = [&](int n) {
      return uniform(21, Stream::bead_position, static_cast<std::uint64_t>(4 * k + n)) - 0.5;
    };
    const Vec3 x{(k % across + 0.5 + 0.1 * u(0)) * pitch,
                 (k / across % across + 0.5 + 0.1 * u(1)) * pitch,
                 (k / across / across + 0.5 + 0.1 * u(2)) * pitch};
    beads.push_back(bead(k, x, {}, (0.95 + 0.1 * u(3)) * diameter_s));
  }
  Wall lid{.name = "lid",
           .surface = Plane{.point = {0, 0, height}, .normal = {0, 0, -1}},
           .material = plate,
           .velocity = {},
           .friction = friction};
  auto o = options(hooke(0.5, false), 2e-7 * std::sqrt(scale), friction, ElasticPlastic{friction});
  o.domain = {.low = {},
              .size = {across * pitch, across * pitch, 2 * height},
              .periodic = {true, true, false}};
  o.inertia_scale = scale;
  o.background_damping = 5e4 / std::sqrt(scale);
  Dem dem(o, beads, {floor_at(0, friction), lid});
  dem.run(4000);  // comes to rest
  dem.set_inertia({.scale = scale, .diameter = mean});
  dem.set_background_damping(0.0);
  dem.walls()[1].velocity = {0, 0, -speed};
  const auto steps = static_cast<std::int64_t>(strain * height / speed / o.step);
  dem.run(steps - steps / 10);
  Pressed result;
  constexpr int looks = 10;
  for (int look = 0; look < looks; ++look) {
    dem.run(steps / 100);
    result.force += dem.snapshot().wall_force[1].z / looks;
  }
  result.end = dem.snapshot();
  dem.walls()[1].velocity = {};
  dem.set_background_damping(5e4 / std::sqrt(scale));
  dem.run(4000);
  result.held = dem.snapshot().wall_force[1].z;
  return result;
}

constexpr double press_strain = 0.03;
constexpr double press_speed = 2e-3;  // [m/s]

InertiaChoice rule() {
  return driven_inertia_scale({.speed = press_speed,
                               .modulus = 3e5,
                               .bulk_density = 0.7 * density_s,
                               .strain = press_strain});
}

// The scale of the rule gives the plunger force of s = 1. With friction the start of the plunger, a
// wave of v / c = 5e-4, lets some contacts slip that hold with s = 1: 1 % of the force.
TEST(InertiaScale, OfTheRuleKeepsTheForceOfThePlunger) {
  const double scale = rule().scale;
  EXPECT_GT(scale, 10.0);
  const struct { double friction, tolerance; } rows[] = {{0.0, 2e-3}, {0.1, 2e-2}};
  for (const auto& [friction, tolerance] : rows) {
    const auto plain = press(1.0, press_speed, press_strain, friction);
    const auto scaled = press(scale, press_speed, press_strain, friction);
    EXPECT_NEAR(scaled.force / plain.force, 1.0, tolerance) << friction;
    EXPECT_NEAR(scaled.held / plain.held, 1.0, tolerance) << friction;
    EXPECT_FALSE(inertia_warning("press", scale, scaled.end, BedMedium::dry)) << friction;
    const auto by_size = press(scale, press_speed, press_strain, friction, diameter_s);
    EXPECT_NE(by_size.force, scaled.force) << friction;
    EXPECT_NEAR(by_size.force / plain.force, 1.0, tolerance) << friction;
    EXPECT_NEAR(by_size.held / plain.held, 1.0, tolerance) << friction;
  }
}

TEST(InertiaMonitor, FindsAScaleThatIsMuchTooLarge) {
  const double scale = 1e4 * rule().scale;
  const auto warning = inertia_warning(
      "press", scale, press(scale, press_speed, press_strain, 0.1).end, BedMedium::dry);
  ASSERT_TRUE(warning);
  EXPECT_THAT(*warning, HasSubstr("was too large"));
  EXPECT_THAT(*warning, HasSubstr("would have been fine"));
}

}  // namespace
}  // namespace packbed::dem
