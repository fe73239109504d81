// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/plateau.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace packbed::column {
namespace {

/// A bow that rises from 100 at t = 1 s, up and down around it by turns.
Samples restless(std::size_t count, double rest) {
  Samples s;
  for (std::size_t k = 0; k < count; ++k) {
    const double t = 1.0 + 0.01 * static_cast<double>(k);
    s.add(t, 100.0 + 30.0 * (t - 1.0) - 20.0 * (t - 1.0) * (t - 1.0) + (k % 2 == 0 ? rest : -rest));
  }
  return s;
}

TEST(PressureNoise, IsWhatAParabolaLeaves) {
  EXPECT_NEAR(pressure_noise(restless(100, 0.0), 0.0).value(), 0.0, 1e-14);
  // Alternating values correlate with a parabola by 1 / n only.
  const double mean = 100.0 + 30.0 * 0.01 * 99.0 / 2.0 - 20.0 * 1e-4 * 99.0 * 199.0 / 6.0;
  EXPECT_NEAR(pressure_noise(restless(100, 0.5), 0.0).value(), 0.5 * std::sqrt(100.0 / 97.0) / mean,
              1e-3 * 0.5 / mean);
}

TEST(PressureNoise, BeginsWhereItIsToldAndWantsFiveSamples) {
  auto s = restless(40, 0.0);
  for (std::size_t k = 0; k < 20; ++k) s.value[k] = 1e6;
  EXPECT_NEAR(pressure_noise(s, s.time[20]).value(), 0.0, 1e-14);
  EXPECT_GT(pressure_noise(s, s.time[19]).value(), 0.1);
  EXPECT_TRUE(pressure_noise(s, s.time[35]).has_value());
  EXPECT_FALSE(pressure_noise(s, s.time[36]).has_value());
  EXPECT_FALSE(pressure_noise({}, 0.0).has_value());
}

TEST(PressureNoise, IsNotToldOfNoPressureDrop) {
  Samples s;
  for (int k = 0; k < 10; ++k) s.add(k, 0.0);
  EXPECT_FALSE(pressure_noise(s, 0.0).has_value());
}

}  // namespace
}  // namespace packbed::column
