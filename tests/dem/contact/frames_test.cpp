// SPDX-License-Identifier: BSD-3-Clause
// C9, C10: one oblique collision with friction and rolling, of unequal, spinning beads, seen from other frames.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/beads.hpp"

namespace packbed::dem {
namespace {

using namespace test;  // NOLINT

constexpr double step = 7e-9;
constexpr std::int64_t steps = 1500;  // the contact takes about 1000
constexpr Vec3 boost{3, -2, 5};       // [m/s]

DemOptions rough() { return options(hooke(0.6), step, 0.3, ElasticPlastic{0.2}); }

std::vector<BeadStart> oblique() {
  std::vector<BeadStart> beads = {bead(0, {0, 0, 0}, {0.05, 0.02, -0.01}, 110e-6),
                                  bead(1, {90e-6, 20e-6, 10e-6}, {-0.04, 0.01, 0.02}, 76e-6)};
  beads[0].w = {200, -300, 50};
  beads[1].w = {-100, 150, 400};
  return beads;
}

Snapshot after(const DemOptions& o, const std::vector<BeadStart>& beads) {
  Dem dem(o, beads, {});
  dem.run(steps / 2);
  EXPECT_GT(dem.snapshot().mean_overlap, 0.0);
  dem.run(steps / 2);
  const auto s = dem.snapshot();
  EXPECT_EQ(s.mean_overlap, 0.0);
  return s;
}

/// Rows of a rotation, from a random unit quaternion.
struct Rotation {
  std::array<Vec3, 3> rows;
  Vec3 operator()(const Vec3& a) const {
    return {dot(rows[0], a), dot(rows[1], a), dot(rows[2], a)};
  }
};

Rotation random_rotation(std::uint64_t seed) {
  std::array<double, 4> q{};
  double square = 0.0;
  for (std::uint64_t k = 0; k < 4; ++k) {
    q[k] = uniform(seed, Stream::bead_position, k) - 0.5;
    square += q[k] * q[k];
  }
  for (auto& a : q) a /= std::sqrt(square);
  const auto [w, x, y, z] = q;
  return {{Vec3{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           Vec3{2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           Vec3{2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

void expect_same(const Snapshot& s, const Snapshot& t, const char* what) {
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT(norm(s.v[i] - t.v[i]), 1e-10 * norm(s.v[i])) << what;
    EXPECT_LT(norm(s.w[i] - t.w[i]), 1e-10 * norm(s.w[i])) << what;
  }
}

TEST(Frames, CollisionIsTheSameBoosted) {
  auto moving = oblique();
  for (auto& b : moving) b.v += boost;
  auto t = after(rough(), moving);
  for (auto& v : t.v) v -= boost;
  expect_same(after(rough(), oblique()), t, "boosted");
}

TEST(Frames, CollisionIsTheSameRotated) {
  const auto plain = after(rough(), oblique());
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const auto turn = random_rotation(seed);
    auto turned = oblique();
    for (auto& b : turned) b.x = turn(b.x), b.v = turn(b.v), b.w = turn(b.w);
    auto expected = plain;
    for (auto& v : expected.v) v = turn(v);
    for (auto& w : expected.w) w = turn(w);
    expect_same(expected, after(rough(), turned), "rotated");
  }
}

// The bead at the origin stands just inside the upper corner, the other, across three sides, at the lower.
TEST(Frames, CollisionIsTheSameAcrossPeriodicSides) {
  const double side = 1e-3;
  const auto plain = after(rough(), oblique());
  for (const Vec3 corner : {Vec3{side, 0.5 * side, 0.5 * side}, Vec3{side, side, side}}) {
    auto o = rough();
    o.domain = {.low = {}, .size = {side, side, side}, .periodic = {true, true, true}};
    auto split = oblique();
    for (auto& b : split) b.x += corner - Vec3{1e-6, 1e-6, 1e-6};
    expect_same(plain, after(o, split), "across");
  }
}

// Beads stand in order of place, so a mirrored pair has i and j exchanged: the same bits.
TEST(Frames, ExchangingTheBeadsMirrorsEveryBit) {
  auto mirrored = oblique();
  for (auto& b : mirrored) b.x = -b.x, b.v = -b.v;  // spins are the same in a point mirror
  const auto s = after(rough(), oblique());
  const auto t = after(rough(), mirrored);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(s.v[i], -t.v[i]);
    EXPECT_EQ(s.w[i], t.w[i]);
    EXPECT_EQ(s.x[i], -t.x[i]);
  }
}

// C9: 1e5 steps within one contact.
TEST(Frames, MomentaAreKeptOverManySteps) {
  auto o = rough();
  o.step = 5e-11;
  const auto beads = oblique();
  Dem dem(o, beads, {});
  const auto sums = [&] {
    const auto s = dem.snapshot();
    Vec3 p;
    Vec3 l;
    for (std::size_t i = 0; i < 2; ++i) {
      const auto& b = beads[i].properties;
      p += b.mass * s.v[i];
      l += b.mass * cross(s.x[i], s.v[i]) + (0.1 * b.mass * b.diameter * b.diameter) * s.w[i];
    }
    return std::pair(p, l);
  };
  const auto [p0, l0] = sums();
  dem.run(100000);
  EXPECT_GT(dem.snapshot().mean_overlap, 0.0);
  const auto [p1, l1] = sums();
  EXPECT_LT(norm(p1 - p0) / norm(p0), 1e-12);
  EXPECT_LT(norm(l1 - l0) / norm(l0), 1e-12);
}

}  // namespace
}  // namespace packbed::dem
