// SPDX-License-Identifier: BSD-3-Clause
// Frames, read back by the VTK library, on which ParaView stands.
#include "io/frames.hpp"

#include <array>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "tests/support/message_of.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace packbed::io {
namespace {

using nlohmann::json;
using test::message_of;
using test::TemporaryFolder;
using testing::HasSubstr;

/// What VTK finds in a frame, by read_frame.py.
json read_by_vtk(const std::filesystem::path& file) {
  const auto script = std::string(PACKBED_SOURCE_DIR) + "/tests/io/read_frame.py";
  const auto outcome =
      test::run_shell("/usr/bin/python3 " + script + " " + file.string(), file.parent_path());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return json::parse(outcome.out, nullptr, false);
}

std::vector<Vec3> vectors(const json& rows) {
  std::vector<Vec3> all;
  for (const auto& row : rows) all.push_back({row[0], row[1], row[2]});
  return all;
}

/// All components, as floats.
std::vector<float> floats(const std::vector<Vec3>& all) {
  std::vector<float> numbers;
  for (const auto& v : all) {
    for (const double number : {v.x, v.y, v.z}) numbers.push_back(static_cast<float>(number));
  }
  return numbers;
}

/// Five beads with values that tell them apart.
struct Beads {
  std::vector<Vec3> x, velocity;
  std::vector<double> radius;
  std::vector<std::int64_t> id;
  std::vector<std::int32_t> contacts;
  std::vector<std::uint8_t> fixed;

  Beads() {
    for (int k = 0; k < 5; ++k) {
      x.push_back({0.1 * k, 0.2 + k, -1e-5 * k});
      velocity.push_back({1e-3 / (k + 1), -k * 1.0, 3.0});
      radius.push_back(40e-6 + 1e-6 * k);
      id.push_back((std::int64_t{1} << 40) - k);
      contacts.push_back(10 - k);
      fixed.push_back(k % 2 == 0 ? 1 : 0);
    }
  }
  [[nodiscard]] BeadFrame frame() const {
    return {.time = 0.1,
            .x = x,
            .radius = radius,
            .id = id,
            .more = {{"velocity_m_s", std::span(velocity)},
                     {"contacts", std::span(contacts)},
                     {"fixed", std::span(fixed)}}};
  }
};

/// A contact within a box 1 m wide, one through its border, one with wall 2.
const std::vector<ContactLine> contacts = {
    {{0.1, 0, 0}, {0.2, 0, 0}, 4, 7, 1e-5, 2e-6, 3e-8, {0, 2e-6, 0}},
    {{0.95, 0, 0}, {1.05, 0, 0}, 7, 5, 2e-5, 0.0, 4e-8, {}},
    {{0.1, 0, 0}, {0.1, 0, -0.05}, 4, wall_id(2), -3e-5, 1e-6, 5e-8, {}}};

TEST(Frames, BeadsAreReadByVtkAsTheyWereWritten) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "beads_000000.hdf";
  const Beads beads;
  write_bead_frame(file, beads.frame(), {.double_precision = true});

  const auto found = read_by_vtk(file);

  EXPECT_EQ(vectors(found["points"]), beads.x);
  EXPECT_EQ(vectors(found["point_data"]["velocity_m_s"]["values"]), beads.velocity);
  EXPECT_EQ(found["point_data"]["radius_m"]["values"], json(beads.radius));
  EXPECT_EQ(found["point_data"]["diameter_m"]["values"][4], 2.0 * beads.radius[4]);
  EXPECT_EQ(found["point_data"]["id"]["values"], json(beads.id));
  EXPECT_EQ(found["point_data"]["contacts"]["values"], json(beads.contacts));
  EXPECT_EQ(found["point_data"]["fixed"]["values"], json(beads.fixed));
  EXPECT_EQ(found["field_data"]["time_s"]["values"], json::array({0.1}));
  ASSERT_EQ(found["cells"].size(), 5U);
  for (int k = 0; k < 5; ++k) {
    const json vertex = {{"type", 1}, {"points", {k}}};
    EXPECT_EQ(found["cells"][static_cast<std::size_t>(k)], vertex);
  }
}

