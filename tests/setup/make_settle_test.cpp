// SPDX-License-Identifier: BSD-3-Clause
#include "setup/make_settle.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "setup/read_case.hpp"
#include "tests/support/message_of.hpp"

namespace packbed::setup {
namespace {

using test::message_of;
using testing::HasSubstr;

class MakeSettle : public testing::Test {
 protected:
  /// A slice, and grains soft enough to settle in a moment.
  [[nodiscard]] Case read(const std::string& rest, const std::string& height = "40 mm") const {
    return read_case_text(
        "[column]\nshape = \"slice\"\ninner_diameter = \"2 mm\"\nslice_depth = \"0.9 mm\"\n"
        "height = \"" +
            height +
            "\"\n[resin]\nname = \"SEP\"\ncoarse_grain = 3\nyoungs_modulus = \"0.3 MPa\"\n"
            "[liquid]\n" +
            rest,
        "case.toml", units_);
  }
  UnitSystem units_;
};

const std::string settle = "[[protocol]]\nstep = \"settle\"\n";

TEST_F(MakeSettle, MakesTheGrainsThatAreCounted) {
  const auto few = make_beads(read("[beads]\ncount = 60\n" + settle));
  const auto more = make_beads(read("[beads]\ncount = 80\n" + settle));
  const auto c = read("[beads]\ncount = 80\n[numerics]\nseed = 2\n" + settle);
  ASSERT_EQ(few.size(), 60U);
  for (std::size_t k = 0; k < few.size(); ++k) {
    EXPECT_EQ(few[k].properties.id, static_cast<std::int64_t>(k));
    EXPECT_EQ(few[k].properties.diameter, more[k].properties.diameter);
    EXPECT_GE(few[k].properties.diameter, 3 * 49.7e-6);
    EXPECT_LE(few[k].properties.diameter, 3 * 142.7e-6);
    EXPECT_TRUE(mesh::contains(c.column.shape, {few[k].x.x, few[k].x.y, few[k].x.z}));
  }
  EXPECT_NE(make_beads(c)[0].properties.diameter, few[0].properties.diameter);
  EXPECT_TRUE(make_beads(read("")).empty());
}

TEST_F(MakeSettle, MakesAsManyGrainsAsTheBedNeeds) {
  const auto volume = [](const std::vector<dem::BeadStart>& beads) {
    double sum = 0.0;
    for (const auto& bead : beads) sum += bead.properties.mass / bead.properties.density;
    return sum;
  };
  const double column = 2e-3 * 0.9e-3 * 4e-3;
  constexpr double grain = 40e-12;  // the largest [m3]
  const std::string high = settle + "bed_height = \"4 mm\"\n";
  EXPECT_NEAR(volume(make_beads(read(high))), 0.60 * column, grain);
  EXPECT_NEAR(volume(make_beads(read(high + "porosity = 0.38\n"))), 0.62 * column, grain);
  EXPECT_GT(make_beads(read(high + "friction = 0.01\n")).size(), make_beads(read(high)).size());
}

TEST_F(MakeSettle, AllowsAHighCloudOnlyWhereItSettlesFirst) {
  const std::string count = "[beads]\ncount = 300\n";
  const auto message = message_of([&] { make_beads(read(count, "2.6 mm")); });
  EXPECT_THAT(message, HasSubstr("case.toml: 300 grains without overlap take a height of"));
  EXPECT_THAT(message, HasSubstr("begin with a step \"settle\""));
  const auto c = read(count + settle, "2.6 mm");
  auto dem = make_dem(c, 1e-6, Ranks::alone());
  EXPECT_EQ(dem.bead_count(), 300);
  EXPECT_EQ(dem.walls().back().name, "lid");
  EXPECT_EQ(std::get<dem::Plane>(dem.walls().back().surface).point.z, column::lid_away);
}

TEST_F(MakeSettle, HandsTheKeysOn) {
  const auto c = read(
      "[numerics]\nbackground_damping = \"8 ms\"\nseed = 4\n[[protocol]]\nstep = \"settle\"\n"
      "bed_height = \"4 mm\"\nporosity = 0.38\n[[protocol]]\nstep = \"tap\"\namplitude = \"0.1 "
      "mm\"\n"
      "frequency = \"30 Hz\"\ncount = 5\n");
  const auto step = step_of(c);
  const auto o = settle_options(c, std::get<Settle>(c.protocol[0].what), step, true);
  EXPECT_EQ(o.bed_height, 4e-3);
  EXPECT_EQ(o.porosity, 0.38);
  EXPECT_EQ(o.lid, 40e-3);
  EXPECT_EQ(o.resin_friction, 0.1);
  EXPECT_EQ(o.resin_rolling_friction, 0.35);
  EXPECT_EQ(o.fall_damping, 8e-3);
  EXPECT_DOUBLE_EQ(o.damping_after, 125.0);
  EXPECT_EQ(o.liquid_density, c.liquid->density);
  EXPECT_EQ(o.bead(17).diameter, bead_of(c, 17).diameter);
  EXPECT_DOUBLE_EQ(o.stepping.longest_step, step.contact_time / 10.0);
  EXPECT_FALSE(settle_options(c, std::get<Settle>(c.protocol[0].what), step, false).lid);

  const auto tap = tap_options(c, std::get<Tap>(c.protocol[1].what), step);
  EXPECT_EQ(tap.amplitude, 1e-4);
  EXPECT_EQ(tap.frequency, 30.0);
  EXPECT_EQ(tap.count, 5);
  EXPECT_DOUBLE_EQ(tap.area, 2e-3 * 0.9e-3);
}

TEST_F(MakeSettle, SettlesACase) {
  const auto c = read(settle + "bed_height = \"2 mm\"\n");
  const auto step = step_of(c);
  auto dem = make_dem(c, step.step, Ranks::alone());
  column::Settle step_of_settling(
      settle_options(c, std::get<Settle>(c.protocol[0].what), step, true),
      settle_start(dem.bead_count()));
  while (step_of_settling.advance(dem)) {}
  EXPECT_NEAR(step_of_settling.state().bed_height, 2e-3, 0.26e-3);
  EXPECT_EQ(std::get<dem::Plane>(dem.walls().back().surface).point.z, 40e-3);
}

}  // namespace
}  // namespace packbed::setup
