// SPDX-License-Identifier: BSD-3-Clause
// Pairs against brute force, and what happens to springs at renewals. I-numbers: docs/verification.md.
#include "dem/neighbors.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "dem/leapfrog.hpp"
#include "tests/support/beads.hpp"

namespace packbed::dem {
namespace {

using namespace test;  // NOLINT

constexpr double side = 1e-3;

Domain box(bool x, bool y, bool z) {
  return {.low = {0, 0, 0}, .size = {side, side, side}, .periodic = {x, y, z}};
}

/// Beads anywhere in the box, diameters 15 to 150 um, speeds up to `speed`.
std::vector<BeadStart> random_beads(int count, double speed) {
  std::vector<BeadStart> beads;
  std::uint64_t k = 0;
  const auto next = [&] { return uniform(3, Stream::bead_position, k++); };
  for (int i = 0; i < count; ++i) {
    const Vec3 x{side * next(), side * next(), side * next()};
    const Vec3 v{speed * (next() - 0.5), speed * (next() - 0.5), speed * (next() - 0.5)};
    beads.push_back(bead(i, x, v, 15e-6 * std::pow(10.0, next())));
  }
  return beads;
}

using Key = std::tuple<std::int32_t, std::int32_t, Image>;

/// `most_turns` around a periodic side: 1 where beads stand inside the box and are small against it.
std::set<Key> brute_force(const Particles& p,
                          const Domain& domain,
                          double skin,
                          int most_turns = 2) {
  std::set<Key> pairs;
  const auto turns = [&](int axis) {
    return domain.periodic[static_cast<std::size_t>(axis)] ? most_turns : 0;
  };
  for (int a = -turns(0); a <= turns(0); ++a) {
    for (int b = -turns(1); b <= turns(1); ++b) {
      for (int c = -turns(2); c <= turns(2); ++c) {
        const Image image{static_cast<std::int8_t>(a), static_cast<std::int8_t>(b),
                          static_cast<std::int8_t>(c)};
        for (std::size_t i = 0; i < p.size(); ++i) {
          for (std::size_t j = i + 1; j < p.size(); ++j) {
            const Vec3 d = p.motion[i].x - p.motion[j].x - offset(domain, image);
            if (norm(d) >= p.radius(i) + p.radius(j) + skin) continue;
            pairs.insert({static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), image});
          }
        }
      }
    }
  }
  return pairs;
}

std::set<Key> found(const Particles& p, const Domain& domain, double skin) {
  std::set<Key> pairs;
  const auto listed = find_pairs(p, domain, skin);
  for (const auto& pair : listed) pairs.insert({pair.i, pair.j, pair.image});
  EXPECT_EQ(pairs.size(), listed.size());  // none twice
  return pairs;
}

// I5, in boxes with and without periodic sides.
TEST(FindPairs, AgreesWithBruteForceAtASizeRatioOfTen) {
  for (const auto& domain :
       {box(false, false, false), box(true, false, true), box(true, true, true)}) {
    const auto p = make_particles(random_beads(400, 0.0), {});
    for (const double skin : {0.0, 5e-6, 80e-6}) {
      const auto expected = brute_force(p, domain, skin);
      EXPECT_EQ(found(p, domain, skin), expected) << expected.size();
    }
  }
}

// I5 in full: 2000 beads, without and with a large skin.
TEST(FindPairs, AgreesWithBruteForceForTwoThousandBeads) {
  const auto domain = box(true, true, true);
  const auto p = make_particles(random_beads(2000, 0.0), {});
  const auto touching = brute_force(p, domain, 0.0, 1);
  EXPECT_EQ(found(p, domain, 0.0), touching);
  EXPECT_EQ(found(p, domain, 30e-6), brute_force(p, domain, 30e-6, 1));
  EXPECT_GT(touching.size(), 1000U);
}

// A slice between one and two diameters thick: a bead may touch two images of another.
TEST(FindPairs, TellsImagesApartInAThinSlice) {
  Domain slice = box(false, true, false);
  slice.size[1] = 100e-6;
  const auto p =
      make_particles(std::vector{bead(0, {0, 10e-6, 0}), bead(1, {60e-6, 60e-6, 0})}, {});
  EXPECT_EQ(found(p, slice, 0.0).size(), 2U);
  EXPECT_EQ(found(p, slice, 0.0), brute_force(p, slice, 0.0));
  EXPECT_EQ(found(p, slice, 40e-6), brute_force(p, slice, 40e-6));
}

TEST(FindPairs, OfFewBeadsIsEmpty) {
  EXPECT_TRUE(found(make_particles({}, {}), box(false, false, false), 1e-6).empty());
  EXPECT_TRUE(
      found(make_particles(std::vector{bead(0, {})}, {}), box(true, true, true), 1e-6).empty());
}

// I5, second half: the renewal never comes late, with a wide and a narrow skin, for fast movers.
TEST(Renewal, NeverMissesAContact) {
  for (const double skin : {1e-6, 30e-6}) {
    auto o = options(HertzMindlin{.restitution = 0.5}, 2e-8, 0.3, ElasticPlastic{0.3});
    o.domain = box(true, true, true);
    o.skin = skin;
    o.overlap_limit = 10.0;  // beads start anywhere
    Dem dem(o, random_beads(120, 5.0), {});
    for (int look = 0; look < 250; ++look) {
      dem.run(look % 10 == 0 ? 10 : 1);
      std::set<Key> listed;
      for (const auto& c : dem.contacts().pairs()) listed.insert({c.i, c.j, c.image});
      const auto touching = brute_force(dem.particles(), o.domain, 0.0, 1);
      EXPECT_TRUE(std::ranges::includes(listed, touching));
    }
    EXPECT_GT(dem.renewals(), 3);
  }
}

/// Final state of a bed that is stirred, with a given skin.
Snapshot stirred(double skin) {
  auto o = options(hooke(0.5, false), 2e-8, 0.3, ElasticPlastic{0.3});
  o.domain = box(true, true, false);
  o.skin = skin;
  o.overlap_limit = 10.0;
  Dem dem(o, random_beads(60, 0.2), {floor_at(0.0, 0.3)});
  dem.run(3000);
  return dem.snapshot();
}

// T9 and the renewal: springs survive it. The order of sums changes with the renewals, so beads agree
// to rounding, which collisions let grow.
TEST(Renewal, DoesNotChangeTheMotion) {
  const auto often = stirred(0.2e-6);
  const auto seldom = stirred(20e-6);
  for (std::size_t i = 0; i < often.x.size(); ++i) {
    EXPECT_LT(norm(often.x[i] - seldom.x[i]), 1e-11) << i;
  }
}

TEST(CarryOver, TurnsThePairAroundWhenTheOrderOfItsBeadsChanges) {
  PairContact old;
  old.i = 0;
  old.j = 1;
  old.image = {1, 0, -1};
  old.coefficients.a = 7.0;
  old.history.spring = {1, 2, 3};

  ContactList list({old}, box(true, true, true), 2);
  const auto pairs = carry_over(list, {1, 0}, {Image{1, 0, 0}, Image{0, 0, 0}});

  // bead 0 was moved by +1 in x, bead 1 not: 1 + 1 = 2, seen from the other end
  const PairKey key{.i = 0, .j = 1, .image = {-2, 0, 1}};
  EXPECT_EQ(static_cast<PairKey>(pairs.at(0)), key);
  PairContact now;
  ASSERT_TRUE(OldContacts(list, pairs, {}).take(key, now));
  EXPECT_EQ(static_cast<PairKey>(now), key);
  EXPECT_EQ(now.coefficients.a, 7.0);
  EXPECT_EQ(now.history.spring, (Vec3{-1, -2, -3}));
}

TEST(ContactList, GivesItsPairsBack) {
  const auto p = make_particles(random_beads(200, 0.0), {});
  std::vector<PairContact> pairs;
  for (const auto& key : find_pairs(p, box(true, true, true), 10e-6))
    pairs.push_back({key, {}, {}});
  for (std::size_t k = 0; k < pairs.size(); ++k) pairs[k].history.angle.x = static_cast<double>(k);

  const ContactList list(pairs, box(true, true, true), 200);

  const auto back = list.pairs();
  ASSERT_EQ(back.size(), pairs.size());
  for (std::size_t k = 0; k < back.size(); ++k) {
    EXPECT_EQ(std::tuple(back[k].i, back[k].j, back[k].image, back[k].history.angle.x),
              std::tuple(pairs[k].i, pairs[k].j, pairs[k].image, static_cast<double>(k)));
  }
}

// Where blocks begin must not change a bit: 0 to 31 dummy pairs in front of the list.
TEST(ContactForces, DoNotDependOnWhereBlocksBegin) {
  const auto domain = box(true, true, true);
  auto start = make_particles(random_beads(300, 1.0), {});
  std::vector<PairContact> pairs;
  for (const auto& key : find_pairs(start, domain, 1e-6)) {
    pairs.push_back(
        {key, {.a = 30.0, .b = 1e-5, .c = 0.0}, {.spring = {1e-9, 2e-9, -1e-9}, .angle = {}}});
  }
  const Hooke law = hooke(0.5, false);
  const ContactModel model{.contact = law, .rolling = ElasticPlastic{0.2}, .friction = 0.3};
  std::vector<Load> expected;
  for (int front = 0; front < lanes; ++front) {
    PairContact dummy;
    dummy.i = 300;
    dummy.j = 301;
    auto shifted = pairs;
    shifted.insert(shifted.begin(), static_cast<std::size_t>(front), dummy);
    ContactList list(shifted, domain, 300);
    auto particles = start;
    add_contact_forces(model, list, particles, 1e-8);
    std::vector<Load> loads(particles.load.begin(), particles.load.begin() + 300);
    if (front == 0) expected = loads;
    EXPECT_EQ(std::memcmp(loads.data(), expected.data(), loads.size() * sizeof(Load)), 0) << front;
  }
}

// The same on a bed that moves: 200 steps with the same list, springs and rolling springs carried along.
TEST(ContactForces, OfAMovingBedDoNotDependOnWhereBlocksBegin) {
  const auto domain = box(true, true, true);
  const auto start = make_particles(random_beads(300, 0.2), {});
  const Hooke law = hooke(0.5, false);
  const ContactModel model{.contact = law, .rolling = ElasticPlastic{0.2}, .friction = 0.3};
  std::vector<PairContact> pairs;
  for (const auto& key : find_pairs(start, domain, 1e-6)) {
    pairs.push_back({key, {.a = 30.0, .b = 1e-5, .c = 0.0}, {}});
  }
  const auto moved = [&](int front) {
    PairContact dummy;
    dummy.i = 300;
    dummy.j = 301;
    auto shifted = pairs;
    shifted.insert(shifted.begin(), static_cast<std::size_t>(front), dummy);
    ContactList list(shifted, domain, 300);
    auto particles = start;
    constexpr double dt = 2e-9;
    for (int n = 0; n < 200; ++n) {
      add_contact_forces(model, list, particles, dt);
      (void)move_beads(particles, 0, 300,
                       {.kick = n == 0 ? 0.5 * dt : dt, .drift = dt, .damping = 0.0});
    }
    std::vector<Vec3> bits;
    for (std::size_t i = 0; i < 300; ++i) {
      bits.insert(bits.end(), {particles.motion[i].x, particles.motion[i].v, particles.spin[i].w});
    }
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto c = list.pair(k + static_cast<std::size_t>(front));
      bits.insert(bits.end(), {c.history.spring, c.history.angle});
    }
    return bits;
  };
  const auto expected = moved(0);
  EXPECT_GT(norm(expected[902]), 0.0);
  for (int front = 1; front < lanes; ++front) {
    const auto bits = moved(front);
    EXPECT_EQ(std::memcmp(bits.data(), expected.data(), bits.size() * sizeof(Vec3)), 0) << front;
  }
}

// Two lists: what is listed near may be fewer than what the skin takes in, and never misses a touch.
TEST(Renewal, NarrowsTheListOfBeadsAtRest) {
  std::vector<BeadStart> beads;
  for (int i = 0; i < 10; ++i) beads.push_back(bead(i, {i * (diameter_s + 0.3e-6), 0, 0}));
  auto o = options(hooke(0.5), 1e-7);
  o.skin = 10e-6;
  Dem dem(o, beads, {});
  dem.run(1);
  EXPECT_EQ(dem.contacts().size(), 9U);
  dem.run(1000);
  EXPECT_EQ(dem.contacts().size(), 0U);
  EXPECT_EQ(dem.renewals(), 1);
}

}  // namespace
}  // namespace packbed::dem