TEST(Frames, TakeHalfTheSpaceWithFloats) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "beads.hdf";
  const Beads beads;
  write_bead_frame(file, beads.frame());

  const auto found = read_by_vtk(file);

  EXPECT_EQ(found["point_data"]["radius_m"]["type"], "float");
  EXPECT_EQ(floats(vectors(found["points"])), floats(beads.x));
  EXPECT_EQ(floats(vectors(found["point_data"]["velocity_m_s"]["values"])), floats(beads.velocity));
  EXPECT_EQ(found["point_data"]["velocity_m_s"]["type"], "float");
  EXPECT_EQ(found["point_data"]["id"]["values"], json(beads.id));
  EXPECT_EQ(found["field_data"]["time_s"]["values"], json::array({0.1}));
}

TEST(Frames, ContactsAreLinesOfTheirOwn) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "contacts.hdf";
  write_contact_frame(file, {.time = 2.0, .contacts = contacts}, {.double_precision = true});

  const auto found = read_by_vtk(file);

  const auto points = vectors(found["points"]);
  ASSERT_EQ(points.size(), 6U);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    EXPECT_EQ(points[2 * k], contacts[k].from);
    EXPECT_EQ(points[2 * k + 1], contacts[k].to);
    const json line = {{"type", 3}, {"points", {2 * k, 2 * k + 1}}};
    EXPECT_EQ(found["cells"][k], line);
  }
  const auto& data = found["cell_data"];
  EXPECT_EQ(data["normal_force_N"]["values"], json({1e-5, 2e-5, -3e-5}));
  EXPECT_EQ(data["tangential_force_N"]["values"], json({2e-6, 0.0, 1e-6}));
  EXPECT_EQ(data["tangential_force_vector_N"]["values"][0], json({0.0, 2e-6, 0.0}));
  EXPECT_EQ(data["overlap_m"]["values"], json({3e-8, 4e-8, 5e-8}));
  EXPECT_EQ(data["id_i"]["values"], json({4, 7, 4}));
  EXPECT_EQ(data["id_j"]["values"], json({7, 5, -3}));
}

TEST(Frames, MayBeEmpty) {
  const TemporaryFolder folder;
  for (const int deflate : {0, 4}) {
    write_contact_frame(folder.path() / "contacts.hdf", {.time = 0.0, .contacts = {}},
                        {.deflate = deflate});
    const auto found = read_by_vtk(folder.path() / "contacts.hdf");
    EXPECT_EQ(found["cells"].size(), 0U);
    EXPECT_EQ(found["points"].size(), 0U);
  }
}

TEST(Frames, CompressedOnesHoldTheSame) {
  const TemporaryFolder folder;
  const auto plain = folder.path() / "plain.hdf";
  const auto packed = folder.path() / "packed.hdf";
  const std::vector<Vec3> x(4000, Vec3{1, 2, 3});
  const std::vector<double> radius(4000, 4.0);
  std::vector<std::int64_t> id(4000);
  for (std::size_t k = 0; k < id.size(); ++k) id[k] = static_cast<std::int64_t>(k * k);
  const BeadFrame frame{.time = 1.0, .x = x, .radius = radius, .id = id, .more = {}};
  write_bead_frame(plain, frame, {.double_precision = true});
  write_bead_frame(packed, frame, {.double_precision = true, .deflate = 4});

  EXPECT_EQ(read_by_vtk(plain), read_by_vtk(packed));
  EXPECT_LT(std::filesystem::file_size(packed), std::filesystem::file_size(plain) / 4);
}

TEST(Frames, HoldHexahedraOfALiquid) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "liquid.hdf";
  const std::vector<Vec3> corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                     {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1},
                                     {0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}};
  const std::vector<std::int64_t> cells = {0, 1, 2, 3, 4, 5, 6, 7, 4, 5, 6, 7, 8, 9, 10, 11};
  const std::vector<double> pressure = {1e5, 2e5};
  write_unstructured_grid(file, {.shape = CellShape::hexahedron,
                                 .points = corners,
                                 .connectivity = cells,
                                 .point_data = {},
                                 .cell_data = {{"pressure_Pa", std::span(pressure)}},
                                 .numbers = {{"time_s", 0.5}, {"step", 7}}});

  const auto found = read_by_vtk(file);

  EXPECT_EQ(vectors(found["points"]), corners);
  EXPECT_EQ(found["cells"][0], json({{"type", 12}, {"points", {0, 1, 2, 3, 4, 5, 6, 7}}}));
  EXPECT_EQ(found["cells"][1], json({{"type", 12}, {"points", {4, 5, 6, 7, 8, 9, 10, 11}}}));
  EXPECT_EQ(found["cell_data"]["pressure_Pa"]["values"], json(pressure));
  EXPECT_EQ(found["field_data"]["step"]["values"], json::array({7}));
}

