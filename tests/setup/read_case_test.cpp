// SPDX-License-Identifier: BSD-3-Clause
// What a case file means. What is refused is shown by cases/errors/ (tests/app).
#include "setup/read_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "continuum/water.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/temporary_folder.hpp"

namespace packbed::setup {
namespace {

using testing::HasSubstr;

const std::string slice_of_sep = R"(
[column]
shape = "slice"
inner_diameter = "9.6 mm"
slice_depth = "0.9 mm"
height = "70 mm"
[resin]
name = "SEP"
)";

class ReadCase : public testing::Test {
 protected:
  Case read(const std::string& text) const { return read_case_text(text, "case.toml", units_); }
  std::string refusal(const std::string& text) const {
    return test::message_of([&] { read(text); });
  }
  UnitSystem units_;
};

TEST_F(ReadCase, FillsInTheLibraryAndTheDefaults) {
  const auto c = read(slice_of_sep);

  EXPECT_EQ(c.title, "case");
  EXPECT_EQ(c.column.shape, mesh::ColumnShape(mesh::Slice{
                                .inner_diameter = 9.6e-3, .depth = 0.9e-3, .height = 70e-3}));
  EXPECT_EQ(c.column.wall, (Material{.youngs_modulus = 1e10, .poisson_ratio = 0.5}));
  EXPECT_EQ(c.resin.density, 1140.0);
  EXPECT_EQ(c.resin.youngs_modulus, 30e6);
  EXPECT_EQ(c.resin.characteristic_velocity, 0.1);
  EXPECT_EQ(c.resin.poisson_ratio, 0.2);
  EXPECT_EQ(c.resin.restitution, 0.5);
  EXPECT_EQ(c.resin.friction, 0.1);
  EXPECT_EQ(c.resin.wall_friction, 0.1);
  EXPECT_EQ(c.resin.rolling_friction, 0.35);
  EXPECT_EQ(c.resin.contact, ContactLawName::hooke);
  EXPECT_EQ(c.resin.rolling, RollingLawName::epsd);
  EXPECT_FALSE(c.resin.tension);
  EXPECT_EQ(c.resin.coarse_grain, 1.0);
  EXPECT_EQ(c.resin.sizes, resin::SizeDistribution(
                               resin::TruncatedNormal::from(86.9e-6, 16.6e-6, 49.7e-6, 142.7e-6)));
  EXPECT_FALSE(c.liquid);
  EXPECT_FALSE(c.numerics.step);
  EXPECT_FALSE(c.numerics.inertia_scale);
  EXPECT_EQ(c.numerics.inertia_scaling, InertiaScaling::by_size);
  EXPECT_EQ(c.numerics.seed, 1U);
  EXPECT_TRUE(c.numerics.gravity);
  EXPECT_EQ(read_case_text(slice_of_sep, "/a/my.toml", units_).output.directory, "runs/my");
  EXPECT_EQ(read_case_text(slice_of_sep, "/a/b/case.toml", units_).output.directory, "runs/b");
}

TEST_F(ReadCase, TakesTheUsersValueBeforeTheLibrarys) {
  const auto c = read(slice_of_sep +
                      "density = \"1.2 g/mL\"\nfriction = 0.25\n"
                      "sizes = { mean = \"90 um\" }\n");

  EXPECT_EQ(c.resin.density, 1200.0);
  EXPECT_EQ(c.resin.friction, 0.25);
  EXPECT_EQ(c.resin.sizes, resin::SizeDistribution(
                               resin::TruncatedNormal::from(90e-6, 16.6e-6, 49.7e-6, 142.7e-6)));
}

TEST_F(ReadCase, HertzTakesTheRelaxedModulus) {
  const auto c = read(slice_of_sep + "contact = \"hertz\"\n");

  EXPECT_EQ(c.resin.youngs_modulus, 3.89e6);
  EXPECT_FALSE(c.resin.characteristic_velocity);
}

TEST_F(ReadCase, SaysWhatTheLibraryDoesNotKnow) {
  const std::string column =
      "[column]\nshape = \"cylinder\"\ninner_diameter = \"1 cm\"\n"
      "height = \"3 cm\"\n";
  EXPECT_THAT(refusal(column + "[resin]\nname = \"TOY\"\n"),
              HasSubstr("the library has no youngs_modulus_linear for \"Toyopearl AF-Amino-650M\"; "
                        "give a modulus such as \"30 MPa\", or use contact = \"hertz\" with the "
                        "relaxed modulus 4.22 MPa"));
  EXPECT_THAT(refusal(column + "[resin]\nname = \"Affi-Gel 102\"\n"),
              HasSubstr("the library has no density"));
  EXPECT_NO_THROW(read(column + "[resin]\nname = \"TOY\"\ncontact = \"hertz\"\n"));
}

TEST_F(ReadCase, OwnBeadsNeedNoLibrary) {
  const auto c = read(R"(
[column]
shape = "box"
size = ["4 mm", "5 mm", "20 mm"]
boundaries = { x = "periodic", z = "open" }
[resin]
youngs_modulus = "4 MPa"
poisson_ratio = 0.5
density = "1100 kg/m3"
rolling = "none"
tension = true
sizes = { distribution = "monodisperse", diameter = "100 um" }
)");

  const auto& box = std::get<mesh::Box>(c.column.shape);
  EXPECT_EQ(box.size, (std::array{4e-3, 5e-3, 20e-3}));
  EXPECT_EQ(box.boundaries,
            (std::array{mesh::Boundary::periodic, mesh::Boundary::wall, mesh::Boundary::open}));
  EXPECT_EQ(c.resin.poisson_ratio, 0.5);
  EXPECT_EQ(c.resin.rolling, RollingLawName::none);
  EXPECT_TRUE(c.resin.tension);
}

TEST_F(ReadCase, WaterFollowsItsTemperature) {
  const auto cold = read(slice_of_sep + "[liquid]\ntemperature = \"4 degC\"\n");
  const auto standard = read(slice_of_sep + "[liquid]\n");

  EXPECT_EQ(cold.liquid->viscosity, continuum::water_viscosity(277.15));
  EXPECT_EQ(standard.liquid->density, continuum::water_density(293.15));
}

TEST_F(ReadCase, LiquidOfTheUser) {
  const auto c = read(slice_of_sep +
                      "[liquid]\nname = \"20 % ethanol\"\n"
                      "density = \"0.97 g/mL\"\nviscosity = \"2.1 cP\"\n");
  EXPECT_EQ(c.liquid->density, 970.0);
  EXPECT_EQ(c.liquid->viscosity, 2.1e-3);
  EXPECT_FALSE(c.liquid->temperature);
}

TEST_F(ReadCase, ReadsEveryProtocolStep) {
  const auto c = read(slice_of_sep + R"([liquid]
[[protocol]]
step = "settle"
bed_height = "31 mm"
porosity = 0.38
[[protocol]]
step = "flow_ramp"
to = "2 L/h"
steps = 20
hold = "2 min"
[[protocol]]
step = "hold"
duration = "10 s"
flow = "300 cm/h"
[[protocol]]
step = "repeat"
count = 4
[[protocol.steps]]
step = "compress"
speed = "20 mm/min"
compression = "2.5 %"
[[protocol.steps]]
step = "run"
duration = "0.5 s"
)");

  ASSERT_EQ(c.protocol.size(), 4U);
  EXPECT_EQ(std::get<Settle>(c.protocol[0].what),
            (Settle{.bed_height = 31e-3, .friction = {}, .porosity = 0.38}));
  const auto& ramp = std::get<FlowRamp>(c.protocol[1].what);
  EXPECT_NEAR(ramp.to / (0.01 / 3600.0), 2763.0, 0.5);  // thesis: 2 L/h in 9.6 mm, also as a slice
  EXPECT_EQ(ramp.from, 0.0);
  EXPECT_EQ(ramp.steps, 20);
  EXPECT_EQ(ramp.hold, 120.0);
  EXPECT_EQ(std::get<Hold>(c.protocol[2].what).flow, 300.0 / 360000.0);
  const auto& repeat = std::get<Repeat>(c.protocol[3].what);
  EXPECT_EQ(repeat.count, 4);
  EXPECT_EQ(
      std::get<Compress>(repeat.steps[0].what),
      (Compress{{.speed = 20.0 / 60000.0, .goal = PlungerGoal::compression, .value = 0.025}}));
  EXPECT_EQ(std::get<setup::Run>(repeat.steps[1].what).duration, 0.5);
}

TEST_F(ReadCase, StepsPointAtThemselvesInMessages) {
  EXPECT_EQ(refusal(slice_of_sep + "[[protocol]]\nstep = \"run\"\nduration = \"1 s\"\n"
                                   "[[protocol]]\nstep = \"run\"\nduration = \"-1 s\"\n"),
            "case.toml:14: protocol[2].duration = \"-1 s\" must not be negative");
}

TEST_F(ReadCase, TakesByteOrderMarkAndCrLf) {
  const test::TemporaryFolder folder;
  std::string text = "\xEF\xBB\xBF" + slice_of_sep;
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) {
    text.replace(at, 1, "\r\n");
  }

