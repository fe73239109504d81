// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/coordination.hpp"

#include <gtest/gtest.h>

#include "tests/support/beads.hpp"

namespace packbed::analysis {
namespace {

using namespace packbed::test;  // NOLINT

/// Everybody touches everybody.
std::vector<TouchingPair> clique(std::int64_t first, std::int64_t count) {
  std::vector<TouchingPair> pairs;
  for (std::int64_t i = 0; i < count; ++i) {
    for (std::int64_t j = 0; j < i; ++j) pairs.push_back({first + i, first + j});
  }
  return pairs;
}

TEST(Coordination, CountsContactsPerBead) {
  const auto c = coordination(clique(100, 5), 5);
  EXPECT_DOUBLE_EQ(c.mean, 4.0);
  EXPECT_DOUBLE_EQ(c.mean_without_rattlers, 4.0);
  EXPECT_EQ(c.rattlers, 0);
}

// Five beads hold each other; a chain of two hangs on them, and a bead touches nobody.
TEST(Coordination, TakesRattlersAwayOneAfterTheOther) {
  auto pairs = clique(0, 5);
  pairs.push_back({5, 0});
  pairs.push_back({5, 6});

  const auto c = coordination(pairs, 8);

  EXPECT_DOUBLE_EQ(c.mean, 2.0 * 12.0 / 8.0);
  EXPECT_DOUBLE_EQ(c.mean_without_rattlers, 4.0);
  EXPECT_EQ(c.rattlers, 3);
}

// Four beads that touch each other have three contacts each: none bears load alone, all do on the floor.
TEST(Coordination, CountsWallsAsSupportOnly) {
  auto pairs = clique(0, 4);
  EXPECT_EQ(coordination(pairs, 4).rattlers, 4);
  EXPECT_EQ(coordination(pairs, 4).mean_without_rattlers, 0.0);

  for (std::int64_t k = 0; k < 4; ++k) pairs.push_back({k, wall_id});

  const auto c = coordination(pairs, 4);
  EXPECT_EQ(c.rattlers, 0);
  EXPECT_DOUBLE_EQ(c.mean, 3.0);
  EXPECT_DOUBLE_EQ(c.mean_without_rattlers, 3.0);
}

// A ring of four beads, a fifth that hangs on the first: with friction the ring stands, and the fifth rattles.
TEST(Coordination, TwoContactsHoldWithFriction) {
  const std::vector<TouchingPair> pairs = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}};

  EXPECT_EQ(coordination(pairs, 5).rattlers, 5);
  const auto c = coordination(pairs, 5, holding_with_friction);
  EXPECT_EQ(c.rattlers, 1);
  EXPECT_DOUBLE_EQ(c.mean, 2.0);
  EXPECT_DOUBLE_EQ(c.mean_without_rattlers, 2.0);
}

TEST(Coordination, OfNothingIsNothing) {
  const auto c = coordination({}, 3);
  EXPECT_EQ(c.mean, 0.0);
  EXPECT_EQ(c.rattlers, 3);
  EXPECT_EQ(coordination({}, 0).mean, 0.0);
}

// A row of three beads that overlap a little, the first through a periodic side with the last, on a floor that
// two of them touch.
TEST(TouchingPairs, AreThoseOfTheDem) {
  const double pitch = 0.99 * diameter_s;
  auto o = options(hooke(0.5), 1e-9);
  o.domain = {.low = {0, -1, -1}, .size = {3 * pitch, 2, 2}, .periodic = {true, false, false}};
  const double r = 0.5 * diameter_s;
  const std::vector<dem::BeadStart> beads = {bead(7, {0.5 * pitch, 0, 0.999 * r}),
                                             bead(8, {1.5 * pitch, 0, 1.01 * r}),
                                             bead(9, {2.5 * pitch, 0, 0.999 * r})};
  const dem::Dem dem(o, beads, {floor_at(0)});

  const auto pairs = touching_pairs(dem);

  std::int64_t walls = 0;
  for (const auto& p : pairs) walls += p.j == wall_id ? 1 : 0;
  EXPECT_EQ(walls, 2);
  EXPECT_EQ(pairs.size(), 5U);
  EXPECT_DOUBLE_EQ(coordination(pairs, 3).mean, dem.snapshot().coordination_number);
}

}  // namespace
}  // namespace packbed::analysis
