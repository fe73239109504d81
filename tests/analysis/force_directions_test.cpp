// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/force_directions.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "tests/support/contacts.hpp"

namespace packbed::analysis {
namespace {

using namespace packbed::test;  // NOLINT
using testing::AllOf;
using testing::DoubleNear;
using testing::Each;
using testing::Field;

TEST(ForceDirections, OfAnIsotropicBedHaveTheDensityOne) {
  const auto bins = force_directions(even_contacts(180000, [](double) { return 2.0; }));
  ASSERT_EQ(bins.size(), 18U);
  EXPECT_THAT(bins, Each(AllOf(Field(&DirectionBin::density, DoubleNear(1.0, 3e-3)),
                               Field(&DirectionBin::mean_force, DoubleNear(1.0, 1e-9)),
                               Field(&DirectionBin::above_share, 0.0))));
  EXPECT_EQ(bins.front().low, 0.0);
  EXPECT_EQ(bins.back().high, 90.0);
}

// Nine level contacts of 1 N, one of 11 N straight down: <F> = 2 N.
TEST(ForceDirections, TellLateralFromAxial) {
  std::vector<ContactForce> contacts(9, contact(0, 1, {1, 2, 0}, 1.0));
  contacts.push_back(contact(1, 2, {0, 0, -3}, 11.0));
  contacts.push_back(contact(1, -1, {0, 0, -3}, 50.0));

  const auto bins = force_directions(contacts, {.width = 30.0, .multiple = 5.0});

  ASSERT_EQ(bins.size(), 3U);
  EXPECT_EQ(bins[0].contacts, 9);
  EXPECT_NEAR(bins[0].density, 0.9 / 0.5, 1e-12);
  EXPECT_EQ(bins[0].mean_force, 0.5);
  EXPECT_EQ(bins[1].density, 0.0);
  EXPECT_EQ(bins[2].contacts, 1);
  EXPECT_EQ(bins[2].largest_force, 5.5);
  EXPECT_EQ(bins[2].above_share, 1.0);
}

TEST(Fabric, OfACubicLatticeIsIsotropic) {
  auto beads = cubic(1.0, 3, 3, 3);
  for (auto& b : beads) b.radius *= 1.01;
  const auto contacts = contacts_of(beads);
  ASSERT_EQ(contacts.size(), 54U);

  const auto f = fabric(contacts);

  const std::vector<double> diagonal = {f.contacts.xx, f.contacts.yy, f.contacts.zz, f.forces.zz};
  EXPECT_THAT(diagonal, Each(DoubleNear(1.0 / 3.0, 1e-14)));
  EXPECT_EQ(f.contacts.xy, 0.0);
  EXPECT_NEAR(anisotropy(f.contacts), 0.0, 1e-14);
  EXPECT_NEAR(axial_excess(f.contacts), 0.0, 1e-14);
  EXPECT_NEAR(f.axial_to_lateral(), 1.0, 1e-13);
}

TEST(Fabric, ShowsAnAxialLoad) {
  std::vector<ContactForce> contacts = {
      contact(0, 1, {2, 0, 0}, 1.0), contact(0, 2, {0, 1, 0}, 1.0), contact(0, 3, {0, 0, 5}, 3.0)};
  const auto f = fabric(contacts);
  EXPECT_NEAR(axial_excess(f.contacts), 0.0, 1e-15);
  EXPECT_NEAR(f.forces.zz, 0.6, 1e-15);
  EXPECT_NEAR(f.axial_to_lateral(), 3.0, 1e-15);
  EXPECT_NEAR(anisotropy(f.forces), 0.4, 1e-15);

  contacts = {contact(0, 1, {1, 1, 0}, 1.0)};
  EXPECT_NEAR(anisotropy(fabric(contacts).contacts), 1.0, 1e-15);  // all parallel
  EXPECT_NEAR(fabric(contacts).contacts.xy, 0.5, 1e-15);
}

TEST(ForceDirections, DoNotDependOnOrderOrOnWhoTells) {
  const auto contacts = even_contacts(500, [](double u) { return u; });
  const auto others = shuffled(contacts);
  EXPECT_NEAR(force_directions(contacts)[7].density, force_directions(others)[7].density, 1e-12);
  EXPECT_NEAR(force_directions(contacts)[7].mean_force, force_directions(others)[7].mean_force,
              1e-12);
  EXPECT_NEAR(fabric(contacts).forces.xz, fabric(others).forces.xz, 1e-14);
}

TEST(ForceDirections, OfNothingAreZero) {
  EXPECT_THAT(force_directions({}), Each(Field(&DirectionBin::density, 0.0)));
  EXPECT_EQ(fabric({}).axial_to_lateral(), 0.0);
  EXPECT_EQ(anisotropy(fabric({}).contacts), 0.0);
  EXPECT_THROW((void)force_directions({}, {.width = 0.0}), ValueError);
}

}  // namespace
}  // namespace packbed::analysis
