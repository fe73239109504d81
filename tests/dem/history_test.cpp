// SPDX-License-Identifier: BSD-3-Clause
// T9: the tangential spring along a path that is pressed, slid, held, slid back, parted and touched
// again. A fixed bead and a wall that moves: no force changes the path.
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "tests/support/beads.hpp"

namespace packbed::dem {
namespace {

using namespace test;  // NOLINT

constexpr double mu = 0.3;
constexpr double dt = 1e-8;
constexpr double overlap = 1e-7;  // [m]; the spring breaks at mu times this, k_t = k_n

/// Bead on a floor that slides along x, elastic, so that F_t = k_t s and F_n = k_n overlap.
class Path {
 public:
  explicit Path(double skin) : dem_(make(skin)) {}

  /// Moves the floor by s along x in steps of at most 1e-10 m.
  void slide(double s) { move({s, 0, 0}); }
  void lift(double s) { move({0, 0, s}); }
  void hold() { dem_.run(100); }
  [[nodiscard]] Vec3 force() const { return dem_.snapshot().force[0]; }
  [[nodiscard]] double k() const { return dem_.wall_contacts()[0][0].coefficients.a; }
  [[nodiscard]] Vec3 spring() const { return dem_.wall_contacts()[0][0].history.spring; }
  [[nodiscard]] std::int64_t renewals() const { return dem_.renewals(); }
  [[nodiscard]] std::size_t listed() const { return dem_.wall_contacts()[0].size(); }

 private:
  static Dem make(double skin) {
    auto b = bead(0, {0, 0, 0.5 * diameter_s - overlap});
    b.properties.fixed = true;
    auto o = options(hooke(1.0), dt, mu);
    o.skin = skin;
    return {o, {b}, {floor_at(0, mu)}};
  }
  void move(const Vec3& by) {
    const double steps = std::ceil(norm(by) / 1e-10);
    dem_.walls()[0].velocity = (1.0 / (steps * dt)) * by;
    dem_.run(static_cast<std::int64_t>(steps));
    dem_.walls()[0].velocity = {};
  }

  Dem dem_;
};

TEST(TangentialSpring, FollowsItsClosedPath) {
  Path path(0.0);
  const double k = path.k();
  const double most = mu * overlap;
  const double f_n = k * overlap;
  const auto expect = [&](double f_t, const char* what) {
    EXPECT_NEAR(path.force().x / f_n, f_t / f_n, 1e-12) << what;
    EXPECT_NEAR(path.force().z / f_n, 1.0, 1e-9) << what;  // the floor's height is a sum of steps
  };
  expect(0.0, "pressed");
  path.slide(0.3 * most);
  expect(0.3 * k * most, "slid by 0.3");
  path.hold();
  expect(0.3 * k * most, "held");
  path.slide(-0.3 * most);
  expect(0.0, "slid back");
  path.slide(2.5 * most);
  expect(mu * f_n, "slid beyond the limit");
  path.slide(-0.5 * most);
  expect(0.5 * mu * f_n, "back by half");
  path.slide(-1.5 * most);
  expect(-mu * f_n, "the limit on the other side");
}

TEST(TangentialSpring, IsForgottenApart) {
  Path path(0.0);
  path.slide(0.7 * mu * overlap);
  path.lift(-1.5 * overlap);
  EXPECT_EQ(path.force(), Vec3{});
  ASSERT_EQ(path.listed(), 1U);
  EXPECT_EQ(path.spring(), Vec3{});
  path.lift(1.5 * overlap);
  EXPECT_NEAR(path.force().x, 0.0, 1e-15 * path.k() * overlap);
  EXPECT_NEAR(path.force().z / (path.k() * overlap), 1.0, 1e-9);
}

template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

TEST(TangentialSpring, KeepsEveryBitOverRenewals) {
  Path often(1e-9);
  Path never(1e-5);
  for (const double s : {0.4, -0.2, 1.7, -0.6}) {
    often.slide(s * mu * overlap);
    never.slide(s * mu * overlap);
    EXPECT_TRUE(same_bits(often.force(), never.force()));
    EXPECT_TRUE(same_bits(often.spring(), never.spring()));
  }
  EXPECT_GT(often.renewals(), never.renewals() + 20);
}

// The same for a pair that collides and changes its order in the list: sums of one term have no order.
TEST(TangentialSpring, OfAPairKeepsEveryBitOverRenewals) {
  const auto after = [](double skin) {
    auto o = options(hooke(0.8), 5e-9, mu, ElasticPlastic{0.2});
    o.skin = skin;
    std::vector<BeadStart> beads = {bead(0, {0, 0, 0}, {0.02, 0.9, 0.01}),
                                    bead(1, {86e-6, 5e-6, 3e-6}, {-0.03, 0, 0})};
    beads[0].w = {100, -300, 50};
    Dem dem(o, beads, {});
    dem.run(600);
    EXPECT_GT(dem.snapshot().mean_overlap, 0.0);
    return std::pair(dem.contacts().pair(0).history, dem.renewals());
  };
  const auto [often, many] = after(2e-9);
  const auto [seldom, few] = after(2e-5);
  EXPECT_TRUE(same_bits(often.spring, seldom.spring));
  EXPECT_TRUE(same_bits(often.angle, seldom.angle));
  EXPECT_GT(many, few + 20);
}

}  // namespace
}  // namespace packbed::dem