void expect_the_cells_of(const mesh::ColumnMesh& mesh, const json& found) {
  const auto points = vectors(found["points"]);
  const auto cells = static_cast<std::size_t>(mesh.cell_count());
  ASSERT_EQ(found["cells"].size(), cells);
  for (std::size_t c = 0; c < cells; ++c) {
    const auto& cell = found["cells"][c];
    ASSERT_EQ(cell["type"], 12);
    std::vector<Vec3> p;
    for (const auto& point : cell["points"]) p.push_back(points[point.get<std::size_t>()]);
    ASSERT_EQ(p.size(), 8U);
    const auto& section = mesh.section();
    const double area = section.area[c % section.area.size()];
    // Diagonals of the lower side turn to the upper side, above it.
    const auto diagonals = cross(p[2] - p[0], p[3] - p[1]);
    EXPECT_NEAR(0.5 * diagonals.z, area, 1e-9 * area);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(p[k + 4].x, p[k].x);
      EXPECT_EQ(p[k + 4].y, p[k].y);
      EXPECT_GT(p[k + 4].z, p[k].z);
    }
    const double middle = 0.5 * (p[0].z + p[4].z);
    EXPECT_NEAR(middle, mesh.center(static_cast<std::int64_t>(c)).z, 1e-9 * mesh.top());
    EXPECT_NEAR(0.5 * diagonals.z * (p[4].z - p[0].z), mesh.volume(static_cast<std::int64_t>(c)),
                1e-9 * mesh.volume(static_cast<std::int64_t>(c)));
  }
}

TEST(Frames, OfALiquidHoldTheCellsOfTheMesh) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "liquid_000003.hdf";
  const std::array<mesh::ColumnShape, 2> shapes = {
      mesh::Slice{.inner_diameter = 2e-3, .depth = 0.7e-3, .height = 1e-3},
      mesh::Cylinder{.inner_diameter = 2e-3, .height = 1e-3}};
  for (const auto& shape : shapes) {
    const mesh::ColumnMesh mesh(shape, mesh::cell_counts(shape, {}));
    std::vector<double> eps;
    std::vector<Vec3> u;
    for (std::int64_t c = 0; c < mesh.cell_count(); ++c) {
      eps.push_back(0.001 * static_cast<double>(c));
      u.push_back({static_cast<double>(c), 2.0, mesh.center(c).x});
    }
    write_liquid_frame(file,
                       {.time = 0.3,
                        .mesh = mesh,
                        .cells = {{"void_fraction", std::span<const double>(eps)},
                                  {"velocity_m_s", std::span<const Vec3>(u)}}},
                       {.double_precision = true});

    const auto found = read_by_vtk(file);

    expect_the_cells_of(mesh, found);
    EXPECT_EQ(found["cell_data"]["void_fraction"]["values"], json(eps));
    EXPECT_EQ(vectors(found["cell_data"]["velocity_m_s"]["values"]), u);
    EXPECT_EQ(found["field_data"]["time_s"]["values"], json::array({0.3}));
  }
}

TEST(Frames, OfEqualDataHaveEqualBytes) {
  const TemporaryFolder folder;
  const Beads beads;
  for (const int deflate : {0, 6}) {
    write_bead_frame(folder.path() / "a.hdf", beads.frame(), {.deflate = deflate});
    ::sleep(1);  // so that a time in the file would show
    write_bead_frame(folder.path() / "b.hdf", beads.frame(), {.deflate = deflate});
    EXPECT_EQ(read_text_file(folder.path() / "a.hdf"), read_text_file(folder.path() / "b.hdf"));
  }
}

TEST(Frames, SayWhyTheyCannotBeWritten) {
  const Beads beads;
  EXPECT_THAT(message_of([&] { write_bead_frame("/none/b.hdf", beads.frame()); }),
              HasSubstr("/none/b.hdf: cannot be written (No such file or directory)"));
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "b.hdf");
  EXPECT_THAT(message_of([&] { write_bead_frame(folder.path() / "b.hdf", beads.frame()); }),
              HasSubstr("b.hdf: cannot be written (Is a directory)"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "b.hdf.part"));
}

}  // namespace
}  // namespace packbed::io
