// SPDX-License-Identifier: BSD-3-Clause
#include "dem/state.hpp"

#include <algorithm>
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/beads.hpp"

namespace packbed::dem {
namespace {

using namespace test;  // NOLINT

/// Beads of 60 to 110 um thrown about in a periodic slice under a moving lid, with friction.
std::vector<BeadStart> thrown(int count) {
  std::vector<BeadStart> beads;
  for (int k = 0; k < count; ++k) {
    const auto u = [&](std::uint64_t n) {
      return uniform(5, Stream::bead_position, 10U * static_cast<std::uint64_t>(k) + n);
    };
    const Vec3 x{(k % 5 + 0.5) * 120e-6, (k / 5 % 3 + 0.5) * 120e-6, (k / 15 + 0.5) * 120e-6};
    const Vec3 v{u(0) - 0.5, u(1) - 0.5, u(2) - 1.0};
    beads.push_back(with_weight(bead(k, x, v, (60 + 50 * u(3)) * 1e-6), 3000.0));
  }
  return beads;
}

DemOptions options_of_slice() {
  auto o = options(hooke(0.6, false), 2e-7, 0.3, ElasticPlastic{0.2});
  o.domain = {.low = {0, 0, 0}, .size = {600e-6, 360e-6, 1.0}, .periodic = {true, true, false}};
  o.background_damping = 10.0;
  return o;
}

Dem slice(int count = 150) {
  Wall lid = floor_at(0, 0.3);
  lid.name = "lid";
  lid.surface = Plane{.point = {0, 0, 1.3e-3}, .normal = {0, 0, -1}};
  lid.velocity = {0, 0, -0.05};
  return {options_of_slice(), thrown(count), {floor_at(0, 0.3), lid}};
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

void expect_same(const Dem& a, const Dem& b) {
  const auto s = a.state();
  const auto t = b.state();
  const auto centers = [](const DemState& state) {
    std::vector<std::array<Vec3, 5>> all;
    for (const auto& bead : state.beads) {
      all.push_back({bead.x, bead.v, bead.w, bead.reference, bead.far_reference});
    }
    return all;
  };
  EXPECT_TRUE(same_bits(centers(s), centers(t)));
  ASSERT_EQ(s.contacts.size(), t.contacts.size());
  for (std::size_t k = 0; k < s.contacts.size(); ++k) {
    EXPECT_EQ(s.contacts[k].id_i, t.contacts[k].id_i);
    EXPECT_EQ(s.contacts[k].history.spring, t.contacts[k].history.spring);
    EXPECT_EQ(s.contacts[k].history.angle, t.contacts[k].history.angle);
  }
  EXPECT_EQ(s.progress.steps, t.progress.steps);
  EXPECT_EQ(s.progress.renewals, t.progress.renewals);
  EXPECT_EQ(s.progress.near_skin, t.progress.near_skin);
  EXPECT_EQ(a.time(), b.time());
  EXPECT_TRUE(same_bits(a.snapshot().force, b.snapshot().force));
}

TEST(DemState, GoesOnWithTheSameBitsFromAnyStep) {
  auto whole_run = slice();
  whole_run.run(2000);
  for (int look = 0; look < 6; ++look) {
    whole_run.run(137);  // between renewals, and just after
    Dem resumed(options_of_slice(), whole_run.state(), Dem::Lists::as_saved);
    expect_same(whole_run, resumed);
    whole_run.run(700);
    resumed.run(700);
    expect_same(whole_run, resumed);
  }
  EXPECT_GT(whole_run.renewals(), 3);
  EXPECT_GT(whole_run.snapshot().coordination_number, 1.0);
}

TEST(DemState, KeepsTheDragOfALiquid) {
  auto dem = slice();
  dem.set_in_liquid(true);
  for (std::size_t i = 0; i < dem.drag().size(); ++i) {
    const auto id = static_cast<double>(dem.particles().properties[i].id);
    dem.drag()[i] = {{1e-3 * id, 0, -0.1}, 1e-6 * (1.0 + id)};
  }
  dem.run(1500);
  for (const auto lists : {Dem::Lists::as_saved, Dem::Lists::anew}) {
    Dem resumed(options_of_slice(), dem.state(), lists);
    for (std::size_t i = 0; i < resumed.drag().size(); ++i) {
      const auto id = static_cast<double>(resumed.particles().properties[i].id);
      EXPECT_EQ(resumed.drag()[i].target, (Vec3{1e-3 * id, 0, -0.1}));
      EXPECT_NE(resumed.coupled_at()[i].x, (Vec3{}));
    }
  }
  Dem resumed(options_of_slice(), dem.state(), Dem::Lists::as_saved);
  dem.run(700);
  resumed.run(700);
  expect_same(dem, resumed);
}

TEST(DemState, KeepsTheStepSizeAndTheTime) {
  auto dem = slice();
  dem.run(1000);
  dem.set_step(1e-7);
  dem.run(501);
  const Dem resumed(options_of_slice(), dem.state(), Dem::Lists::as_saved);
  EXPECT_EQ(resumed.time(), dem.time());
  EXPECT_EQ(resumed.options().step, 1e-7);
}

TEST(DemState, TakesBeadsAwayAndAddsOthersWithoutDisturbingTheRest) {
  auto dem = slice();
  dem.run(3000);
  auto state = dem.state();
  const auto before = dem.snapshot();
  const std::int64_t gone = 149;
  std::erase_if(state.beads, [&](const BeadState& b) { return b.properties.id == gone; });
  std::erase_if(state.contacts,
                [&](const ContactState& c) { return c.id_i == gone || c.id_j == gone; });
  std::erase_if(state.wall_contacts, [&](const WallContactState& c) { return c.id == gone; });
  BeadState extra{.properties = bead(500, {}, {}, 50e-6).properties,
                  .x = before.x[static_cast<std::size_t>(gone)],
                  .v = {},
                  .w = {},
                  .reference = {},
                  .far_reference = {},
                  .drag = {},
                  .coupled_at = {}};
  state.beads.push_back(extra);
  const Dem edited(options_of_slice(), state, Dem::Lists::anew);

  const auto after = edited.snapshot();
  ASSERT_EQ(after.x.size(), 150U);
  EXPECT_EQ(edited.bead_count(), 150);
  EXPECT_EQ(after.x.back(), extra.x);
  EXPECT_EQ(after.x[20], before.x[20]);
  int unchanged = 0;  // all but the neighbors of the bead that is gone
  for (std::size_t i = 0; i < 149; ++i) {
    if (norm(after.force[i] - before.force[i]) <= 1e-12 * norm(before.force[i])) ++unchanged;
  }
  EXPECT_GE(unchanged, 149 - 12);
}

TEST(TouchingContacts, AddUpToTheForcesOfTheBeads) {
  auto dem = slice();
  dem.run(4000);
  const auto s = dem.snapshot();
  std::vector<Vec3> sums(s.x.size());
  int walls = 0;
  for (const auto& c : dem.touching_contacts()) {
    const Vec3 force = c.normal + c.tangential;
    sums[static_cast<std::size_t>(c.id_i)] += force;
    if (c.id_j >= 0) sums[static_cast<std::size_t>(c.id_j)] -= force;
    walls += c.id_j < 0 ? 1 : 0;
    const double r_i = 0.5 * thrown(150)[static_cast<std::size_t>(c.id_i)].properties.diameter;
    if (c.id_j < 0) {
      EXPECT_NEAR(norm(c.branch) + c.overlap, r_i, 1e-15);
    } else {
      const double r_j = 0.5 * thrown(150)[static_cast<std::size_t>(c.id_j)].properties.diameter;
      EXPECT_NEAR(norm(c.branch) + c.overlap, r_i + r_j, 1e-15);
    }
  }
  EXPECT_GT(walls, 3);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    EXPECT_LE(norm(sums[i] - s.force[i]), 1e-10 * (norm(s.force[i]) + s.mean_contact_force)) << i;
  }
}

TEST(DemState, SettersActFromTheNextStepOn) {
  auto dem = slice();
  dem.run(500);
  const auto weight_of = [](const BeadProperties& b) { return 2.0 * b.mass; };
  dem.set_weights(weight_of);
  dem.set_friction(0.0);
  dem.set_inertia_scale(4.0);
  const auto s = dem.state();
  EXPECT_EQ(s.beads[3].properties.weight, weight_of(s.beads[3].properties));
  EXPECT_EQ(s.progress.friction, 0.0);
  EXPECT_EQ(dem.particles().motion[3].inv_mass, 1.0 / (4.0 * s.beads[3].properties.mass));
  const Dem resumed(options_of_slice(), s, Dem::Lists::as_saved);
  EXPECT_EQ(resumed.particles().motion[3].inv_mass, dem.particles().motion[3].inv_mass);
  EXPECT_TRUE(same_bits(resumed.snapshot().force, dem.snapshot().force));
}

TEST(DemState, HoldsAnInertiaThatIsScaledBySize) {
  auto dem = slice();
  dem.set_inertia({.scale = 50.0, .diameter = 1.1 * diameter_s});
  dem.run(300);
  const auto s = dem.state();
  Dem resumed(options_of_slice(), s, Dem::Lists::as_saved);
  EXPECT_EQ(resumed.particles().motion[3].inv_mass, dem.particles().motion[3].inv_mass);
  dem.run(300);
  resumed.run(300);
  EXPECT_TRUE(same_bits(resumed.snapshot().x, dem.snapshot().x));
  EXPECT_TRUE(same_bits(resumed.snapshot().v, dem.snapshot().v));
}

}  // namespace
}  // namespace packbed::dem
