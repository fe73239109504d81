// SPDX-License-Identifier: BSD-3-Clause
#include "setup/case_figures.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "setup/read_case.hpp"
#include "tests/support/temporary_folder.hpp"

namespace packbed::setup {
namespace {

constexpr double cm_h = 0.01 / 3600.0;

CaseFigures figures_of(const std::string& text) {
  return figures(read_case_text(text, "case.toml", UnitSystem()));
}

// Thesis: SEP, 31 mm in 9.6 mm, water of 1000 kg/m3 and 1 mPa s, up to 2763 cm/h.
std::string lab_column(const std::string& resin_keys, const std::string& settle_keys) {
  return R"([column]
shape = "cylinder"
inner_diameter = "9.6 mm"
height = "70 mm"
[resin]
name = "SEP"
)" + resin_keys +
         R"([liquid]
density = "1000 kg/m3"
viscosity = "1 mPa s"
[[protocol]]
step = "settle"
bed_height = "31 mm"
)" + settle_keys +
         R"([[protocol]]
step = "flow_ramp"
to = "500 cm/h"
[[protocol]]
step = "repeat"
count = 2
[[protocol.steps]]
step = "hold"
duration = "1 s"
flow = "2763 cm/h"
)";
}

TEST(CaseFigures, CountCellsOfTheMesh) {
  const auto f = figures_of(lab_column("", ""));

  ASSERT_TRUE(f.mesh.has_value());
  EXPECT_EQ(f.mesh->counts.all(), 588 * 200);
  EXPECT_NEAR(f.mesh->cell_height, 0.35e-3, 1e-18);
  // sqrt(pi/4 / 588) of 9.6 mm
  EXPECT_NEAR(f.mesh->cell_across, 9.6e-3 * std::sqrt(0.25 * std::numbers::pi / 588), 1e-18);
}

TEST(CaseFigures, HaveNoMeshWithoutALiquid) {
  const auto f = figures_of(R"([column]
shape = "box"
size = ["1 m", "1 m", "1 m"]
[resin]
name = "SEP"
)");
  EXPECT_FALSE(f.mesh.has_value());
}

TEST(CaseFigures, PressureDropIsKozenyCarmanAtTheHighestFlow) {
  const auto f = figures_of(lab_column("", "porosity = 0.36\n"));

  EXPECT_EQ(f.flow->highest_velocity, 2763 * cm_h);
  // 1.402289e6 Pa/m at d32 = 93 um; ours is 93.11 um
  const double d32 = f.sizes.sauter;
  EXPECT_NEAR(f.flow->pressure_gradient, 1.402289e6 * std::pow(93e-6 / d32, 2), 1.0);
  EXPECT_NEAR(f.flow->pressure_drop, f.flow->pressure_gradient * 0.031, 1e-6);
  EXPECT_NEAR(f.flow->stokes, 1140 * d32 * 2763 * cm_h / 0.018, 1e-12);
  EXPECT_NEAR(f.flow->reynolds, 1000 * 2763 * cm_h * d32 / (0.001 * 0.36), 1e-12);
}

TEST(CaseFigures, CountsBeadsFromTheBedHeight) {
  const auto f = figures_of(lab_column("", "porosity = 0.38\n"));

  const double bed = 0.25 * std::numbers::pi * 9.6e-3 * 9.6e-3 * 31e-3;
  const double bead = std::numbers::pi / 6.0 * std::pow(f.sizes.volume_mean, 3);
  EXPECT_NEAR(f.bead_count, 0.62 * bed / bead, 0.5);
  EXPECT_NEAR(f.bead_volume, 0.62 * bed, bead);
  EXPECT_NEAR(f.bead_mass, 1140 * 0.62 * bed, 1140 * bead);
  EXPECT_NEAR(*f.submerged_weight, 140 * 9.81 * f.bead_volume, 1e-12);
}

TEST(CaseFigures, CoarseGrainsStandForTheirCubeOfBeads) {
  const auto fine = figures_of(lab_column("", ""));
  const auto coarse = figures_of(lab_column("coarse_grain = 3\n", ""));

  EXPECT_NEAR(coarse.bead_count, fine.bead_count / 27.0, 1.0);
  EXPECT_DOUBLE_EQ(coarse.real_bead_count, coarse.bead_count * 27.0);
  EXPECT_DOUBLE_EQ(coarse.largest_grain, 3.0 * fine.largest_grain);
  EXPECT_DOUBLE_EQ(coarse.flow->pressure_drop, fine.flow->pressure_drop);
  EXPECT_DOUBLE_EQ(coarse.memory * 27.0 / fine.memory, 27.0 * coarse.bead_count / fine.bead_count);
}

TEST(CaseFigures, SayThatAPorosityIsAssumed) {
  const auto f = figures_of(lab_column("", ""));
  EXPECT_EQ(f.bed->porosity, assumed_porosity);
  EXPECT_FALSE(f.bed->porosity_is_set);
  EXPECT_TRUE(figures_of(lab_column("", "porosity = 0.38\n")).bed->porosity_is_set);
}

TEST(CaseFigures, OfABeadFileAreItsSums) {
  const test::TemporaryFolder folder;
  (void)folder.file("b.csv",
                    "x_m,y_m,z_m,diameter_m,density_kg_m3\n"
                    "1e-3,1e-3,1e-3,1e-4,1000\n1e-3,1e-3,2e-3,2e-4,2000\n");
  const auto c = read_case(folder.file("c.toml",
                                       "[column]\nshape = \"box\"\n"
                                       "size = [\"4 mm\", \"4 mm\", \"4 mm\"]\n"
                                       "[resin]\nname = \"SEP\"\n"
                                       "[beads]\ncsv = \"b.csv\"\n"),
                           UnitSystem());

  const auto f = figures(c);

  const double sphere = std::numbers::pi / 6.0 * 1e-12;
  EXPECT_EQ(f.bead_count, 2.0);
  EXPECT_DOUBLE_EQ(f.bead_mass, (1000.0 + 8.0 * 2000.0) * sphere);
  EXPECT_DOUBLE_EQ(f.bead_volume, 9.0 * sphere);
  EXPECT_FALSE(f.submerged_weight);  // no [liquid]: dry
  EXPECT_FALSE(f.flow);
}

TEST(CaseFigures, CountTheMemoryOfFramesWhereThereAreSome) {
  const auto with = figures_of(lab_column("", ""));
  const auto without = figures_of(lab_column("", "[output]\nframes = false\n"));

  EXPECT_GT(with.memory_with_frames, with.memory);
  EXPECT_EQ(without.memory, with.memory);
  EXPECT_EQ(without.memory_with_frames, without.memory);
}

TEST(CaseFigures, OfAnEmptyBedAreZero) {
  const auto f = figures_of(
      "[column]\nshape = \"cylinder\"\ninner_diameter = \"1 cm\"\n"
      "height = \"3 cm\"\n[resin]\nname = \"SEP\"\n[beads]\ncount = 0\n");
  EXPECT_EQ(f.bead_count, 0.0);
  EXPECT_EQ(f.bead_mass, 0.0);
  EXPECT_EQ(f.memory, 0.0);
}

}  // namespace
}  // namespace packbed::setup
