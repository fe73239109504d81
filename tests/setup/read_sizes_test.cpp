// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "resin/size_statistics.hpp"
#include "setup/read_case.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/temporary_folder.hpp"

namespace packbed::setup {
namespace {

using testing::HasSubstr;

class ReadSizes : public testing::Test {
 protected:
  resin::SizeDistribution read(const std::string& sizes) const {
    const auto file = folder_.file("case.toml",
                                   "[column]\nshape = \"cylinder\"\n"
                                   "inner_diameter = \"1 cm\"\nheight = \"3 cm\"\n"
                                   "[resin]\nname = \"SEP\"\n[resin.sizes]\n" +
                                       sizes);
    return *read_case(file, units_).resin.sizes;
  }
  std::string refusal(const std::string& sizes) const {
    return test::message_of([&] { read(sizes); });
  }
  test::TemporaryFolder folder_;
  UnitSystem units_;
};

TEST_F(ReadSizes, LognormalIsCutAtThreeDeviationsByDefault) {
  const auto sizes = read(
      "distribution = \"lognormal\"\nmedian = \"80 um\"\n"
      "geometric_standard_deviation = 1.25\n");

  EXPECT_DOUBLE_EQ(resin::smallest(sizes), 80e-6 / (1.25 * 1.25 * 1.25));
  EXPECT_DOUBLE_EQ(resin::largest(sizes), 80e-6 * 1.25 * 1.25 * 1.25);
}

TEST_F(ReadSizes, HistogramByNumberOrByVolume) {
  (void)folder_.file("h.csv", "lower [um],upper [um],share\n50,70,1\n70,100,3\n");

  const auto number =
      read("distribution = \"histogram\"\nshare_of = \"number\"\ncsv = \"h.csv\"\n");
  const auto volume =
      read("distribution = \"histogram\"\nshare_of = \"volume\"\ncsv = \"h.csv\"\n");

  const std::vector<resin::Bin> bins = {{50e-6, 70e-6, 1}, {70e-6, 100e-6, 3}};
  EXPECT_EQ(number,
            resin::SizeDistribution(resin::Histogram::from(bins, resin::Weighting::number)));
  EXPECT_EQ(volume,
            resin::SizeDistribution(resin::Histogram::from(bins, resin::Weighting::volume)));
}

TEST_F(ReadSizes, MeasuredDiametersInTheUnitOfTheirHeader) {
  (void)folder_.file("d.csv", "bead,diameter [mm]\n1,0.09\n2,0.1\n");

  const auto sizes = read("distribution = \"measured\"\ncsv = \"d.csv\"\n");

  EXPECT_EQ(sizes,
            resin::SizeDistribution(resin::Measured::from(std::vector<double>{90e-6, 100e-6})));
}

TEST_F(ReadSizes, FilesAreRefusedNamingTheirLine) {
  const auto measured = [&](const std::string& text) {
    (void)folder_.file("d.csv", text);
    return refusal("distribution = \"measured\"\ncsv = \"d.csv\"\n");
  };
  EXPECT_THAT(measured("diameter\n90\n"), HasSubstr("d.csv:1: column \"diameter\" has no unit"));
  EXPECT_THAT(measured("size [um]\n90\n"), HasSubstr("column \"diameter\" is missing"));
  EXPECT_THAT(measured("diameter [um]\n90\n-1\n"), HasSubstr("d.csv:3: diameter = -1"));
  EXPECT_THAT(measured("diameter [kg]\n90\n"), HasSubstr("unit [kg] is refused"));
  EXPECT_THAT(measured("diameter [um]\nbig\n"), HasSubstr("d.csv:2"));
  (void)folder_.file("h.csv", "lower [um],upper [um],share\n50,70,1\n60,100,3\n");
  EXPECT_THAT(refusal("distribution = \"histogram\"\nshare_of = \"number\"\ncsv = \"h.csv\"\n"),
              HasSubstr("h.csv: bin 2"));
}

}  // namespace
}  // namespace packbed::setup
