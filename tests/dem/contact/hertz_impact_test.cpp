// SPDX-License-Identifier: BSD-3-Clause
// C1, C3, C4, C6: whole impacts against closed forms: overlap, force, duration, restitution.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/beads.hpp"

namespace packbed::dem {
namespace {

using namespace test;  // NOLINT

/// An impact followed step by step; all beads move along one line.
struct Impact {
  double overlap = 0.0;   ///< largest [m]
  double force = 0.0;     ///< largest on the first bead [N]
  double duration = 0.0;  ///< from touch to parting, between steps by straight lines [s]
  double rebound = 0.0;   ///< separation / closing speed
};

/// Gap of the pair or of bead and wall [m].
double gap(const Dem& dem) {
  const auto& p = dem.particles();
  if (!dem.wall_contacts().empty()) return p.motion[0].x.z - p.radius(0);
  return norm(p.motion[1].x - p.motion[0].x) - p.radius(0) - p.radius(1);
}

Vec3 relative_velocity(const Dem& dem) {
  const auto& m = dem.particles().motion;
  return dem.particles().size() == 1 ? m[0].v : m[1].v - m[0].v;
}

Impact follow(Dem dem, double step) {
  Impact result;
  const double closing = norm(relative_velocity(dem));
  double before = gap(dem);
  double touch = -1.0;
  while (true) {
    dem.run(1);
    const double now = gap(dem);
    const double crossing = dem.time() - step * now / (now - before);
    if (before > 0.0 && now <= 0.0) touch = crossing;
    if (before <= 0.0 && now > 0.0 && touch >= 0.0) {
      result.duration = crossing - touch;
      dem.run(2);
      result.rebound = norm(relative_velocity(dem)) / closing;
      return result;
    }
    if (now <= 0.0) {
      result.overlap = std::max(result.overlap, -now);
      result.force = std::max(result.force, norm(dem.snapshot().force[0]));
    }
    before = now;
  }
}

// C1: contact times 7.380963e-6 s (e = 0.5) and 7.211667e-6 s (0.9), with tension.
TEST(Impact, OfHookesLawTakesItsTime) {
  const struct { double e, time; } rows[] = {{0.5, 7.380963e-6}, {0.9, 7.211667e-6}};
  for (const auto& [e, time] : rows) {
    const double step = time / 20000;
    auto beads = head_on(0.1);
    beads[0].x.x += 1e-10;
    EXPECT_NEAR(follow(Dem(options(hooke(e), step), beads, {}), step).duration / time, 1.0, 1e-4)
        << e;
  }
}

// C3: Chung and Ooi's cases 1 and 2, 200 steps a contact.
TEST(Impact, OfEqualSpheresIsThatOfElasticTheory) {
  const struct {
    Material m;
    double density, overlap, force, time;
  } rows[] = {{{48e9, 0.20}, 2800, 274.1127e-6, 10696.9, 40.3395e-6},
              {{20e9, 0.25}, 2500, 368.3040e-6, 7108.24, 54.2010e-6}};
  for (const auto& c : rows) {
    const std::vector<BeadStart> beads = {
        bead(0, {0.02001, 0, 0}, {-10, 0, 0}, 0.02, c.density, c.m),
        bead(1, {0, 0, 0}, {10, 0, 0}, 0.02, c.density, c.m)};
    const auto i = follow(Dem(options(HertzMindlin{.restitution = 1.0}, c.time / 200), beads, {}),
                          c.time / 200);
    EXPECT_NEAR(i.overlap / c.overlap, 1.0, 1e-4);
    EXPECT_NEAR(i.force / c.force, 1.0, 1e-4);
    EXPECT_NEAR(i.duration / c.time, 1.0, 1e-4);
  }
}

constexpr Material rigid{.youngs_modulus = 1e30, .poisson_ratio = 0.3};

Dem drop(const ContactLaw& law,
         double step,
         double radius,
         double speed,
         double density,
         const Material& m) {
  return {options(law, step),
          {bead(0, {0, 0, radius * 1.0001}, {0, 0, -speed}, 2 * radius, density, m)},
          {floor_at(0, 0, rigid)}};
}

TEST(Impact, OfASphereOnARigidPlateIsThatOfElasticTheory) {
  const struct {
    Material m;
    double density, radius, speed, overlap, force, time;
  } rows[] = {{{70e9, 0.30}, 2699, 0.1, 0.2, 49.7172e-6, 11369.9, 731.657e-6},  // C3
              {{40e9, 0.35}, 1800, 0.1, 0.2, 52.1233e-6, 7232.68, 767.066e-6},
              {{380e9, 0.23}, 4000, 2.5e-3, 3.9, 8.0888e-6, 615.352, 6.1045e-6},  // C4
              {{100e9, 0.25}, 7000, 2.5e-3, 3.9, 17.1887e-6, 506.760, 12.9721e-6}};
  for (const auto& c : rows) {
    const double step = c.time / 200;
    const auto i = follow(
        drop(HertzMindlin{.restitution = 1.0}, step, c.radius, c.speed, c.density, c.m), step);
    EXPECT_NEAR(i.overlap / c.overlap, 1.0, 1e-4);
    EXPECT_NEAR(i.force / c.force, 1.0, 1e-4);
    EXPECT_NEAR(i.duration / c.time, 1.0, 1e-4);
  }
}

// C4: restitution of aluminum oxide on the plate; without tension the map of case C2.
TEST(Impact, HasTheRestitutionGivenOrItsClippedMap) {
  const Material oxide{.youngs_modulus = 380e9, .poisson_ratio = 0.23};
  const double step = 6.1045e-6 / 4000;
  const auto rebound = [&](double e, bool tension) {
    return follow(drop(HertzMindlin{.restitution = e, .tension = tension}, step, 2.5e-3, 3.9, 4000,
                       oxide),
                  step)
        .rebound;
  };
  for (const double e : {0.2, 0.4, 0.6, 0.8, 1.0}) EXPECT_NEAR(rebound(e, true), e, 1e-3) << e;
  const struct {
    double given, comes_out;
  } map[] = {{0.9, 0.902026}, {0.8, 0.808099}, {0.7, 0.718201},
             {0.6, 0.632291}, {0.5, 0.550283}, {0.3, 0.397140}};
  for (const auto& [given, comes_out] : map)
    EXPECT_NEAR(rebound(given, false), comes_out, 1e-3) << given;
}

// C6: at fine steps the restitution is exact at any speed and mass.
TEST(Impact, RestitutionDependsNeitherOnSpeedNorOnMass) {
  for (const double speed : {1e-4, 1e-2, 1.0}) {
    for (const double density : {1140.0, 11400.0}) {
      const double contact = 5e-6 * std::pow(speed / 0.1, -0.2) * std::pow(density / 1140.0, 0.4);
      const double step = contact / 20000;
      auto dem = drop(HertzMindlin{.restitution = 0.5, .tension = true}, step, 0.5 * diameter_s,
                      speed, density, material_s);
      // Straight to the contact: it is 1e-4 radii away.
      EXPECT_NEAR(follow(std::move(dem), step).rebound, 0.5, 1e-4) << speed << " m/s, " << density;
    }
  }
}

// C7 on the plate: half the Stokes number of the pair.
TEST(ViscousHooke, OnAPlateHasHalfTheStokesNumber) {
  const ViscousHooke law{.characteristic_velocity = speed_s,
                         .restitution_max = 0.9,
                         .critical_stokes = 0.3,
                         .viscosity = 1e-3,
                         .tension = true};
  const double m = mass_of(diameter_s, density_s);
  const Pair on_plate{
      .i = material_s, .j = plate, .r_eff = 0.5 * diameter_s, .m_eff = m, .m_scaled = m};
  const struct { double v, e; } rows[] = {{0.1, 0.685295}, {0.01, 0.058965}};
  for (const auto& [v, e] : rows) {
    const double gamma = law(1e-7, -v, law.coefficients(on_plate)).gamma_t;
    EXPECT_NEAR(gamma / hooke(e).coefficients(on_plate).b, 1.0, 1e-5)
        << v;  // e is given to 6 digits
  }
}

}  // namespace
}  // namespace packbed::dem
