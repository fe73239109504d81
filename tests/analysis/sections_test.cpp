// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/sections.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/spheres.hpp"

namespace packbed::analysis {
namespace {

using namespace packbed::test;  // NOLINT

const auto alone = Ranks::alone();
constexpr double d = 0.3e-3;
constexpr double height = 60 * d;
constexpr double area = 16 * d * d;

std::vector<Bead> bed() { return cubic(d, 4, 4, 60); }

TEST(Sections, StartEqualAndUncompressed) {
  const auto beads = bed();
  const auto reference = section_reference(beads, height, {}, alone);

  const auto rows = sections(reference, beads, height, area, alone);

  ASSERT_EQ(rows.size(), 7U);
  double solid = 0.0;
  for (const auto& row : rows) {
    EXPECT_NEAR(row.height, height / 7.0, 1e-15);
    EXPECT_NEAR(row.compression, 0.0, 1e-12);
    solid += row.packing_density * row.height * area;
  }
  EXPECT_NEAR(solid / total_volume(beads), 1.0, 1e-12);
}

TEST(Sections, CountFromTheTop) {
  const auto beads = bed();
  const auto rows =
      sections(section_reference(beads, height, {.count = 3}, alone), beads, height, area, alone);

  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows.front().section, 1);
  EXPECT_EQ(rows.front().z_top, height);
  EXPECT_EQ(rows.back().section, 3);
  EXPECT_EQ(rows.back().z_bottom, 0.0);
}

// The reference stands for what a checkpoint restores: plain numbers, beads in another order.
TEST(Sections, FollowAnAffineCompressionExactly) {
  auto beads = bed();
  const auto reference = section_reference(beads, height, {}, alone);
  for (auto& b : beads) b.x.z *= 0.8;
  std::ranges::reverse(beads);

  const auto rows = sections(reference, beads, 0.8 * height, area, alone);

  for (const auto& row : rows) EXPECT_NEAR(row.compression, 0.2, 1e-12);
  EXPECT_NEAR(rows[3].packing_density, std::numbers::pi / 6.0 / 0.8, 0.02);
}

// Flow packing: compression grows linearly from 0 at the top to 0.2 at the floor. z(Z) is quadratic; a section
// has the mean compression of its two ends, up to the curvature within the reach of the tracers.
TEST(Sections, FollowACompressionThatGrowsDownwards) {
  auto beads = bed();
  const auto reference = section_reference(beads, height, {}, alone);
  const auto z_now = [](double z) { return 0.8 * z + 0.1 * z * z / height; };
  for (auto& b : beads) b.x.z = z_now(b.x.z);

  const auto rows = sections(reference, beads, z_now(height), area, alone);

  for (std::size_t k = 0; k < 7; ++k) {
    EXPECT_NEAR(rows[k].compression, 0.2 * (static_cast<double>(k) + 0.5) / 7.0, 1e-3);
  }
}

TEST(Sections, SayWhatIsWrong) {
  const auto beads = cubic(d, 1, 1, 60);
  EXPECT_THAT(message_of([&] { (void)section_reference(beads, height, {.count = 0}, alone); }),
              testing::HasSubstr("at least 1"));
  EXPECT_THAT(message_of([&] { (void)section_reference(beads, height, {.count = 40}, alone); }),
              testing::HasSubstr("ask for fewer sections"));
  const auto reference = section_reference(beads, height, {}, alone);
  EXPECT_THAT(message_of([&] { (void)sections(reference, {}, height, area, alone); }),
              testing::HasSubstr("sections 1 and 2 has lost its tracer beads"));
}

TEST(Sections, MayBeOne) {
  const auto beads = bed();
  const auto reference = section_reference(beads, height, {.count = 1}, alone);
  EXPECT_TRUE(reference.tracers.empty());
  const auto rows = sections(reference, beads, 0.9 * height, area, alone);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_NEAR(rows[0].compression, 0.1, 1e-14);
}

TEST(DensityStatistics, AreThoseOfTheThesis) {
  const std::vector<Section> now = {{.packing_density = 0.6}, {.packing_density = 0.7}};
  const std::vector<Section> initial = {{.packing_density = 0.6}, {.packing_density = 0.6}};
  EXPECT_NEAR(density_spread(now), 0.05, 1e-15);
  EXPECT_NEAR(density_spread(initial), 0.0, 1e-15);
  EXPECT_NEAR(density_change(now, initial), 0.1 / std::sqrt(2.0), 1e-15);
}

}  // namespace
}  // namespace packbed::analysis