  const auto c = read_case(folder.file("Fälle/Säule № 1.toml", text), units_);

  EXPECT_EQ(c.resin.density, 1140.0);
  EXPECT_EQ(c.title, "Säule № 1");
}

TEST_F(ReadCase, BeadsOfAFileAreTakenFromTheFolderOfTheCase) {
  const test::TemporaryFolder folder;
  (void)folder.file("beads.csv",
                    "x_m,y_m,z_m,diameter_m,fixed\n"
                    "1e-3,1e-3,1e-3,1e-4,1\n1e-3,1e-3,1.2e-3,9e-5,0\n");
  const auto c = read_case(folder.file("two.toml", R"(
[column]
shape = "box"
size = ["4 mm", "4 mm", "4 mm"]
[resin]
name = "SEP"
[beads]
csv = "beads.csv"
[[protocol]]
step = "run"
duration = "10 us"
[numerics]
gravity = false
step = "10 ns"
inertia_scale = 1
inertia_scaling = "uniform"
)"),
                           units_);

  EXPECT_EQ(c.beads.table.size(), 2U);
  EXPECT_TRUE(c.beads.table.fixed[0]);
  EXPECT_FALSE(c.resin.sizes);
  EXPECT_EQ(c.numerics.step, 1e-8);
  EXPECT_EQ(c.numerics.inertia_scale, 1.0);
  EXPECT_EQ(c.numerics.inertia_scaling, InertiaScaling::uniform);
  EXPECT_FALSE(c.numerics.gravity);
}

