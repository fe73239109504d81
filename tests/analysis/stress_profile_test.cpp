// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/stress_profile.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "tests/support/contacts.hpp"

namespace packbed::analysis {
namespace {

using namespace packbed::test;  // NOLINT

using testing::DoubleNear;
using testing::Each;

constexpr double area = 3.0;

std::vector<double> axial(const std::vector<StressBin>& bins) {
  std::vector<double> all;
  all.reserve(bins.size());
  for (const auto& bin : bins) all.push_back(bin.axial());
  return all;
}

/// Beads of diameter 1 upon each other between z = 0 and z = count, pressed by F.
std::vector<ContactForce> column(int count, double force) {
  std::vector<ContactForce> all = {contact(0, -1, {0, 0, -0.5}, force, {0, 0, 0.5})};
  for (int k = 0; k + 1 < count; ++k) {
    all.push_back(contact(k, k + 1, {0, 0, 1}, force, {0, 0, k + 0.5}));
  }
  all.push_back(contact(count - 1, -2, {0, 0, 0.5}, force, {0, 0, count - 0.5}));
  return all;
}

TEST(StressProfile, OfASqueezedColumnOfBeadsIsTheForceOverTheArea) {
  const std::vector<double> edges = {0.0, 0.3, 1.7, 1.9, 4.2, 5.0};

  const auto bins = stress_profile(column(5, 6.0), {}, edges, area);

  ASSERT_EQ(bins.size(), 5U);
  EXPECT_THAT(axial(bins), Each(DoubleNear(6.0 / area, 1e-14)));
  EXPECT_EQ(bins[2].lateral(), 0.0);
  EXPECT_EQ(bins[2].lateral_ratio(), 0.0);
  EXPECT_EQ(bins[1].z.high, 1.7);
}

/// A network in equilibrium: chains from the floor to the plunger over beads anywhere. Each contact of a chain hands
/// the same force on, so that no bead feels a net one; part of it is tangential.
struct Network {
  std::vector<ContactForce> contacts;
  std::vector<Vec3> tangential;
  double axial_force = 0.0;
  Symmetric of_walls;  ///< sum over walls of force on the bed and place

  explicit Network(double height) {
    Draws draw(3);
    std::int64_t next = 0;
    for (int chain = 0; chain < 20; ++chain) {
      const Vec3 force{draw(-1, 1), draw(-1, 1), draw(1, 2)};  // on upper bodies
      const auto place = [&](double z) { return Vec3{draw(-2, 2), draw(-2, 2), z}; };
      const Vec3 floor = place(0.0);
      const Vec3 top = place(height);
      Vec3 x = place(draw(0.1, height - 0.1));
      add(next, -1, x, floor - x, -1.0 * force);
      for (int k = 0; k < 5; ++k, ++next) {
        const Vec3 y = place(draw(0.1, height - 0.1));
        add(next, next + 1, x, y - x, force);
        x = y;
      }
      add(next++, -2, x, top - x, force);
      axial_force += force.z;
      of_walls += symmetric_product(force, top - floor);
    }
  }

