// SPDX-License-Identifier: BSD-3-Clause
#include "continuum/bead/loop.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "continuum/bead/hertz.hpp"
#include "continuum/bead/viscoelastic.hpp"
#include "tests/support/message_of.hpp"

namespace packbed::continuum {
namespace {

constexpr BeadShape shape{.radius = 30e-6, .poisson = 0.2};

LoopWork work_of(const ViscoelasticBead& bead, const Loading& loading, int rows) {
  std::vector<double> approach;
  std::vector<double> force;
  const double end = loading.unload_start() + loading.ramp_time;
  for (int i = 0; i <= rows; ++i) {
    const double t = end * i / rows;
    approach.push_back(loading.approach(t));
    force.push_back(bead.force(loading, t));
  }
  return loop_work(approach, force);
}

TEST(Loop, OfAnElasticBeadGivesAllBack) {  // B6
  const ViscoelasticBead bead{shape, {.relaxed = 1.62e6, .terms = {}}};
  const HertzBead hertz{shape, youngs_modulus(1.62e6, 0.2)};

  const auto work = work_of(bead, {.depth = 4e-6, .ramp_time = 4.0, .hold_time = 0.0}, 20000);

  EXPECT_NEAR(work.restitution(), 1.0, 1e-8);
  EXPECT_NEAR(work.loading / hertz.energy(4e-6), 1.0, 1e-8);  // trapezium rule, 10000 strips: 3e-9
}

// B6 on the loops of B1. W has a closed form in the remainder of the ramp; here against the trapezium rule with
// strips halved twice.
TEST(Loop, RestitutionOfAStandardLinearSolidConverges) {
  const ViscoelasticBead bead{shape, sls_maxwell(1.62e6, 3.51e6, 0.9e6)};
  const Loading loading{.depth = 4.5e-6, .ramp_time = 5.0, .hold_time = 0.0};

  const double e1 = work_of(bead, loading, 20000).restitution();
  const double e2 = work_of(bead, loading, 80000).restitution();

  EXPECT_NEAR(e1, e2, 1e-8);
  EXPECT_GT(e2, 0.5);
  EXPECT_LT(e2, 1.0);
}

TEST(Loop, LosesNothingIfVeryFastOrVerySlow) {
  const ViscoelasticBead bead{shape, sls_maxwell(1.62e6, 3.51e6, 0.9e6)};
  const auto e = [&](double time) {
    return work_of(bead, {.depth = 4.5e-6, .ramp_time = time, .hold_time = 0.0}, 4000)
        .restitution();
  };
  EXPECT_NEAR(e(1e-6), 1.0, 1e-4);
  EXPECT_NEAR(e(1e6), 1.0, 1e-4);
  EXPECT_LT(e(0.25), 0.9);
}

TEST(Loop, RefusesHalfALoop) {
  const std::vector<double> up{0.0, 1.0, 2.0};
  EXPECT_EQ(test::message_of([&] { loop_work(up, up); }),
            "the curve has no unloading: the displacement does not fall after its largest");
  const std::vector<double> down{2.0, 1.0, 0.0};
  EXPECT_EQ(test::message_of([&] { loop_work(down, down); }),
            "the curve has no loading: the displacement is largest in the first row");
}

}  // namespace
}  // namespace packbed::continuum