TEST_F(ReadCase, BeadsMayBringTheirOwnMaterial) {
  const test::TemporaryFolder folder;
  (void)folder.file("beads.csv",
                    "x_m,y_m,z_m,diameter_m,density_kg_m3,youngs_modulus_Pa,poisson_ratio\n"
                    "1e-3,1e-3,1e-3,1e-4,1140,3e7,0.2\n");
  const auto c = read_case(folder.file("one.toml",
                                       "[column]\nshape = \"box\"\n"
                                       "size = [\"4 mm\", \"4 mm\", \"4 mm\"]\n"
                                       "[beads]\ncsv = \"beads.csv\"\n"),
                           units_);
  EXPECT_FALSE(c.resin.density);
  EXPECT_FALSE(c.resin.youngs_modulus);
}

TEST_F(ReadCase, BeadsMayNameTheirResin) {
  const test::TemporaryFolder folder;
  (void)folder.file("beads.csv",
                    "x_m,y_m,z_m,diameter_m,poisson_ratio,resin\n"
                    "1e-3,1e-3,1e-3,1e-4,0.3,SEP\n1e-3,1e-3,2e-3,1e-4,0.4,TOY\n");
  const auto c =
      read_case(folder.file("one.toml",
                            "[column]\nshape = \"box\"\nsize = [\"4 mm\", \"4 mm\", \"4 mm\"]\n"
                            "[resin]\ncontact = \"hertz\"\n[beads]\ncsv = \"beads.csv\"\n"),
                units_);

  EXPECT_EQ(c.beads.table.density, (std::vector{1140.0, 1340.0}));
  EXPECT_EQ(c.beads.table.youngs_modulus, (std::vector{3.89e6, 4.22e6}));
  EXPECT_EQ(c.beads.table.poisson_ratio, (std::vector{0.3, 0.4}));  // the column counts
}

TEST_F(ReadCase, OwnLibraryOfTheUser) {
  const test::TemporaryFolder folder;
  (void)folder.file("my.toml",
                    "[source.lab]\ncitation = \"our lab\"\n[[resin]]\nname = \"Mine\"\n"
                    "density = { value = \"1.1 g/mL\", source = \"lab\" }\n");
  const auto c = read_case(folder.file("c.toml", R"(
[column]
shape = "cylinder"
inner_diameter = "1 cm"
height = "3 cm"
[resin]
name = "Mine"
library = "my.toml"
youngs_modulus = "10 MPa"
poisson_ratio = 0.3
sizes = { distribution = "monodisperse", diameter = "80 um" }
)"),
                           units_);
  EXPECT_EQ(c.resin.density, 1100.0);
}

}  // namespace
}  // namespace packbed::setup
