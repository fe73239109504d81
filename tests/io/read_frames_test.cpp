// SPDX-License-Identifier: BSD-3-Clause
#include "io/read_frames.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "io/frame_series.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/temporary_folder.hpp"

namespace packbed::io {
namespace {

using test::message_of;
using test::TemporaryFolder;
using testing::HasSubstr;

class ReadFrames : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path path(const std::string& name) const {
    return folder_.path() / name;
  }
  /// Two beads, with everything that a run writes of them and is read back.
  void write_beads(const std::string& name) const {
    write_bead_frame(path(name),
                     {.time = 0.1,
                      .x = x_,
                      .radius = radius_,
                      .id = id_,
                      .more = {{"velocity_m_s", std::span<const Vec3>(velocity_)}}},
                     {.double_precision = true});
  }

  TemporaryFolder folder_;
  std::vector<Vec3> x_ = {{0.1, 0.2, 0.3}, {-1e-5, 0, 7}};
  std::vector<double> radius_ = {40e-6, 41e-6};
  std::vector<std::int64_t> id_ = {3, std::int64_t{1} << 40};
  std::vector<Vec3> velocity_ = {{1e-3, -1, 3}, {0, 0, 0}};
};

TEST_F(ReadFrames, GiveBeadsAsTheyWereWritten) {
  write_beads("beads.hdf");

  const auto beads = read_bead_frame(path("beads.hdf"));

  EXPECT_EQ(beads.time, 0.1);
  EXPECT_EQ(beads.x, x_);
  EXPECT_EQ(beads.radius, radius_);
  EXPECT_EQ(beads.id, id_);
  EXPECT_EQ(beads.velocity, velocity_);
}

TEST_F(ReadFrames, GiveContactsAsTheyWereWritten) {
  const std::vector<ContactLine> lines = {
      {{0.1, 0, 0}, {0.2, 0, 0}, 4, 7, 1e-5, 2e-6, 3e-8, {0, 2e-6, 0}},
      {{0.1, 0, 0}, {0.1, 0, -0.05}, 4, wall_id(2), -3e-5, 1e-6, 5e-8, {1e-6, 0, 0}}};
  for (const int deflate : {0, 4}) {
    write_contact_frame(path("c.hdf"), {.time = 2.0, .contacts = lines},
                        {.double_precision = true, .deflate = deflate});

    const auto stored = read_contact_frame(path("c.hdf"));

    EXPECT_EQ(stored.time, 2.0);
    EXPECT_TRUE(stored.has_tangential_vectors);
    EXPECT_EQ(stored.contacts, lines);
  }
}

TEST_F(ReadFrames, GiveSingleNumbersToSevenDigits) {
  const std::vector<ContactLine> lines = {{{0.1, 0, 0}, {0.2, 0, 0}, 4, 7, 1e-5, 2e-6, 3e-8, {}}};
  write_contact_frame(path("c.hdf"), {.time = 0.1, .contacts = lines});

  const auto stored = read_contact_frame(path("c.hdf"));

  EXPECT_EQ(stored.time, 0.1);
  EXPECT_EQ(stored.contacts[0].normal_force, static_cast<double>(1e-5F));
}

void expect_the_cells_of(const mesh::ColumnMesh& mesh, const StoredLiquid& liquid) {
  ASSERT_EQ(liquid.volume.size(), static_cast<std::size_t>(mesh.cell_count()));
  for (std::size_t c = 0; c < liquid.volume.size(); ++c) {
    const auto cell = static_cast<std::int64_t>(c);
    EXPECT_NEAR(liquid.volume[c], mesh.volume(cell), 1e-9 * mesh.volume(cell));
    EXPECT_LT(norm(liquid.center[c] - mesh.center(cell)), 1e-9 * mesh.top());
  }
}

TEST_F(ReadFrames, GiveTheCellsOfALiquid) {
  for (const auto& shape :
       {mesh::ColumnShape(mesh::Slice{.inner_diameter = 2e-3, .depth = 0.7e-3, .height = 1e-3}),
        mesh::ColumnShape(mesh::Cylinder{.inner_diameter = 2e-3, .height = 1e-3})}) {
    mesh::ColumnMesh mesh(shape, mesh::cell_counts(shape, {}));
    mesh.set_top(0.9e-3);  // as a plunger leaves it
    const auto cells = static_cast<std::size_t>(mesh.cell_count());
    std::vector<double> eps(cells, 0.4);
    eps.back() = 0.5;
    const std::vector<Vec3> u(cells, Vec3{1e-3, 0, -2e-3});
    const std::vector<double> p(cells, 1e5);
    write_liquid_frame(path("l.hdf"),
                       {.time = 0.3,
                        .mesh = mesh,
                        .cells = {{"void_fraction", std::span<const double>(eps)},
                                  {"velocity_m_s", std::span<const Vec3>(u)},
                                  {"pressure_Pa", std::span<const double>(p)}}},
                       {.double_precision = true});

    const auto liquid = read_liquid_frame(path("l.hdf"));

    expect_the_cells_of(mesh, liquid);
    EXPECT_EQ(liquid.void_fraction, eps);
    EXPECT_EQ(liquid.velocity, u);
    EXPECT_EQ(liquid.pressure, p);
  }
}

TEST_F(ReadFrames, ListThoseOfASeriesWithTheirNumbers) {
  FrameSeries series(folder_.path(), "liquid");
  series.skip();
  for (const double time : {0.1, 0.5}) {
    write_beads(series.next().filename());
    series.add(time);
  }

  const auto frames = listed_frames(folder_.path(), "liquid");

  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].number, 1U);
  EXPECT_EQ(frames[1].time, 0.5);
  EXPECT_EQ(frames[1].file, path("liquid_000002.hdf"));
}

TEST_F(ReadFrames, MissWhatASeriesListsAndIsNotThere) {
  FrameSeries series(folder_.path(), "liquid");
  series.skip();
  series.skip();
  series.add(0.1);

  EXPECT_THAT(message_of([&] { static_cast<void>(listed_frames(folder_.path(), "liquid")); }),
              HasSubstr("liquid_000002.hdf: this frame is missing, though"));
  EXPECT_THROW(static_cast<void>(listed_frames(folder_.path(), "beads")), DataError);
}

TEST_F(ReadFrames, RefuseWhatIsNoFrameOnOneLine) {
  (void)folder_.file("text.hdf", "hello");
  write_contact_frame(path("c.hdf"), {.time = 0.0, .contacts = {}});
  radius_[1] = 0.0;
  write_beads("zero.hdf");
  radius_[1] = std::nan("");
  write_beads("nan.hdf");
  const std::pair<const char*, const char*> files[] = {
      {"none.hdf", "none.hdf: opening failed"},
      {"text.hdf", "text.hdf: opening failed"},
      {"c.hdf", "c.hdf: it is no frame of beads, or it is damaged (it has no array"},
      {"zero.hdf", "(a radius is not positive)"},
      {"nan.hdf", "\"PointData/radius_m\" has a value that is not finite"}};
  for (const auto& expected : files) {
    EXPECT_THAT(message_of([&] { static_cast<void>(read_bead_frame(path(expected.first))); }),
                HasSubstr(expected.second));
  }
}

TEST_F(ReadFrames, RefuseOnesThatWereCutOff) {
  write_beads("beads.hdf");
  std::filesystem::resize_file(path("beads.hdf"), 1500);

  EXPECT_THAT(message_of([&] { static_cast<void>(read_bead_frame(path("beads.hdf"))); }),
              HasSubstr("beads.hdf: opening failed"));
}

}  // namespace
}  // namespace packbed::io
