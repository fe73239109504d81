// SPDX-License-Identifier: BSD-3-Clause
// I2, I3: order of the error in the step within one contact.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "tests/support/beads.hpp"

namespace packbed::dem {
namespace {

using namespace test;  // NOLINT

constexpr double radius = 0.5 * diameter_s;

/// Slope of the error over four halvings of the step, against a step 32 times finer than the finest.
void expect_order(double order, double tolerance, const std::function<double(int)>& result) {
  const double exact = result(64 * 16 * 32);
  for (int steps = 64; steps < 64 * 16; steps *= 2) {
    const double slope =
        std::log2(std::abs(result(steps) - exact) / std::abs(result(2 * steps) - exact));
    EXPECT_NEAR(slope, order, tolerance) << steps;
  }
}

// I3 on C3: the overlap of an undamped Hertz impact, begun inside the contact, near its peak.
TEST(Order, OfAnUndampedHertzContactIsTwo) {
  expect_order(2.0, 0.1, [](int steps) {
    auto beads = head_on(0.1);
    beads[0].x.x -= 2e-8;
    Dem dem(options(HertzMindlin{.restitution = 1.0}, 2.5e-6 / steps), beads, {});
    dem.run(steps);
    return dem.snapshot().mean_overlap;
  });
}

// I3 on T6: a bead that is let go on a steep slope and swings on the tangential spring.
TEST(Order, OfAnUndampedStickingContactIsTwo) {
  const Vec3 normal{0.6, 0, 0.8};
  const Wall slope{.name = "slope",
                   .surface = Plane{.point = {}, .normal = normal},
                   .material = plate,
                   .velocity = {},
                   .friction = 1e6};
  expect_order(2.0, 0.1, [&](int steps) {
    const auto b = with_weight(bead(0, (radius - 1e-8) * normal), 1000.0);
    Dem dem(options(hooke(1.0), 3e-6 / steps, 1e6), {b}, {slope});
    dem.run(steps);
    return dem.snapshot().w[0].y;
  });
}

// A bead that touches down with a tangential speed: its spring begins with a whole step's way, however
// late in that step it touched, so that the order is 1.
TEST(Order, OfAContactThatBeginsWithSlipIsOne) {
  expect_order(1.0, 0.1, [](int steps) {
    Dem dem(options(hooke(1.0), 3e-6 / steps, 1e6),
            {bead(0, {0, 0, radius - 1e-9}, {1e-4, 0, -1e-3})}, {floor_at(0, 1e6)});
    dem.run(steps);
    return dem.snapshot().w[0].y;
  });
}

// I2: a damped drop in three stages: fall, contact (a damped oscillator about its rest), rise. MFIX DEM01.
TEST(Order, DampedDropFollowsItsThreeStages) {
  const double g = 1000.0;  // so that the weight counts within a contact
  const double fall = 20e-6;
  const double m = mass_of(diameter_s, density_s);
  for (const double e : {1.0, 0.8, 0.6}) {
    const auto b = with_weight(bead(0, {0, 0, radius + fall}), g);
    const double dt = 1e-9;
    Dem dem(options(hooke(e), dt), {b}, {floor_at(0)});
    const double k =
        dem.wall_contacts().at(0).empty() ? 98.011745 : dem.wall_contacts()[0][0].coefficients.a;
    const double beta = damping_ratio(e);
    const double w = std::sqrt(k / m);
    const double wd = w * std::sqrt(1.0 - beta * beta);
    const double t1 = std::sqrt(2.0 * fall / g);
    const double v1 = std::sqrt(2.0 * fall * g);
    const auto height = [&](double t) {  // of the center over the radius, in the contact
      const double y0 = g / (w * w);
      const double s = (-v1 + beta * w * y0) / wd;
      return std::exp(-beta * w * t) * (y0 * std::cos(wd * t) + s * std::sin(wd * t)) - g / (w * w);
    };
    double t2 = std::numbers::pi / wd;  // end of the contact, by bisection around its dry value
    double low = 0.8 * t2;
    double high = 1.3 * t2;
    while (high - low > 1e-15) (height(0.5 * (low + high)) < 0.0 ? low : high) = 0.5 * (low + high);
    t2 = low;
    const double v2 = (height(t2 + 1e-9) - height(t2 - 1e-9)) / 2e-9;
    const double deepest = v1 / w;
    const auto run_to = [&](double t) {
      dem.run(std::llround(t / dt) - dem.steps());
      return dem.snapshot().x[0].z - radius;
    };
    for (const double part : {0.25, 0.5, 0.75}) {
      const double t = dt * std::round((t1 + part * t2) / dt);
      EXPECT_NEAR(run_to(t) / deepest, height(t - t1) / deepest, 1e-3) << e << " " << part;
    }
    const double t = dt * std::round((t1 + t2 + v2 / g) / dt);  // at the top
    EXPECT_NEAR(run_to(t) / (0.5 * v2 * v2 / g), 1.0, 1e-3) << e;
  }
}

}  // namespace
}  // namespace packbed::dem
