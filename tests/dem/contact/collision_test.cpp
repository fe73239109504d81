// SPDX-License-Identifier: BSD-3-Clause
// Head-on collisions against exact answers. C-numbers: docs/verification.md.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/beads.hpp"

namespace packbed::dem {
namespace {

using namespace test;  // NOLINT: builders of this file's subject

constexpr double k_n_pair = 37.209127;   // N/m, thesis eq. 4.21 (corrected) for two beads S
constexpr double k_n_plate = 98.011745;  // N/m, bead S on the plate of table B.2

double collide(const ContactLaw& law,
               double steps_per_contact,
               double contact_time,
               double closing_speed = 0.1) {
  Dem dem(options(law, contact_time / steps_per_contact), head_on(closing_speed), {});
  return restitution_of(dem);
}

Pair pair_s(bool on_plate) {
  const double m = mass_of(diameter_s, density_s);
  const double m_eff = on_plate ? m : 0.5 * m;
  return {.i = material_s,
          .j = on_plate ? plate : material_s,
          .r_eff = on_plate ? 0.5 * diameter_s : 0.25 * diameter_s,
          .m_eff = m_eff,
          .m_scaled = m_eff};
}

TEST(Hooke, HasTheStiffnessOfTheThesisBeads) {
  EXPECT_NEAR(hooke(0.5).coefficients(pair_s(false)).a, k_n_pair, 1e-6);
  EXPECT_NEAR(hooke(0.5).coefficients(pair_s(true)).a, k_n_plate, 1e-6);
  EXPECT_NEAR(hooke(0.5).coefficients(pair_s(false)).b, 3.678538e-5, 1e-11);
  EXPECT_NEAR(hooke(0.9).coefficients(pair_s(false)).b, 5.722754e-6, 1e-12);
}

/// Mean error of the rebound over twenty places of the first contact within a step.
double mean_error(double e, double steps_per_contact, double contact_time) {
  const double dt = contact_time / steps_per_contact;
  double sum = 0.0;
  constexpr int places = 20;
  for (int k = 0; k < places; ++k) {
    auto beads = head_on(0.1);
    beads[0].x.x += 0.1 * dt * (k + 0.5) / places;
    Dem dem(options(hooke(e), dt), beads, {});
    sum += restitution_of(dem) - e;
  }
  return sum / places;
}

// C1: contact times 7.380963e-6 s (e = 0.5), 7.211667e-6 s (0.9). With damping the step is of order
// 1: the design expects 3e-3 at 50 steps a contact and 2e-4 at 1000 for e = 0.5. Where in a step the
// contact begins moves a single rebound by three times that.
TEST(Hooke, ReboundsWithItsRestitution) {
  EXPECT_NEAR(mean_error(0.5, 50, 7.380963e-6), 0.0, 3e-3);
  EXPECT_NEAR(mean_error(0.5, 1000, 7.380963e-6), 0.0, 2e-4);
  EXPECT_NEAR(mean_error(0.9, 1000, 7.211667e-6), 0.0, 2e-5);
}

TEST(Hooke, ErrorOfADampedReboundIsOfFirstOrder) {
  const double coarse = mean_error(0.5, 200, 7.380963e-6);
  const double fine = mean_error(0.5, 800, 7.380963e-6);
  EXPECT_NEAR(std::log2(coarse / fine) / 2.0, 1.0, 0.1);
}

// I3: overlap v / w sin(w t) of an undamped contact a quarter of the way through it.
TEST(Hooke, UndampedContactIsOfSecondOrder) {
  const double w = std::sqrt(k_n_pair / pair_s(false).m_eff);
  const double t = 0.3 / w;
  const auto error = [&](int steps) {
    Dem dem(options(hooke(1.0), t / steps), head_on(0.1), {});
    dem.run(steps);
    return std::abs(dem.snapshot().mean_overlap - 0.1 / w * std::sin(w * t));
  };
  for (int steps = 10; steps < 160; steps *= 2) {
    EXPECT_NEAR(std::log2(error(steps) / error(2 * steps)), 2.0, 0.1) << steps;
  }
}

// C2: without tension the restitution is not the number given; the map is that of the clipped
// linear oscillator.
TEST(Hooke, WithoutTensionFollowsTheClippedMap) {
  const struct {
    double given, comes_out;
  } map[] = {{0.9, 0.902026}, {0.8, 0.808099}, {0.7, 0.718201},
             {0.6, 0.632291}, {0.5, 0.550283}, {0.3, 0.397140}};
  for (const auto& [given, comes_out] : map) {
    EXPECT_NEAR(collide(hooke(given, false), 20000, 7.4e-6), comes_out, 1e-4) << given;
  }
}

// C6: restitution independent of speed over four decades.
TEST(Hertz, RestitutionDoesNotDependOnSpeed) {
  for (const double e : {0.2, 0.5, 0.8}) {
    for (const double v : {1e-4, 1e-2, 1.0}) {
      const double contact_time = 6.7527e-6 * std::pow(v / 0.1, -0.2);
      const HertzMindlin law{.restitution = e, .tension = true};
      // first order in the step: 5e-4 at 1000 steps a contact
      EXPECT_NEAR(collide(law, 1000, contact_time, v), e, 1e-3) << e << " at " << v << " m/s";
    }
  }
}

// C5: at the characteristic speed both laws store the same energy: overlap 2.29426e-7 m.
TEST(Hooke, MeetsHertzAtItsCharacteristicSpeed) {
  for (const ContactLaw& law :
       {ContactLaw(hooke(1.0)), ContactLaw(HertzMindlin{.restitution = 1.0})}) {
    Dem dem(options(law, 5e-9), head_on(0.1), {});
    double largest = 0.0;
    for (int n = 0; n < 1600; ++n) {
      dem.run(1);
      largest = std::max(largest, dem.snapshot().mean_overlap);
    }
    EXPECT_NEAR(largest / 2.29426e-7, 1.0, 1e-5);
  }
}

// C8: the restitution that the damping of the instant gives, 0.7350 at 0.1 m/s and 0.3354 at 0.03.
TEST(ViscousHooke, ReboundsAsTheInstantaneousSpeedSays) {
  const ViscousHooke law{.characteristic_velocity = speed_s,
                         .restitution_max = 0.9,
                         .critical_stokes = 0.3,
                         .viscosity = 1e-3,
                         .tension = true};
  EXPECT_NEAR(collide(law, 4000, 7.2e-6, 0.1), 0.7350, 5e-4);
  EXPECT_NEAR(collide(law, 4000, 7.2e-6, 0.03), 0.3354, 5e-4);
}

// C7: at the impact speed the damping is that of e = e_max exp(-St_c / St): 0.785344 at 0.1 m/s.
TEST(ViscousHooke, DampingIsThatOfTheRestitutionAtThatSpeed) {
  const ViscousHooke law{.characteristic_velocity = speed_s,
                         .restitution_max = 0.9,
                         .critical_stokes = 0.3,
                         .viscosity = 1e-3,
                         .tension = true};
  const auto k = law.coefficients(pair_s(false));
  const struct { double v, e; } rows[] = {{0.1, 0.785344}, {0.01, 0.230365}};
  for (const auto& [v, e] : rows) {
    const double gamma = law(1e-7, -v, k).gamma_t;
    EXPECT_NEAR(gamma / hooke(e).coefficients(pair_s(false)).b, 1.0, 1e-5);
  }
  const double critical = 2.0 * std::sqrt(pair_s(false).m_eff * k.a);
  EXPECT_NEAR(law(1e-7, 0.0, k).gamma_t / critical, 1.0, 1e-12);
}

// A fixed bead is as heavy as a wall.
TEST(Collision, WithAFixedBeadHasItsRestitutionToo) {
  auto beads = head_on(0.1);
  beads[1].properties.fixed = true;
  beads[1].v = {};
  Dem dem(options(hooke(0.5), 2e-9), beads, {});
  EXPECT_NEAR(restitution_of(dem), 0.5, 1e-3);
}

}  // namespace
}  // namespace packbed::dem
