// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/force_distribution.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "tests/support/contacts.hpp"

namespace packbed::analysis {
namespace {

using namespace packbed::test;  // NOLINT

/// Forces 1, 2, 3 and 6 along a row of beads, a wall and a contact that pulls.
std::vector<ContactForce> row() {
  std::vector<ContactForce> all = {
      contact(0, 1, {1, 0, 0}, 1.0),    contact(1, 2, {1, 0, 0}, 6.0),
      contact(2, 3, {1, 0, 0}, 2.0),    contact(3, 4, {1, 0, 0}, 3.0),
      contact(4, -1, {1, 0, 0}, 100.0), contact(0, 5, {0, 1, 0}, -1.0)};
  for (auto& c : all) c.tangential = c.normal > 3.0 ? 0.1 * c.normal : 0.3 * c.normal;
  return all;
}

double integral(const ForceDistribution& d) {
  double sum = 0.0;
  for (std::size_t k = 0; k < d.density.size(); ++k) {
    sum += d.density[k] * (d.edges[k + 1] - d.edges[k]);
  }
  return sum;
}

TEST(ForceDistribution, CountsForcesOverTheirMean) {
  const auto d = force_distribution(row(), {.width = 0.5, .high = 1.75});

  EXPECT_EQ(d.contacts, 4);
  EXPECT_EQ(d.not_pushing, 1);
  EXPECT_EQ(d.mean, 3.0);
  EXPECT_EQ(d.largest, 2.0);
  EXPECT_EQ(d.edges, (std::vector<double>{0.0, 0.5, 1.0, 1.5, 1.75}));
  EXPECT_EQ(d.counts, (std::vector<std::int64_t>{1, 1, 1, 0}));
  EXPECT_EQ(d.density[0], 0.5);
  EXPECT_EQ(d.beyond, 1);
}

TEST(ForceDistribution, HasTheIntegralOne) {
  const auto contacts = even_contacts(5000, [](double u) { return -1e-6 * std::log(u); });
  const auto d = force_distribution(contacts);
  EXPECT_EQ(d.counts.size(), 40U);
  EXPECT_NEAR(integral(d) + static_cast<double>(d.beyond) / 5000.0, 1.0, 1e-12);
  EXPECT_NEAR(d.density[4], (std::exp(-1.0) - std::exp(-1.25)) / 0.25, 0.01);
}

TEST(ForceDistribution, KnowsHowManyAreFarAboveTheMean) {
  EXPECT_EQ(share_above(row(), 1.5), 0.25);
  EXPECT_EQ(share_above(row(), 2.0), 0.0);
  const auto contacts = even_contacts(100000, [](double u) { return -std::log(u); });
  EXPECT_NEAR(share_above(contacts, 6.0), std::exp(-6.0), 5e-5);
}

// Forces 1 - 1/b + E / b with E exponential have mean 1 and the tail exp(-b f) from there on.
TEST(ForceTail, FindsTheSlopeOfAnExponential) {
  Draws draw(5);
  for (const double b : {1.0, 1.4, 2.0}) {
    std::vector<ContactForce> contacts;
    contacts.reserve(20000);
    for (int k = 0; k < 20000; ++k) {
      contacts.push_back(contact(k, k + 1, {1, 0, 0}, 3e-6 * (1.0 - (1.0 + std::log(draw())) / b)));
    }
    const auto tail = force_tail(contacts);
    EXPECT_NEAR(static_cast<double>(tail.contacts), 20000.0 * std::exp(-1.0), 250.0);
    EXPECT_NEAR(tail.error, tail.slope / std::sqrt(static_cast<double>(tail.contacts)), 1e-12);
    EXPECT_NEAR(tail.slope, b, 3.0 * tail.error);
  }
}

TEST(ForceNetworks, AreThoseAboveAndBelowTheMean) {
  const auto n = force_networks(row());
  EXPECT_EQ(n.strong_share, 0.25);
  EXPECT_EQ(n.strong_load, 0.5);
  EXPECT_EQ(n.strong_beads, 2);
  EXPECT_EQ(n.strong_coordination, 1.0);
  EXPECT_NEAR(n.strong_mobilized, 0.1, 1e-15);
  EXPECT_NEAR(n.weak_mobilized, 0.3, 1e-15);
}

// Load above the mean of an exponential distribution: integral of f exp(-f) from 1 on, 2/e.
TEST(ForceNetworks, CarryWhatAnExponentialCarries) {
  const auto n = force_networks(even_contacts(100000, [](double u) { return -std::log(u); }));
  EXPECT_NEAR(n.strong_share, std::exp(-1.0), 1e-4);
  EXPECT_NEAR(n.strong_load, 2.0 * std::exp(-1.0), 2e-4);
}

TEST(ForceStatistics, DoNotDependOnOrderOrOnWhoTells) {
  const auto contacts = even_contacts(500, [](double u) { return -std::log(u); });
  const auto others = shuffled(contacts);
  EXPECT_EQ(force_distribution(contacts).counts, force_distribution(others).counts);
  EXPECT_NEAR(force_tail(contacts).slope, force_tail(others).slope, 1e-12);
  EXPECT_NEAR(force_networks(contacts).strong_load, force_networks(others).strong_load, 1e-12);
  EXPECT_EQ(force_networks(contacts).strong_beads, force_networks(others).strong_beads);
}

TEST(ForceStatistics, OfNothingAreZero) {
  const auto d = force_distribution({});
  EXPECT_EQ(d.contacts, 0);
  EXPECT_EQ(d.mean, 0.0);
  EXPECT_EQ(integral(d), 0.0);
  EXPECT_EQ(share_above({}, 6.0), 0.0);
  EXPECT_EQ(force_tail({}).slope, 0.0);
  EXPECT_EQ(force_tail({}).error, 0.0);
  EXPECT_EQ(force_networks({}).strong_load, 0.0);
  EXPECT_EQ(force_networks({}).strong_coordination, 0.0);
  const std::vector<ContactForce> one = {contact(0, 1, {1, 0, 0}, 2.0)};  // none above the mean
  EXPECT_EQ(force_tail(one).slope, 0.0);
  EXPECT_EQ(force_networks(one).strong_coordination, 0.0);
  EXPECT_THROW((void)force_distribution({}, {.width = 0.0}), ValueError);
}

}  // namespace
}  // namespace packbed::analysis
