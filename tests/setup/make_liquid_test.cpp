// SPDX-License-Identifier: BSD-3-Clause
#include "setup/make_liquid.hpp"

#include <gtest/gtest.h>

#include "setup/read_case.hpp"
#include "tests/support/temporary_folder.hpp"

namespace packbed::setup {
namespace {

constexpr const char* slice =
    "shape = \"slice\"\ninner_diameter = \"5 mm\"\nslice_depth = \"1 mm\"\nheight = \"20 mm\"\n";
constexpr const char* box =
    "shape = \"box\"\nsize = [\"4 mm\", \"4 mm\", \"20 mm\"]\n"
    "boundaries = { x = \"wall\", y = \"periodic\" }\n";
constexpr const char* cylinder =
    "shape = \"cylinder\"\ninner_diameter = \"5 mm\"\nheight = \"20 mm\"\n";

class MakeLiquid : public testing::Test {
 protected:
  fluid::Boundaries boundaries(const std::string& column, const std::string& liquid) const {
    const auto c = read_case(folder_.file("case.toml", "[column]\n" + column +
                                                           "[resin]\nname = \"SEP\"\n"
                                                           "[liquid]\n" +
                                                           liquid),
                             units_);
    return coupled_options(c).fluid.boundaries;
  }
  test::TemporaryFolder folder_;
  UnitSystem units_;
};

TEST_F(MakeLiquid, GivesWallsTheVoidFractionOfTheCase) {
  const fluid::BoundaryCondition of_bed = fluid::Wall{};
  const fluid::BoundaryCondition open = fluid::Wall{.velocity = {}, .void_fraction = 1.0};
  for (const auto& [text, wall] : {std::pair{"", of_bed},
                                   {"wall_void_fraction = \"bed\"\n", of_bed},
                                   {"wall_void_fraction = 1\n", open}}) {
    EXPECT_EQ(boundaries(cylinder, text).wall, wall);
    EXPECT_EQ(boundaries(slice, text).x_low, wall);
    EXPECT_EQ(boundaries(slice, text).x_high, wall);
    EXPECT_EQ(boundaries(box, text).x_low, wall);
    EXPECT_EQ(boundaries(box, text).x_high, wall);
    // No wall there.
    const fluid::BoundaryCondition none = fluid::Empty{};
    EXPECT_EQ(boundaries(slice, text).y_low, none);
    EXPECT_EQ(boundaries(box, text).y_high, none);
  }
}

}  // namespace
}  // namespace packbed::setup