  void add(std::int64_t i, std::int64_t j, const Vec3& x, const Vec3& branch, const Vec3& on_j) {
    auto c = contact(i, j, branch, 0.0, x);
    const Vec3 n = contact_normal(c);
    c.normal = dot(on_j, n);
    const Vec3 rest = c.normal * n - on_j;
    c.tangential = norm(rest);
    contacts.push_back(c);
    tangential.push_back(rest);
  }
};

TEST(StressProfile, OfANetworkInEquilibriumIsThatOfTheWalls) {
  const double height = 4.0;
  const Network net(height);
  const std::vector<double> whole = {0.0, height};

  const auto s = stress_profile(net.contacts, net.tangential, whole, area)[0].stress;

  const double volume = area * height;
  EXPECT_NEAR(s.xx, net.of_walls.xx / volume, 1e-13);
  EXPECT_NEAR(s.yy, net.of_walls.yy / volume, 1e-13);
  EXPECT_NEAR(s.zz, net.of_walls.zz / volume, 1e-13);
  EXPECT_NEAR(s.xy, net.of_walls.xy / volume, 1e-13);
  EXPECT_NEAR(s.xz, net.of_walls.xz / volume, 1e-13);
  EXPECT_NEAR(s.yz, net.of_walls.yz / volume, 1e-13);
}

TEST(StressProfile, HandsTheAxialForceThroughEverySlab) {
  const Network net(4.0);
  const std::vector<double> edges = {0.0, 0.01, 0.5, 1.3, 2.0, 3.9, 4.0};
  const auto bins = stress_profile(net.contacts, net.tangential, edges, area);
  EXPECT_THAT(axial(bins), Each(DoubleNear(net.axial_force / area, 1e-12)));
}

// A bead on top of four, which stand on the floor and lean on side walls: the legs have 45 degrees.
TEST(StressProfile, HasTheLateralPartOfALeaningFrame) {
  const double load = 4.0;
  const double leg = 0.25 * load * std::numbers::sqrt2;  // force along each leg
  std::vector<ContactForce> contacts = {contact(0, -2, {0, 0, 0.5}, load, {0, 0, 2})};
  const std::vector<Vec3> sides = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const Vec3 foot = sides[k] + Vec3{0, 0, 1};
    const auto id = static_cast<std::int64_t>(k) + 1;
    contacts.push_back(contact(id, 0, Vec3{0, 0, 2} - foot, leg, foot));
    contacts.push_back(contact(id, -1, {0, 0, -1}, 0.25 * load, foot));
    contacts.push_back(contact(id, -3, 0.5 * sides[k], 0.25 * load, foot));
  }
  const std::vector<double> edges = {0.0, 1.0, 2.0, 2.5};

  const auto bins = stress_profile(contacts, {}, edges, area);

  EXPECT_THAT(axial(bins), Each(DoubleNear(load / area, 1e-14)));
  EXPECT_EQ(bins[0].lateral(), 0.0);
  // Legs: 2 of 1 N times 1 m along x; the level contacts at z = 1 lie in the slab above: 2 of 1 N times 0.5 m.
  EXPECT_NEAR(bins[1].stress.xx, 3.0 / area, 1e-14);
  EXPECT_NEAR(bins[1].stress.yy, 3.0 / area, 1e-14);
  EXPECT_NEAR(bins[1].lateral_ratio(), 0.75, 1e-14);
  EXPECT_EQ(bins[2].lateral(), 0.0);
}

TEST(StressProfile, DoesNotDependOnOrderOrOnWhoTells) {
  const Network net(4.0);
  const std::vector<double> edges = {0.0, 1.0, 4.0};
  const auto a = stress_profile(net.contacts, {}, edges, area);
  const auto b = stress_profile(shuffled(net.contacts), {}, edges, area);
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_NEAR(a[k].stress.zz, b[k].stress.zz, 1e-12);
    EXPECT_NEAR(a[k].stress.xy, b[k].stress.xy, 1e-12);
  }
}

TEST(StressProfile, LeavesOutWhatIsBeyondTheEdges) {
  const std::vector<double> edges = {1.0, 2.0};
  EXPECT_NEAR(stress_profile(column(5, 6.0), {}, edges, area)[0].axial(), 6.0 / area, 1e-14);
  const std::vector<double> above = {7.0, 8.0};
  EXPECT_EQ(stress_profile(column(5, 6.0), {}, above, area)[0].axial(), 0.0);
  EXPECT_EQ(stress_profile({}, {}, edges, area)[0].lateral_ratio(), 0.0);
}

TEST(StressProfile, SaysWhatIsWrong) {
  const auto contacts = column(3, 1.0);
  const std::vector<double> edges = {0.0, 1.0};
  const std::vector<double> one = {0.0};
  const std::vector<double> equal = {0.0, 0.0};
  EXPECT_THROW((void)stress_profile(contacts, {}, one, area), ValueError);
  EXPECT_THROW((void)stress_profile(contacts, {}, equal, area), ValueError);
  EXPECT_THROW((void)stress_profile(contacts, {}, edges, 0.0), ValueError);
  const std::vector<Vec3> two(2);
  EXPECT_THROW((void)stress_profile(contacts, two, edges, area), ValueError);
}

}  // namespace
}  // namespace packbed::analysis
