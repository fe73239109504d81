// SPDX-License-Identifier: BSD-3-Clause
// Volumes that contacts take of beads, against closed forms.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/beads.hpp"

namespace packbed::dem {
namespace {

using namespace test;  // NOLINT

constexpr double d = 90e-6;

// Lens of two spheres of radii a, b at the distance r (Weisstein, "Sphere-sphere intersection", eq. 16).
double lens(double a, double b, double r) {
  return std::numbers::pi * std::pow(a + b - r, 2) *
         (r * r + 2 * r * b - 3 * b * b + 2 * r * a + 6 * a * b - 3 * a * a) / (12 * r);
}

TEST(ContactLenses, ShareTheLensOfTwoBeads) {
  const double big = 0.75 * d;  // radii
  const double small = 0.5 * d;
  const double r = 0.95 * (big + small);
  const Dem dem(options(hooke(0.5), 1e-7),
                {bead(0, {0, 0, 0}, {}, 2 * big), bead(1, {r, 0, 0}, {}, 2 * small),
                 bead(2, {0, 5 * d, 0}, {}, d)},
                {});
  const auto lost = dem.lens_volumes();
  ASSERT_EQ(lost.size(), 3U);
  double sum = 0.0;
  for (const double v : lost) sum += v;
  EXPECT_NEAR(sum, lens(big, small, r), 1e-12 * sum);
  for (std::size_t i = 0; i < 3; ++i) {
    if (dem.particles().properties[i].id == 2) {
      EXPECT_EQ(lost[i], 0.0);
    }
  }
  EXPECT_EQ(dem.meeting_lenses(), 0);
}

TEST(ContactLenses, CutOffWhatIsBehindAWall) {
  const double h = 0.04 * d;
  const Dem dem(options(hooke(0.5), 1e-7), {bead(0, {0, 0, 0.5 * d - h}, {}, d)}, {floor_at(0.0)});
  EXPECT_NEAR(dem.lens_volumes()[0], std::numbers::pi * h * h * (1.5 * d - h) / 3.0, 1e-24);
}

TEST(ContactLenses, ReachAcrossAPeriodicSide) {
  auto o = options(hooke(0.5), 1e-7);
  o.domain = {.low = {0, 0, 0}, .size = {10 * d, 10 * d, 10 * d}, .periodic = {true, true, true}};
  const Dem dem(o, {bead(0, {0.4 * d, 0, 0}, {}, d), bead(1, {9.45 * d, 0, 0}, {}, d)}, {});
  EXPECT_NEAR(dem.lens_volumes()[0], 0.5 * lens(0.5 * d, 0.5 * d, 0.95 * d), 1e-24);
}

// Two neighbors of a bead 60 degrees apart: caps of half the angle or more meet.
TEST(ContactLenses, AreCountedWhereTheyMeet) {
  for (const double squeeze : {0.90, 0.80}) {  // half angle acos(squeeze): 26 and 37 degrees
    const double r = squeeze * d;
    auto o = options(hooke(0.5), 1e-7);
    o.overlap_limit = 0.5;
    const Dem dem(o,
                  {bead(0, {0, 0, 0}, {}, d), bead(1, {r, 0, 0}, {}, d),
                   bead(2, {0.5 * r, 0.5 * std::sqrt(3.0) * r, 0}, {}, d)},
                  {});
    EXPECT_EQ(dem.meeting_lenses(), squeeze > 0.85 ? 0 : 3);
  }
}

}  // namespace
}  // namespace packbed::dem
