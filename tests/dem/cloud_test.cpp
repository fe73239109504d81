// SPDX-License-Identifier: BSD-3-Clause
#include "dem/cloud.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/random.hpp"
#include "tests/support/message_of.hpp"

namespace packbed::dem {
namespace {

using namespace test;  // NOLINT
using testing::HasSubstr;

/// Spread like the grains of a resin: 150 to 430 um.
std::vector<double> grains(std::size_t count, std::uint64_t seed = 1) {
  std::vector<double> d(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double u = uniform(seed, Stream::bead_size, k);
    d[k] = 150e-6 + 280e-6 * std::cbrt(u) * u;
  }
  return d;
}

struct Shape {
  std::string name;
  mesh::ColumnShape shape;
  double solid_fraction;  ///< that must be reached
};

std::vector<Shape> shapes() {
  using enum mesh::Boundary;
  return {{"slice", mesh::Slice{4e-3, 0.9e-3, 1.0}, 0.5},
          {"thin slice", mesh::Slice{4e-3, 0.431e-3, 1.0}, 0.5},
          {"periodic", mesh::Box{{2e-3, 2e-3, 1.0}, {periodic, periodic, wall}}, 0.5},
          {"box", mesh::Box{{2e-3, 2e-3, 1.0}, {wall, wall, wall}}, 0.5},
          {"cylinder", mesh::Cylinder{3e-3, 1.0}, 0.5},
          {"narrow cylinder", mesh::Cylinder{0.9e-3, 1.0}, 0.40},
          {"narrow box", mesh::Box{{0.8e-3, 0.8e-3, 1.0}, {wall, wall, wall}}, 0.40}};
}

/// All pairs and images, one by one.
double largest_overlap(const mesh::ColumnShape& shape,
                       const std::vector<Vec3>& x,
                       const std::vector<double>& d) {
  Vec3 period;
  if (const auto* slice = std::get_if<mesh::Slice>(&shape)) period.y = slice->depth;
  if (const auto* box = std::get_if<mesh::Box>(&shape)) {
    if (box->boundaries[0] == mesh::Boundary::periodic) period.x = box->size[0];
    if (box->boundaries[1] == mesh::Boundary::periodic) period.y = box->size[1];
  }
  const int a_last = period.x > 0.0 ? 1 : 0;
  const int b_last = period.y > 0.0 ? 1 : 0;
  double largest = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      for (int a = -a_last; a <= a_last; ++a) {
        for (int b = -b_last; b <= b_last; ++b) {
          if (i == j && a == 0 && b == 0) continue;
          const double distance = norm(x[i] - x[j] - Vec3{a * period.x, b * period.y, 0.0});
          largest = std::max(largest, (0.5 * (d[i] + d[j]) - distance) / std::min(d[i], d[j]));
        }
      }
    }
  }
  return largest;
}

/// How far a bead reaches over a wall [m]; negative inside.
double beyond_walls(const mesh::ColumnShape& shape, const Vec3& x, double d) {
  if (const auto* slice = std::get_if<mesh::Slice>(&shape)) {
    return std::abs(x.x) + 0.5 * d - 0.5 * slice->inner_diameter;
  }
  if (const auto* cylinder = std::get_if<mesh::Cylinder>(&shape)) {
    return std::hypot(x.x, x.y) + 0.5 * d - 0.5 * cylinder->inner_diameter;
  }
  const auto& box = std::get<mesh::Box>(shape);
  if (box.boundaries[0] == mesh::Boundary::periodic) return 0.0;
  return 0.5 * d + std::max({-x.x, x.x - box.size[0], -x.y, x.y - box.size[1]});
}

