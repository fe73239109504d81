// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/tap.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/settling.hpp"

namespace packbed::column {
namespace {

using namespace test;  // NOLINT

TEST(Tap, HasTheStrengthOfItsSine) {
  TapOptions options;
  options.amplitude = 1e-3;
  options.frequency = 30.0;
  EXPECT_NEAR(tap_strength(options), 1e-3 * 188.4956 * 188.4956 / 9.81, 1e-4);
}

TEST(Tap, MakesALooseBedDenser) {
  auto s = cloud_of(300, 0.5);
  s.options.liquid_density = 0.0;
  Settle settle(s.options, s.start);
  while (settle.advance(s.dem)) {}
  const auto loose = settle.state();
  Tap tap({.amplitude = 0.15e-3,
           .frequency = 100.0,
           .count = 4,
           .area = 2e-3 * 0.7e-3,
           .stepping = s.options.stepping,
           .slice = 200});
  const double start = s.dem.time();
  while (tap.advance(s.dem)) {}
  const auto end = tap.state();
  EXPECT_EQ(end.taps, 4);
  EXPECT_GT(s.dem.time() - start, 4 * 0.01);
  EXPECT_LT(end.unbalanced, 1e-6);
  EXPECT_LT(end.porosity, loose.porosity - 0.005);
  EXPECT_LT(end.bed_height, loose.bed_height);
  // The weights are what they were.
  const auto& bead = s.dem.particles().properties[0];
  EXPECT_NEAR(bead.weight, bead.mass * 9.81, 1e-12 * bead.weight);
}

}  // namespace
}  // namespace packbed::column
