// SPDX-License-Identifier: BSD-3-Clause
#include "io/frames.hpp"

#include <numeric>

namespace packbed::io {
namespace {

std::vector<std::int64_t> zero_to(std::size_t count) {
  std::vector<std::int64_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::int64_t{0});
  return numbers;
}

/// One member of all contacts.
template <class T>
std::vector<T> each(std::span<const ContactLine> contacts, T ContactLine::*member) {
  std::vector<T> values;
  values.reserve(contacts.size());
  for (const auto& c : contacts) values.push_back(c.*member);
  return values;
}

/// Points of all levels of a mesh, those of the outlet first.
std::vector<Vec3> points_of(const mesh::ColumnMesh& mesh) {
  std::vector<Vec3> points;
  for (std::int32_t k = 0; k <= mesh.layers(); ++k) {
    for (const auto& p : mesh.section().points) points.push_back({p.x, p.y, mesh.level(k)});
  }
  return points;
}

/// Corners of all cells: lower side counterclockwise, then the upper one, as VTK wants them.
std::vector<std::int64_t> corners_of(const mesh::ColumnMesh& mesh) {
  std::vector<std::int64_t> corners;
  const auto per_level = static_cast<std::int64_t>(mesh.section().points.size());
  for (std::int64_t k = 0; k < mesh.layers(); ++k) {
    for (const auto& cell : mesh.section().cells) {
      for (const auto level : {k, k + 1}) {
        for (const auto point : cell) corners.push_back(level * per_level + point);
      }
    }
  }
  return corners;
}

}  // namespace

void write_bead_frame(const std::filesystem::path& file,
                      const BeadFrame& frame,
                      const FrameOptions& options) {
  std::vector<double> diameter(frame.radius.begin(), frame.radius.end());
  for (auto& d : diameter) d *= 2.0;
  const auto connectivity = zero_to(frame.x.size());
  UnstructuredGrid grid{.shape = CellShape::vertex,
                        .points = frame.x,
                        .connectivity = connectivity,
                        .point_data = {{"radius_m", frame.radius},
                                       {"diameter_m", std::span<const double>(diameter)},
                                       {"id", frame.id}},
                        .cell_data = {},
                        .numbers = {{"time_s", frame.time}}};
  grid.point_data.insert(grid.point_data.end(), frame.more.begin(), frame.more.end());
  write_unstructured_grid(file, grid, options);
}

void write_contact_frame(const std::filesystem::path& file,
                         const ContactFrame& frame,
                         const FrameOptions& options) {
  std::vector<Vec3> ends;
  ends.reserve(2 * frame.contacts.size());
  for (const auto& c : frame.contacts) {
    ends.push_back(c.from);
    ends.push_back(c.to);
  }
  const auto connectivity = zero_to(ends.size());
  const auto normal = each(frame.contacts, &ContactLine::normal_force);
  const auto tangential = each(frame.contacts, &ContactLine::tangential_force);
  const auto vectors = each(frame.contacts, &ContactLine::tangential);
  const auto overlap = each(frame.contacts, &ContactLine::overlap);
  const auto id_i = each(frame.contacts, &ContactLine::id_i);
  const auto id_j = each(frame.contacts, &ContactLine::id_j);
  write_unstructured_grid(
      file,
      {.shape = CellShape::line,
       .points = ends,
       .connectivity = connectivity,
       .point_data = {},
       .cell_data = {{"normal_force_N", std::span<const double>(normal)},
                     {"tangential_force_N", std::span<const double>(tangential)},
                     {"tangential_force_vector_N", std::span<const Vec3>(vectors)},
                     {"overlap_m", std::span<const double>(overlap)},
                     {"id_i", std::span<const std::int64_t>(id_i)},
                     {"id_j", std::span<const std::int64_t>(id_j)}},
       .numbers = {{"time_s", frame.time}}},
      options);
}

void write_liquid_frame(const std::filesystem::path& file,
                        const LiquidFrame& frame,
                        const FrameOptions& options) {
  const auto points = points_of(frame.mesh);
  const auto corners = corners_of(frame.mesh);
  write_unstructured_grid(file,
                          {.shape = CellShape::hexahedron,
                           .points = points,
                           .connectivity = corners,
                           .point_data = {},
                           .cell_data = frame.cells,
                           .numbers = {{"time_s", frame.time}}},
                          options);
}

}  // namespace packbed::io