TEST(Cloud, HardlyOverlapsAndStaysInsideTheWalls) {
  const auto d = grains(1200);
  for (const auto& s : shapes()) {
    const CloudOptions options{.shape = s.shape, .low = 2e-3, .solid_fraction = 0.5, .seed = 3};
    const auto cloud = make_cloud(options, d);
    const double overlap = largest_overlap(s.shape, cloud.x, d);
    EXPECT_LE(overlap, 0.01) << s.name;
    EXPECT_NEAR(overlap, cloud.largest_overlap, 1e-12) << s.name;
    for (std::size_t i = 0; i < d.size(); ++i) {
      EXPECT_LE(beyond_walls(s.shape, cloud.x[i], d[i]), 1e-12) << s.name;
      EXPECT_GE(cloud.x[i].z - 0.5 * d[i], 2e-3 - 1e-12) << s.name;
      EXPECT_LE(cloud.x[i].z + 0.5 * d[i], cloud.high + 1e-12) << s.name;
    }
    double solid = 0.0;
    for (const double one : d) solid += std::numbers::pi / 6.0 * one * one * one;
    const double filled = solid / (mesh::cross_section(s.shape) * (cloud.high - 2e-3));
    EXPECT_NEAR(filled, cloud.solid_fraction, 1e-12) << s.name;
    EXPECT_GE(cloud.solid_fraction, s.solid_fraction - 1e-12) << s.name;
  }
}

TEST(Cloud, FillsItsHeightEvenly) {
  const auto d = grains(3000);
  const CloudOptions options{.shape = mesh::Cylinder{3e-3, 1.0}, .solid_fraction = 0.45};
  const auto cloud = make_cloud(options, d);
  double solid[4] = {};
  for (std::size_t i = 0; i < d.size(); ++i) {
    const auto quarter = static_cast<std::size_t>(4.0 * cloud.x[i].z / cloud.high);
    solid[quarter] += d[i] * d[i] * d[i];
  }
  const double sum = solid[0] + solid[1] + solid[2] + solid[3];
  for (const double one : solid) EXPECT_NEAR(one / sum, 0.25, 0.02);
}

TEST(Cloud, IsTheSameForTheSameSeed) {
  const auto d = grains(300);
  CloudOptions options{.shape = mesh::Slice{3e-3, 0.9e-3, 1.0}};
  const auto a = make_cloud(options, d);
  const auto b = make_cloud(options, d);
  options.seed = 2;
  const auto c = make_cloud(options, d);
  for (std::size_t i = 0; i < d.size(); ++i) {
    EXPECT_EQ(a.x[i].x, b.x[i].x);
    EXPECT_EQ(a.x[i].z, b.x[i].z);
  }
  EXPECT_NE(a.x[7].x, c.x[7].x);
}

TEST(Cloud, OfFewBeadsIsAThinLayer) {
  const auto d = grains(5);
  const auto cloud = make_cloud({.shape = mesh::Slice{4e-3, 0.9e-3, 1.0}, .low = 0.01}, d);
  EXPECT_LE(cloud.high, 0.01 + 1.3 * *std::ranges::max_element(d));
  EXPECT_LE(largest_overlap(mesh::Slice{4e-3, 0.9e-3, 1.0}, cloud.x, d), 0.01);
  EXPECT_TRUE(make_cloud({.shape = mesh::Slice{4e-3, 0.9e-3, 1.0}}, {}).x.empty());
}

TEST(Cloud, SaysWhatCannotBe) {
  const std::vector<double> d = {1e-3};
  EXPECT_THAT(message_of([&] {
                make_cloud({.shape = mesh::Slice{4e-3, 0.9e-3, 1.0}}, d);
              }),
              HasSubstr("1000 um does not fit between sides 900 um apart"));
  using enum mesh::Boundary;
  EXPECT_THAT(message_of([&] {
                make_cloud({.shape = mesh::Box{{1, 1, 1}, {open, wall, wall}}}, d);
              }),
              HasSubstr("open"));
  EXPECT_THAT(message_of([&] {
                make_cloud({.shape = mesh::Slice{4e-3, 2e-3, 1.0}, .solid_fraction = 0.7}, d);
              }),
              HasSubstr("0.64"));
}

}  // namespace
}  // namespace packbed::dem
