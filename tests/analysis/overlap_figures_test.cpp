// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/overlap_figures.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/overlap.hpp"
#include "tests/support/contacts.hpp"
#include "tests/support/message_of.hpp"

namespace packbed::analysis {
namespace {

using namespace packbed::test;  // NOLINT

/// Three beads of diameter 1 whose centers are 1 - overlap apart.
std::vector<Bead> triangle(double overlap) {
  const double side = 1.0 - overlap;
  return {{{0, 0, 0}, 0.5, 10},
          {{side, 0, 0}, 0.5, 11},
          {{0.5 * side, 0.5 * std::numbers::sqrt3 * side, 0}, 0.5, 12}};
}

TEST(BeadOverlaps, AddContactsAndCaps) {
  const auto beads = triangle(0.1);
  auto contacts = contacts_of(beads);
  contacts.push_back(contact(11, -1, {0, 0, -0.3}, 1.0, beads[1].x));
  contacts.back().overlap = 0.2;

  const auto each = bead_overlaps(beads, shuffled(contacts));

  ASSERT_EQ(each.size(), 3U);
  const double cap = volume_below(0.5, -0.45) / sphere_volume(0.5);
  EXPECT_EQ(each[0].id, 10);
  EXPECT_EQ(each[0].contacts, 2);
  EXPECT_NEAR(each[0].largest, 0.1, 1e-15);
  EXPECT_NEAR(each[0].sum, 0.2, 1e-15);
  EXPECT_NEAR(each[0].capped, 2.0 * cap, 1e-15);
  EXPECT_EQ(each[1].contacts, 3);
  EXPECT_NEAR(each[1].largest, 0.2, 1e-15);
  EXPECT_NEAR(each[1].sum, 0.4, 1e-15);
  EXPECT_NEAR(each[1].capped, 2.0 * cap + volume_below(0.5, -0.3) / sphere_volume(0.5), 1e-15);
}

// The two caps of a pair make its lens: pi (r + s - l)^2 (l^2 + 2 l (r + s) - 3 (r - s)^2) / (12 l).
TEST(BeadOverlaps, HaveTheLensOfUnequalBeads) {
  const double r = 0.5;
  const double s = 0.2;
  for (const double l : {0.69, 0.5, 0.35}) {
    const std::vector<Bead> beads = {{{0, 0, 0}, r, 0}, {{0, l, 0}, s, 1}};
    const auto each = bead_overlaps(beads, contacts_of(beads));
    const double lens = std::numbers::pi * std::pow(r + s - l, 2) *
                        (l * l + 2.0 * l * (r + s) - 3.0 * std::pow(r - s, 2)) / (12.0 * l);
    EXPECT_NEAR(each[0].capped * sphere_volume(r) + each[1].capped * sphere_volume(s), lens, 1e-15);
    EXPECT_NEAR(each[1].largest, (r + s - l) / 0.4, 1e-15);
  }
}

// Caps of three beads that touch each other meet from an overlap of 1 - sqrt(3)/2 of the diameter on.
TEST(BeadOverlaps, TellWhenThroatsClose) {
  const double closed = 1.0 - 0.5 * std::numbers::sqrt3;
  const auto open_beads = triangle(closed - 1e-6);
  for (const auto& b : bead_overlaps(open_beads, contacts_of(open_beads))) {
    EXPECT_FALSE(b.caps_meet);
  }
  const auto closed_beads = triangle(closed + 1e-6);
  const auto figures = overlap_figures(closed_beads, contacts_of(closed_beads));
  EXPECT_EQ(figures.caps_meet, 3);
}

/// Five beads in a row, the last one half as large, pressed by 0.02, 0.15, 0.3 and 0.06, which is 0.12 of 0.5.
struct Row {
  std::vector<Bead> beads;
  std::vector<ContactForce> contacts;
};

Row row() {
  std::vector<Bead> beads;
  beads.reserve(5);
  for (int k = 0; k < 5; ++k) beads.push_back({{1.0 * k, 0, 0}, k == 4 ? 0.25 : 0.5, k});
  std::vector<ContactForce> contacts;
  const std::vector<double> overlaps = {0.02, 0.15, 0.3, 0.06};
  for (std::size_t k = 0; k < overlaps.size(); ++k) {
    const auto id = static_cast<std::int64_t>(k);
    contacts.push_back(contact(id, id + 1, {1.0 - overlaps[k], 0, 0}, 1.0));
    contacts.back().overlap = overlaps[k];
  }
  contacts.back().branch.x = 0.69;
  return {beads, contacts};
}

TEST(OverlapFigures, SayWhetherABedCanBeBelieved) {
  const auto [beads, contacts] = row();

  const auto f = overlap_figures(beads, contacts);

  EXPECT_EQ(f.contacts, 4);
  EXPECT_NEAR(f.mean, (0.02 + 0.15 + 0.3 + 0.12) / 4.0, 1e-15);
  EXPECT_NEAR(f.largest, 0.3, 1e-15);
  EXPECT_EQ(f.large_share, 0.75);
  EXPECT_EQ(f.very_large_share, 0.25);
  EXPECT_EQ(f.caps_meet, 0);
  EXPECT_EQ(overlap_figures(beads, contacts, 0.05).capped_share, 0.4);  // beads 2 and 3
}

TEST(MostOverlapped, ComeFirst) {
  const auto [beads, contacts] = row();
  const auto worst = most_overlapped(bead_overlaps(beads, contacts), 3);
  ASSERT_EQ(worst.size(), 3U);
  EXPECT_EQ(worst[0].id, 2);  // as much as bead 3, which has the higher id
  EXPECT_EQ(worst[1].id, 3);
  EXPECT_EQ(worst[2].id, 1);
  EXPECT_EQ(worst[0].x, beads[2].x);
}

TEST(OverlapFigures, OfNothingAreZero) {
  const auto f = overlap_figures({}, {});
  EXPECT_EQ(f.mean, 0.0);
  EXPECT_EQ(f.capped_share, 0.0);
  EXPECT_TRUE(most_overlapped({}, 5).empty());
  const auto beads = triangle(-0.1);
  EXPECT_EQ(bead_overlaps(beads, {})[0].capped, 0.0);
}

TEST(OverlapFigures, NeedTheBeadsOfTheContacts) {
  const auto beads = triangle(0.1);
  const std::vector<ContactForce> contacts = {contact(10, 77, {1, 0, 0}, 1.0)};
  EXPECT_THAT(message_of([&] { (void)bead_overlaps(beads, contacts); }),
              testing::HasSubstr("names bead 77"));
}

}  // namespace
}  // namespace packbed::analysis
