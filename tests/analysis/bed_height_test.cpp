// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/bed_height.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "analysis/overlap.hpp"
#include "tests/support/spheres.hpp"

namespace packbed::analysis {
namespace {

using namespace packbed::test;  // NOLINT

const auto alone = Ranks::alone();

// With layers as high as the window of 0.3 mm the mean over it is the same everywhere in the bed, and half
// of it is left where the window's lower end is at the centers of the last layer.
TEST(BedHeight, OfLayersAsHighAsTheWindowIsTheirTop) {
  for (const int layers : {20, 40}) {
    EXPECT_NEAR(bed_height(cubic(0.3e-3, 3, 3, layers), alone), layers * 0.3e-3, 1e-11);
  }
}

// Layers of 0.43 mm: the mean over the window swings between 0.79 and 1.2 of the bulk. At the top it is half
// of the bulk, pi/6 / 2 times the area d^2 of a bead, where the cap of the last layer in the window is as
// large as that.
TEST(BedHeight, OfCoarseGrainsIsNotMisledByLayers) {
  const double d = 0.43e-3;
  const double window = 0.3e-3;
  const int layers = 40;
  double low = 0.0;  // the window's lower end, from the centers of the last layer
  double high = 0.5 * d;
  const double half = 0.5 * std::numbers::pi / 6.0 * d * d * window;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (volume_below(0.5 * d, -middle) > half ? low : high) = middle;
  }

  const double height = bed_height(cubic(d, 3, 3, layers), alone);

  // 2e-6 m: H/4 and 3H/4 are not between two layers, so that the bulk is not quite pi/6.
  EXPECT_NEAR(height, (layers - 0.5) * d + low + 0.5 * window, 2e-6);
}

/// Beads of 0.2 to 0.4 mm in every cell of a lattice, each at a random place in its cell.
std::vector<Bead> disordered(int layers, double lift) {
  auto beads = cubic(0.4e-3, 8, 8, layers, {0, 0, lift});
  Draws draw(23);
  for (auto& b : beads) {
    b.radius = draw(0.1e-3, 0.2e-3);
    const double gap = 0.2e-3 - b.radius;
    b.x += Vec3{draw(-gap, gap), draw(-gap, gap), draw(-gap, gap)};
  }
  return beads;
}

// Lifted by parts of a bin, a bed is higher by as much; the bulk hardly changes.
TEST(BedHeight, IsNotQuantizedByBins) {
  const double height = bed_height(disordered(40, 0.0), alone);
  for (const double lift : {3e-6, 27e-6, 50e-6, 81e-6}) {
    EXPECT_NEAR(bed_height(disordered(40, lift), alone) - height, lift, 2e-6);
  }
}

TEST(BedHeight, LeavesLooseBeadsOut) {
  auto beads = disordered(20, 0.0);
  const double height = bed_height(beads, alone);
  for (const double z : {8.3e-3, 8.5e-3, 9e-3, 30e-3}) {
    beads.push_back({{1e-3, 1e-3, z}, 0.15e-3});
  }
  EXPECT_NEAR(bed_height(beads, alone), height, 15e-6);  // the lowest ones touch the window
}

TEST(BedHeight, HasAnAnswerForAnyBed) {
  EXPECT_EQ(bed_height({}, alone), 0.0);
  const double one = bed_height(std::vector<Bead>{{{0, 0, 0.2e-3}, 0.2e-3}}, alone);
  EXPECT_GT(one, 0.3e-3);
  EXPECT_LT(one, 0.4e-3);
  const double layer = bed_height(cubic(87e-6, 20, 20, 1), alone);
  EXPECT_GT(layer, 70e-6);
  EXPECT_LT(layer, 87e-6);
  const std::vector<Bead> heaps = {{{0, 0, 1e-4}, 1e-4}, {{0, 0, 1.0}, 1e-4}};
  EXPECT_TRUE(std::isfinite(bed_height(heaps, alone)));
  EXPECT_EQ(bed_height(std::vector<Bead>{{{0, 0, -1.0}, 1e-4}}, alone), 0.0);
}

TEST(BedFigures, GiveThePorosityOfALattice) {
  const double d = 0.3e-3;
  const auto f = bed_figures(cubic(d, 3, 3, 20), 9 * d * d, alone);
  EXPECT_NEAR(f.mean_porosity, 1.0 - std::numbers::pi / 6.0, 1e-8);
  EXPECT_NEAR(f.middle_porosity, 1.0 - std::numbers::pi / 6.0, 1e-8);
  EXPECT_EQ(mean_porosity({}, 1.0, {0.0, 0.0}, alone), 1.0);
}

}  // namespace
}  // namespace packbed::analysis
