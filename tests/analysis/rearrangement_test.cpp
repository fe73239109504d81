// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/rearrangement.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/contacts.hpp"
#include "tests/support/message_of.hpp"

namespace packbed::analysis {
namespace {

using namespace packbed::test;  // NOLINT

constexpr double d = 1e-4;

/// A loosened lattice of beads that overlap.
std::vector<Bead> bed() {
  Draws draw(2);
  auto beads = cubic(d, 5, 5, 5);
  for (auto& b : beads) {
    b.radius = 0.6 * d;
    b.x += 0.1 * d * Vec3{draw(-1, 1), draw(-1, 1), draw(-1, 1)};
  }
  return beads;
}

/// Every bead taken to x + motion(x).
template <class Motion>
std::vector<Bead> moved(std::vector<Bead> beads, const Motion& motion) {
  for (auto& b : beads) b.x += motion(b.x);
  return beads;
}

template <class Motion>
NonAffineMotion after(const Motion& motion) {
  const auto beads = bed();
  return non_affine_motion(displacements(beads, moved(beads, motion), {}), contacts_of(beads));
}

TEST(Displacements, AreTheShortestOverPeriodicSides) {
  const std::vector<Bead> before = {{{0.9, 0.5, 0}, 0.1, 8}, {{0.1, 0.1, 0}, 0.1, 3}};
  const std::vector<Bead> after = {{{0.2, 0.7, 0}, 0.1, 3}, {{0.1, 0.4, 5}, 0.1, 8}, {{}, 0.1, 9}};

  const auto both = displacements(before, after, {1.0, 1.0, 0.0});

  ASSERT_EQ(both.beads.size(), 2U);
  EXPECT_EQ(both.beads[0].id, 3);
  EXPECT_NEAR(both.beads[0].moved.y, -0.4, 1e-15);
  EXPECT_EQ(both.beads[1].id, 8);
  EXPECT_NEAR(both.beads[1].moved.x, 0.2, 1e-15);
  EXPECT_NEAR(both.beads[1].moved.y, -0.1, 1e-15);
  EXPECT_EQ(both.beads[1].moved.z, 5.0);
  EXPECT_EQ(both.come, 1);
  EXPECT_EQ(both.gone, 0);
  EXPECT_EQ(displacements(after, before, {}).gone, 1);
  EXPECT_THAT(message_of([] {
                const std::vector<Bead> twice(2);
                (void)displacements(twice, twice, {});
              }),
              testing::HasSubstr("must be unique"));
}

TEST(NonAffineMotion, OfAnAffineMotionIsZero) {
  const auto strain = after([](const Vec3& x) {
    return Vec3{1e-5, 2e-5, 3e-5} + Vec3{0.1 * x.x - 0.3 * x.y, 0.2 * x.z, -0.2 * x.z + 0.4 * x.x};
  });
  EXPECT_EQ(strain.beads.size(), 125U - static_cast<std::size_t>(strain.left_out));
  EXPECT_GT(strain.beads.size(), 100U);
  for (const auto& b : strain.beads) EXPECT_LT(b.square, 1e-28 * d * d);
  EXPECT_LT(strain.mean_square, 1e-28 * d * d);
}

TEST(NonAffineMotion, OfSimpleShearAndOfARotationIsZero) {
  EXPECT_LT(after([](const Vec3& x) { return Vec3{0.5 * x.z, 0, 0}; }).mean_square, 1e-28 * d * d);
  const double c = std::cos(1.0);
  const double s = std::sin(1.0);
  const auto turned = after([&](const Vec3& x) {
    return Vec3{c * x.x - s * x.y, s * x.x + c * x.y, x.z} - x;
  });
  EXPECT_LT(turned.mean_square, 1e-28 * d * d);
}

// A bead with a neighbor on both sides along each axis; the one at +x goes a to the side. Half of that is taken for
// a shear, which leaves a/2 at two of six neighbors.
TEST(NonAffineMotion, IsWhatNoStrainExplains) {
  const double a = 0.3 * d;
  std::vector<Bead> beads = {{{0, 0, 0}, d, 0}};
  std::vector<ContactForce> contacts;
  for (const Vec3& x : {Vec3{d, 0, 0}, Vec3{-d, 0, 0}, Vec3{0, d, 0}, Vec3{0, -d, 0}, Vec3{0, 0, d},
                        Vec3{0, 0, -d}}) {
    const auto id = static_cast<std::int64_t>(beads.size());
    contacts.push_back(contact(0, id, x, 1.0));
    beads.push_back({x, d, id});
  }
  auto later = beads;
  later[1].x.y += a;

  const auto motion = non_affine_motion(displacements(beads, later, {}), contacts);

  ASSERT_EQ(motion.beads.size(), 1U);  // the neighbors have one contact each
  EXPECT_EQ(motion.left_out, 6);
  EXPECT_NEAR(motion.beads[0].square, a * a / 12.0, 1e-12 * a * a);
  const auto others = non_affine_motion(displacements(later, beads, {}), shuffled(contacts));
  EXPECT_NEAR(others.mean_square, a * a / 12.0, 1e-12 * a * a);

  later.pop_back();
  const auto fewer = non_affine_motion(displacements(beads, later, {}), contacts);
  EXPECT_EQ(fewer.contacts_left_out, 1);
  EXPECT_NEAR(fewer.mean_square, a * a / 10.0, 1e-12 * a * a);  // five neighbors
}

TEST(NonAffineMotion, NeedsNeighborsOnAllSides) {
  auto plane = cubic(d, 4, 4, 1);
  for (auto& b : plane) b.radius = 0.55 * d;
  const auto motion = non_affine_motion(displacements(plane, plane, {}), contacts_of(plane));
  EXPECT_EQ(motion.left_out, 16);
  EXPECT_EQ(motion.mean_square, 0.0);
  EXPECT_EQ(non_affine_motion({}, {}).left_out, 0);
}

TEST(Wandering, OfAnEvenCompressionIsZero) {
  const auto beads = bed();
  const auto later = moved(beads, [](const Vec3& x) { return Vec3{0, 0, 1e-5 - 0.2 * x.z}; });
  for (const int slabs : {1, 2, 4, 50}) {
    const auto w = wandering(displacements(beads, later, {}), slabs);
    EXPECT_EQ(w.lateral, 0.0);
    if (slabs > 1) {
      EXPECT_NEAR(w.vertical, 0.0, 1e-14 * d);
    }
  }
}

TEST(Wandering, IsTheRest) {
  auto beads = cubic(d, 2, 2, 10);
  auto later = moved(beads, [](const Vec3& x) { return Vec3{3e-6, 4e-6, -0.1 * x.z}; });
  for (std::size_t k = 0; k < later.size(); ++k) later[k].x.z += k % 2 == 0 ? 2e-6 : -2e-6;

  const auto w = wandering(displacements(beads, later, {}), 5);

  EXPECT_NEAR(w.lateral, 5e-6, 1e-18);
  EXPECT_NEAR(w.vertical, 2e-6, 1e-18);
  ASSERT_EQ(w.beads.size(), 40U);
  EXPECT_NEAR(w.beads[7].moved.z, -2e-6, 1e-18);
  EXPECT_EQ(wandering({}, 5).lateral, 0.0);
}

TEST(ContactChanges, CountLostAndMadeOnes) {
  const std::vector<TouchingPair> before = {{1, 2}, {2, 3}, {3, 4}, {5, 6}, {5, 6}, {1, wall_id}};
  const std::vector<TouchingPair> after = {{4, 3}, {6, 5}, {2, 1}, {7, 8}, {2, wall_id}};

  const auto c = contact_changes(before, after);

  EXPECT_EQ(c.before, 5);
  EXPECT_EQ(c.after, 4);
  EXPECT_EQ(c.lost, 2);  // 2-3, and one of the two images of 5-6
  EXPECT_EQ(c.made, 1);
  EXPECT_EQ(c.lost_share, 0.4);
  EXPECT_EQ(c.made_share, 0.25);
  EXPECT_EQ(contact_changes({}, {}).lost_share, 0.0);
  EXPECT_EQ(contact_changes(before, {}).lost_share, 1.0);
}

}  // namespace
}  // namespace packbed::analysis
