// SPDX-License-Identifier: BSD-3-Clause
// Which beads of a bed at rest count as tipping over, and how the others are told from them.
#include "column/protocol/tipping.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/settling.hpp"

namespace packbed::column {
namespace {

using namespace test;  // NOLINT
using ::testing::IsEmpty;

constexpr TippingLimits limits{.slowest = 1e-6, .speed = 5e-3};
constexpr double weight = 4e-9;

/// Fifty beads that rest, borne by their neighbors, and the velocity of and the force on the first one.
dem::Snapshot bed(const Vec3& v, const Vec3& net_force, double others = 1e-9) {
  dem::Snapshot s{};
  for (std::int64_t id = 0; id < 50; ++id) {
    auto bead = grain(id);
    bead.weight = weight;
    s.beads.push_back(bead);
    s.v.push_back(id == 0 ? v : Vec3{0.0, 0.0, others});
    s.force.push_back(Vec3{0.0, 0.0, weight} + (id == 0 ? net_force : Vec3{}));
  }
  return s;
}

const Vec3 along{0.6, 0.0, -0.8};
const auto before = bed(1e-5 * along, 1e-12 * along);

TEST(TippingBeads, ArePushedTheWayTheyGo) {
  const auto pushed = tipping_beads(before, bed(1.1e-5 * along, 1.1e-12 * along), limits);
  ASSERT_EQ(pushed.size(), 1U);
  EXPECT_EQ(pushed[0].id, 0);
  EXPECT_LT(norm(pushed[0].v - limits.speed * along), 1e-12 * limits.speed);
}

TEST(TippingBeads, AreNotThoseThatComeToRestOrSwingInAHollow) {
  EXPECT_THAT(tipping_beads(before, bed(0.9e-5 * along, 1.1e-12 * along), limits), IsEmpty());
  EXPECT_THAT(tipping_beads(before, bed(1.1e-5 * along, 0.9e-12 * along), limits), IsEmpty());
  EXPECT_THAT(tipping_beads(before, bed(-1.1e-5 * along, -1.1e-12 * along), limits), IsEmpty());
  EXPECT_THAT(
      tipping_beads(bed(1e-5 * along, -2e-12 * along), bed(1.1e-5 * along, -1e-12 * along), limits),
      IsEmpty());
}

TEST(TippingBeads, AreNeitherSlowerThanAtRestNorFasterThanAPush) {
  for (const double speed : {0.9e-6, 5e-3, 1.0}) {
    EXPECT_THAT(tipping_beads(bed(0.9 * speed * along, 1e-12 * along),
                              bed(speed * along, 1.1e-12 * along), limits),
                IsEmpty())
        << speed;
  }
}

TEST(TippingBeads, AreAlone) {
  EXPECT_THAT(tipping_beads(before, bed(1.1e-5 * along, 1.1e-12 * along, 1e-6), limits), IsEmpty());
  auto fixed = bed(1.1e-5 * along, 1.1e-12 * along);
  fixed.beads[0].fixed = true;
  EXPECT_THAT(tipping_beads(before, fixed, limits), IsEmpty());
  EXPECT_THAT(tipping_beads({}, {}, limits), IsEmpty());
}

/// Time in which a bead that begins to slide off another comes down to its side [s].
double time_to_fall(bool pushed) {
  const double g = 1.2;      // less buoyancy
  const double lean = 0.12;  // friction holds at 0.1
  const auto law = hooke(0.5);
  auto o = options(law, 1e-6, 0.1, dem::ElasticPlastic{0.35});
  o.background_damping = 300.0;
  auto below = bead(0, {});
  auto beside = bead(2, {1.0, 0.0, 0.0});
  below.properties.fixed = beside.properties.fixed = true;
  const auto above =
      bead(1, diameter_s * Vec3{lean, 0.0, std::sqrt(1.0 - lean * lean)}, {1e-7, 0.0, 0.0});
  dem::Dem dem(o, {below, with_weight(above, g), beside}, {});
  while (dem.particles().motion[1].x.x < 0.7 * diameter_s) {
    dem.run(400);
    const auto earlier = dem.snapshot();
    dem.run(100);
    if (pushed) dem.set_velocities(tipping_beads(earlier, dem.snapshot(), limits));
    if (dem.time() > 5.0) break;
  }
  return dem.time();
}

TEST(TippingBeads, AreDownSooner) {
  const double alone = time_to_fall(false);
  EXPECT_LT(alone, 5.0);
  EXPECT_LT(time_to_fall(true), 0.5 * alone);
}

}  // namespace
}  // namespace packbed::column
