// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/overlap.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/support/spheres.hpp"

namespace packbed::analysis {
namespace {

using packbed::test::Draws;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unit_sphere = sphere_volume(1.0);

// A plane at 0.3 from the top of a sphere of radius 0.5: h^2 (3R - h) / (4R^3) = 0.216 is above it.
TEST(SphereCutByPlane, LosesItsCap) {
  const double above = 1.0 - volume_below(0.5, 0.2) / sphere_volume(0.5);

  EXPECT_NEAR(above, 0.216, 1e-15);
  EXPECT_EQ(volume_below(0.5, -0.6), 0.0);
  EXPECT_NEAR(volume_below(0.5, 0.7), sphere_volume(0.5), 1e-16);
  EXPECT_NEAR(volume_in_slab(2.0, {-1.0, 1.0}), std::numbers::pi * (2.0 * 4.0 - 2.0 / 3.0), 1e-13);
}

TEST(SphereCutByPlane, ShowsADisc) {
  EXPECT_NEAR(cut_area(0.5, 0.3), 0.16 * std::numbers::pi, 1e-15);
  EXPECT_EQ(cut_area(0.5, 0.6), 0.0);
}

TEST(SphereInBox, IsAnEighthAtTheCornerOfEightCells) {
  for (const double x : {-2.0, 0.0}) {
    for (const double y : {-2.0, 0.0}) {
      for (const double z : {-2.0, 0.0}) {
        const double part = volume_in_box(1.0, {x, y, z}, {x + 2.0, y + 2.0, z + 2.0});
        EXPECT_NEAR(part / unit_sphere, 0.125, 1e-14);
      }
    }
  }
}

TEST(SphereInBox, IsACapWhereOnePlaneCuts) {
  for (const double h : {-0.999, -0.5, 0.0, 0.3, 0.99999}) {
    const double cap = volume_below(1.0, h);
    EXPECT_NEAR(volume_in_box(1.0, {-infinity, -infinity, -2}, {h, infinity, 2}), cap, 1e-9);
    EXPECT_NEAR(volume_in_box(1.0, {-2, -2, -2}, {2, h, 2}), cap, 1e-9);
    EXPECT_NEAR(volume_in_box(1.0, {-2, -2, -2}, {2, 2, h}), cap, 1e-9);
  }
}

TEST(SphereInBox, IsConservedByCells) {
  Draws draw(3);
  for (int trial = 0; trial < 20; ++trial) {
    const double size = draw(0.3, 1.5);
    const Vec3 origin{draw(-2.6, -2.0), draw(-2.6, -2.0), draw(-2.6, -2.0)};
    double sum = 0.0;
    for (int i = 0; i < 16; ++i) {
      for (int j = 0; j < 16; ++j) {
        for (int k = 0; k < 16; ++k) {
          const Vec3 low = origin + size * Vec3{1.0 * i, 1.0 * j, 1.0 * k};
          if (low.x > 1.0 || low.y > 1.0 || low.z > 1.0) continue;
          sum += volume_in_box(1.0, low, low + size * Vec3{1, 1, 1});
        }
      }
    }
    EXPECT_NEAR(sum / unit_sphere, 1.0, 1e-9);
  }
}

struct InCylinder {
  double distance, cylinder_radius, volume;
};

// Unit sphere; quadrature with 30 digits of 4 rho sqrt(1 - rho^2) arccos((rho^2 + s^2 - r^2)/(2 rho s)).
constexpr InCylinder references[] = {
    {0.3, 0.5, 1.383065649150095599},
    {0.5, 0.5, 1.2055062135043066034},  // through the center, tangent inside
    {0.5, 0.4999, 1.2051061456197976351},
    {0.501, 0.5, 1.2041657322064541537},
    {0.6, 0.6, 1.3911597847414114136},
    {0.9, 0.1, 0.026001478391045848182},
    {3, 2.5, 0.57735591124167122682},
    {100.2, 100, 1.4708404497767788612},
    {47.5, 48, 3.5296534934612551661},
    {1e-06, 1.0000001, 4.1887902021312225406},
    {0.2, 1.1, 4.1151300724456601741},
    {1, 1, 1.6928706640025052355},
    {1e-09, 0.3, 0.55256562838647176559},
    {0.99, 0.001, 8.8606657951065939468e-7},
    {2, 1.001, 2.2214872839128331994e-6},
    {1.4, 2.3, 4.1495342195708046505},
};

TEST(SphereInCylinder, IsExactForAnyPlaceAndSize) {
  for (const auto& c : references) {
    SCOPED_TRACE(testing::Message()
                 << "distance " << c.distance << " radius " << c.cylinder_radius);
    EXPECT_NEAR(volume_in_cylinder(1.0, c.distance, c.cylinder_radius), c.volume,
                1e-12 * unit_sphere);
    const double small = 0.13e-3;
    EXPECT_NEAR(volume_in_cylinder(small, small * c.distance, small * c.cylinder_radius) /
                    sphere_volume(small),
                c.volume / unit_sphere, 1e-12);
  }
}

TEST(SphereInCylinder, HasItsSimpleLimits) {
  const double r =
      0.6;  // around the axis: the sphere less the ring left by a drill, 4/3 pi (1-r^2)^1.5
  EXPECT_NEAR(volume_in_cylinder(1.0, 0.0, r), unit_sphere * (1.0 - std::pow(1.0 - r * r, 1.5)),
              1e-14);
  EXPECT_EQ(volume_in_cylinder(1.0, 0.5, 1.5), unit_sphere);
  EXPECT_EQ(volume_in_cylinder(1.0, 3.0, 2.0), 0.0);
  EXPECT_EQ(volume_in_cylinder(1.0, 0.3, 0.0), 0.0);
  // A wide tube is a plane.
  EXPECT_NEAR(volume_in_cylinder(1.0, 1e7 - 0.3, 1e7), volume_below(1.0, 0.3), 1e-6);
}

// Two ways to the same volume: a quadrature along the wall and a stack of discs along the axis.
TEST(SphereInCylinder, AgreesWithTheStackOfDiscs) {
  Draws draw(5);
  const Range all{-infinity, infinity};
  for (const auto& c : references) {
    EXPECT_NEAR(volume_in_cylinder(1.0, c.distance, c.cylinder_radius, all), c.volume,
                1e-9 * unit_sphere);
  }
  for (int trial = 0; trial < 3000; ++trial) {
    const double r = std::pow(10.0, draw(-2.0, 2.0));
    const double s = std::abs(r + draw(-1.1, 1.1));
    const double cut = draw(-1.0, 1.0);
    SCOPED_TRACE(testing::Message() << "distance " << s << " radius " << r << " cut " << cut);
    const double lower = volume_in_cylinder(1.0, s, r, {-infinity, cut});
    const double upper = volume_in_cylinder(1.0, s, r, {cut, infinity});
    ASSERT_NEAR(lower + upper, volume_in_cylinder(1.0, s, r), 1e-9 * unit_sphere);
  }
}

TEST(SphereInCylinder, AgreesWithRandomPoints) {
  Draws draw(7);
  for (int trial = 0; trial < 10; ++trial) {
    const double r = draw(0.2, 2.0);
    const double s = draw(0.0, r + 0.8);
    const Range slab{draw(-1.0, 0.0), draw(0.0, 1.0)};
    const int points = 20000;
    int inside = 0;
    int inside_slab = 0;
    for (int k = 0; k < points; ++k) {
      const Vec3 x{draw(-1.0, 1.0), draw(-1.0, 1.0), draw(-1.0, 1.0)};
      if (norm(x) > 1.0 || std::hypot(x.x + s, x.y) > r) continue;
      ++inside;
      inside_slab += x.z > slab.low && x.z < slab.high ? 1 : 0;
    }
    const double error = 4.0 * 8.0 * std::sqrt(0.25 / points);  // four standard errors at most
    EXPECT_NEAR(volume_in_cylinder(1.0, s, r), 8.0 * inside / points, error);
    EXPECT_NEAR(volume_in_cylinder(1.0, s, r, slab), 8.0 * inside_slab / points, error);
  }
}

TEST(Discs, OverlapInALens) {
  EXPECT_NEAR(disc_in_disc(1.0, 1.0, 1.0), 2.0 * std::numbers::pi / 3.0 - std::sqrt(3.0) / 2.0,
              1e-15);
  EXPECT_NEAR(disc_in_disc(2.0, 1.0, 0.5), std::numbers::pi, 1e-15);
  EXPECT_NEAR(disc_area_below(2.0, 1e-3) - disc_area_below(2.0, -1e-3), 8e-3, 1e-9);
}

}  // namespace
}  // namespace packbed::analysis
