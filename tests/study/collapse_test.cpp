// SPDX-License-Identifier: BSD-3-Clause
#include "study/collapse.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/message_of.hpp"

namespace packbed::study {
namespace {

// Contact radii of 1, 2 and 4 um depth go as 1 : sqrt 2 : 2.
std::vector<Relaxation> curves(double growth_of_time) {
  std::vector<Relaxation> all;
  for (const double depth : {1.0, 2.0, 4.0}) {
    const double stretch = 1.0 + growth_of_time * (depth - 1.0);
    all.push_back({.contact_radius = 3.9e-6 * std::sqrt(depth),
                   .duration = 10.0,
                   .shortest = 0.01,
                   .amplitudes = {2.5 * depth, 0.5 * depth},
                   .times = {3.0 * stretch, 0.3 * stretch}});
  }
  return all;
}

TEST(Collapse, OfViscoelasticBeadsIsOverTime) {
  const auto c = collapse(curves(0.0));
  EXPECT_TRUE(c.is_viscoelastic());
  EXPECT_NEAR(c.spread_over_time, 0.0, 1e-7);
  EXPECT_GT(c.spread_over_scaled, 0.05);
}

TEST(Collapse, OfPoroelasticBeadsIsOverTimeByArea) {  // times in proportion to a^2
  const auto c = collapse(curves(1.0));
  EXPECT_FALSE(c.is_viscoelastic());
  EXPECT_NEAR(c.spread_over_scaled, 0.0, 1e-7);
}

// The coefficients of table 6.3 for both resins: the thesis finds them to collapse over time (fig. 6.8).
TEST(Collapse, OfTheBeadsOfTheThesisIsOverTime) {
  const auto relaxation = [](double radius, double depth, double b1, double t1, double b2,
                             double t2) {
    return Relaxation{.contact_radius = std::sqrt(0.5 * depth * radius),
                      .duration = 10.0,
                      .shortest = 0.01,
                      .amplitudes = {b1, b2},
                      .times = {t1, t2}};
  };
  const auto sep = collapse({relaxation(30, 1, 2.54, 15.45, 0.49, 0.50),
                             relaxation(30, 2, 5.53, 15.26, 0.74, 0.51),
                             relaxation(30, 4, 4.95, 13.79, 0.99, 0.51)});
  const auto toy = collapse({relaxation(41.5, 1, 3.52, 6.41, 1.76, 0.47),
                             relaxation(41.5, 2, 5.67, 6.43, 2.55, 0.48),
                             relaxation(41.5, 4, 12.99, 6.41, 5.33, 0.47)});
  EXPECT_TRUE(sep.is_viscoelastic());
  EXPECT_TRUE(toy.is_viscoelastic());
  EXPECT_LT(3.0 * toy.spread_over_time, toy.spread_over_scaled);
}

TEST(Collapse, NeedsDifferentDepths) {
  auto same = curves(0.0);
  for (auto& c : same) c.contact_radius = 4e-6;
  EXPECT_EQ(test::message_of([&] { collapse(same); }),
            "the curves have nearly the same contact radius; compress to different depths");
}

}  // namespace
}  // namespace packbed::study
