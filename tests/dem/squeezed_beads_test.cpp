// SPDX-License-Identifier: BSD-3-Clause
// C11 (MFIX DEM03): two beads of 0.5 mm radius, 20000 below and 10000 kg/m3 above, squeezed between
// plates 3.6 radii apart, with k = 1e3 N/m in all three contacts: rest heights, frequencies of both
// modes, energy.
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/beads.hpp"

namespace packbed::dem {
namespace {

using namespace test;  // NOLINT

constexpr double g = 9.81;
constexpr double r = 0.5e-3;
constexpr double k = 1e3;
constexpr double height = 3.6 * r;
const std::array mass = {mass_of(2 * r, 20000), mass_of(2 * r, 10000)};
constexpr std::array rest = {0.4332477249e-3, 1.366598180e-3};

/// Y* at which Hooke's law gives k_n = k.
double modulus_for(double r_eff, double m_eff) {
  const double factor = 16.0 / 15.0 * std::pow(15.0 / 16.0 * m_eff * speed_s * speed_s, 0.2);
  return std::pow(k / factor, 1.25) / std::sqrt(r_eff);
}

Wall plate_for(const char* name, double z, double up, double m, const Material& beads) {
  // poisson ratio 0: 1/Y* = 1/E + 1/E_wall
  const double e_wall = 1.0 / (1.0 / modulus_for(r, m) - 1.0 / beads.youngs_modulus);
  return {.name = name,
          .surface = Plane{.point = {0, 0, z}, .normal = {0, 0, up}},
          .material = {.youngs_modulus = e_wall, .poisson_ratio = 0.0},
          .velocity = {},
          .friction = 0.0};
}

Dem squeezed(double e, double step, std::array<double, 2> z) {
  const Material m{.youngs_modulus = 2.0 * modulus_for(r / 2, effective(mass[0], mass[1])),
                   .poisson_ratio = 0.0};
  return {options(hooke(e), step),
          {with_weight(bead(0, {0, 0, z[0]}, {}, 2 * r, 20000, m), g),
           with_weight(bead(1, {0, 0, z[1]}, {}, 2 * r, 10000, m), g)},
          {plate_for("floor", 0.0, 1.0, mass[0], m), plate_for("lid", height, -1.0, mass[1], m)}};
}

TEST(SqueezedBeads, RestWhereMfixSays) {
  auto dem = squeezed(0.5, 2e-6, {0.45e-3, 1.35e-3});
  dem.run(30000);
  const auto s = dem.snapshot();
  EXPECT_NEAR(s.x[0].z / rest[0], 1.0, 1e-9);
  EXPECT_NEAR(s.x[1].z / rest[1], 1.0, 1e-9);
}

/// Frequency by the first and last upward crossing of the rest height within many periods.
double frequency(double displacement_ratio) {
  const double step = 1e-6;
  const double a = 1e-6;
  auto dem = squeezed(1.0, step, {rest[0] + a, rest[1] + displacement_ratio * a});
  double before = a;
  double first = -1.0;
  double last = 0.0;
  int periods = -1;
  for (int n = 0; n < 60000; ++n) {
    dem.run(1);
    const double now = dem.particles().motion[0].x.z - rest[0];
    if (before < 0.0 && now >= 0.0) {
      last = dem.time() - step * now / (now - before);
      if (first < 0.0) first = last;
      ++periods;
    }
    before = now;
  }
  return periods / (last - first);
}

TEST(SqueezedBeads, SwingAtTheirTwoFrequencies) {
  // 2 k - m_1 w^2 times the displacement of the lower equals k times that of the upper
  const auto ratio = [](double f) {
    return (2.0 * k - mass[0] * std::pow(2.0 * std::numbers::pi * f, 2)) / k;
  };
  for (const double f : {1751.285, 3383.222}) EXPECT_NEAR(frequency(ratio(f)) / f, 1.0, 1e-4);
}

// 1e4 periods of the faster mode. Leapfrog keeps 1/2 m v(n - 1/2) v(n + 1/2) + V(x_n) of linear springs.
TEST(SqueezedBeads, KeepTheirEnergy) {
  const double step = 1.0 / 3383.222 / 30.0;
  auto dem = squeezed(1.0, step, {rest[0] + 2e-5, rest[1] + 1e-5});
  const auto energy = [&] {
    const auto before = dem.particles().motion;
    dem.run(1);
    const auto& after = dem.particles().motion;
    double sum = 0.0;
    const std::array overlap = {r - before[0].x.z, 2 * r - (before[1].x.z - before[0].x.z),
                                r - (height - before[1].x.z)};
    for (const double o : overlap) sum += 0.5 * k * o * o;
    for (std::size_t i = 0; i < 2; ++i) {
      sum += mass[i] * (0.5 * before[i].v.z * after[i].v.z + g * before[i].x.z);
    }
    return sum;
  };
  dem.run(1);
  const double start = energy();
  for (int look = 0; look < 200; ++look) {
    dem.run(1499);
    EXPECT_NEAR(energy() / start, 1.0, 1e-6) << look;
  }
}

}  // namespace
}  // namespace packbed::dem
