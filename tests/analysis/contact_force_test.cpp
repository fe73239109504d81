// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/contact_force.hpp"

#include <gtest/gtest.h>

#include "tests/support/beads.hpp"
#include "tests/support/contacts.hpp"

namespace packbed::analysis {
namespace {

using namespace packbed::test;  // NOLINT

/// A push, a pull and a push of a wall.
std::vector<dem::ContactReport> reports_by_hand() {
  std::vector<dem::ContactReport> reports(3);
  for (auto& r : reports) r.id_i = 3;
  reports[0].id_j = 5;
  reports[0].branch = {0, 2, 0};
  reports[0].normal = {0, -4, 0};
  reports[0].tangential = {3, 0, 4};
  reports[1].id_j = 6;
  reports[1].branch = {0, 2, 0};
  reports[1].normal = {0, 4, 0};
  reports[2].id_j = -2;
  reports[2].x = {1, 1, 1};
  reports[2].branch = {0, 0, -1};
  reports[2].normal = {0, 0, 7};
  return reports;
}

TEST(ContactForces, HaveTheSignOfThePush) {
  const auto contacts = contact_forces(reports_by_hand());

  ASSERT_EQ(contacts.size(), 3U);
  EXPECT_EQ(contacts[0].normal, 4.0);
  EXPECT_EQ(contacts[1].normal, -4.0);
  EXPECT_EQ(contacts[2].normal, 7.0);
  EXPECT_EQ(contacts[2].x, (Vec3{1, 1, 1}));
  EXPECT_EQ(mean_force(contacts), 4.0);  // neither the pull nor the wall
}

TEST(ContactForces, KnowWallsAndFriction) {
  const auto contacts = contact_forces(reports_by_hand());
  EXPECT_EQ(contacts[0].tangential, 5.0);
  EXPECT_EQ(tangential_forces(reports_by_hand())[0], (Vec3{3, 0, 4}));
  EXPECT_FALSE(contacts[0].with_wall());
  EXPECT_TRUE(contacts[2].with_wall());
  EXPECT_EQ(touching_pairs(contacts)[0].j, 5);
  EXPECT_EQ(touching_pairs(contacts)[2].j, wall_id);
}

TEST(ContactForces, OfADemAreItsForces) {
  const double overlap = 1e-3 * diameter_s;
  const double r = 0.5 * diameter_s;
  const dem::Dem dem(options(hooke(0.5), 1e-9),
                     {bead(1, {0, 0, r - overlap}), bead(2, {0, 0, 3 * r - 2 * overlap})},
                     {floor_at(0)});

  const auto contacts = contact_forces(dem.touching_contacts());

  ASSERT_EQ(contacts.size(), 2U);
  const double stiffness = 37.209127;  // of a pair of these beads [N/m]
  const auto& pair = contacts[contacts[0].with_wall() ? 1 : 0];
  const auto& wall = contacts[contacts[0].with_wall() ? 0 : 1];
  EXPECT_NEAR(pair.normal, stiffness * overlap, 1e-6 * stiffness * overlap);
  EXPECT_NEAR(pair.overlap, overlap, 1e-12 * diameter_s);
  EXPECT_GT(wall.normal, pair.normal);  // a stiffer pair
  EXPECT_NEAR(contact_normal(wall).z, -1.0, 1e-15);
}

TEST(ContactForces, OfNothingAreNothing) {
  EXPECT_TRUE(contact_forces({}).empty());
  EXPECT_EQ(mean_force({}), 0.0);
  EXPECT_EQ(contact_normal({}), Vec3{});
}

}  // namespace
}  // namespace packbed::analysis
