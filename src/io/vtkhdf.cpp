// SPDX-License-Identifier: BSD-3-Clause
#include "io/vtkhdf.hpp"

#include <array>
#include <cassert>
#include <numeric>
#include <type_traits>

#include "io/durable_file.hpp"
#include "io/hdf5.hpp"

namespace packbed::io {
namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double));

std::int64_t points_per_cell(CellShape shape) {
  switch (shape) {
    case CellShape::vertex:
      return 1;
    case CellShape::line:
      return 2;
    case CellShape::quadrilateral:
      return 4;
    case CellShape::hexahedron:
      return 8;
  }
  return 0;
}

/// Puts arrays into groups of the file, real numbers as short as the options want them.
class Filler {
 public:
  explicit Filler(const FrameOptions& options) : options_(options) {}

  template <class T>
  void add(const hdf5::Object& group, const std::string& name, std::span<const T> values) const {
    write(group, name, hdf5::element_of<T>(), values.size(), 1, values.data());
  }
  void add(const hdf5::Object& group, const std::string& name, std::span<const Vec3> values) const {
    write(group, name, hdf5::Element::float64, values.size(), 3, values.data());
  }
  /// Arrays of `size` values each.
  void add(const hdf5::Object& root,
           const std::string& group_name,
           const std::vector<FrameArray>& arrays,
           std::size_t size) const {
    const auto group = root.create_group(group_name);
    for (const auto& array : arrays) {
      std::visit(
          [&](const auto& values) {
            assert(values.size() == size);
            add(group, array.name, values);
          },
          array.values);
    }
    static_cast<void>(size);  // asserted only
  }

 private:
  void write(const hdf5::Object& group,
             const std::string& name,
             hdf5::Element element,
             std::size_t rows,
             std::size_t width,
             const void* values) const {
    const hdf5::ArrayForm given{
        .element = element, .rows = static_cast<std::int64_t>(rows), .width = width};
    auto stored = given;
    stored.deflate = options_.deflate;
    if (element == hdf5::Element::float64 && !options_.double_precision) {
      stored.element = hdf5::Element::float32;
    }
    group.create_array(name, stored).write_rows(0, given, values);
  }

  FrameOptions options_;
};

/// Where the points of each cell begin in the connectivity, and where the last one's end.
std::vector<std::int64_t> offsets(std::int64_t cells, std::int64_t per_cell) {
  std::vector<std::int64_t> starts(static_cast<std::size_t>(cells + 1));
  for (std::size_t c = 0; c < starts.size(); ++c)
    starts[c] = static_cast<std::int64_t>(c) * per_cell;
  return starts;
}

void add_cells(const hdf5::Object& root, const UnstructuredGrid& grid, const Filler& fill) {
  const auto per_cell = points_per_cell(grid.shape);
  const auto ids = static_cast<std::int64_t>(grid.connectivity.size());
  assert(ids % per_cell == 0);
  const auto cells = ids / per_cell;
  const auto points = static_cast<std::int64_t>(grid.points.size());
  // Counts are lists, of one part here: VTK lets several processes write parts.
  fill.add(root, "NumberOfPoints", std::span<const std::int64_t>(&points, 1));
  fill.add(root, "NumberOfCells", std::span<const std::int64_t>(&cells, 1));
  fill.add(root, "NumberOfConnectivityIds", std::span<const std::int64_t>(&ids, 1));
  fill.add(root, "Points", grid.points);
  fill.add(root, "Connectivity", grid.connectivity);
  fill.add<std::int64_t>(root, "Offsets", offsets(cells, per_cell));
  const std::vector<std::uint8_t> types(static_cast<std::size_t>(cells),
                                        static_cast<std::uint8_t>(grid.shape));
  fill.add<std::uint8_t>(root, "Types", types);
}

}  // namespace

void write_unstructured_grid(const std::filesystem::path& file,
                             const UnstructuredGrid& grid,
                             const FrameOptions& options) {
  const auto content = hdf5::create_in_memory(file);
  {
    const auto root = content.create_group("VTKHDF");
    root.write_attribute("Type", "UnstructuredGrid");
    root.write_attribute("Version", std::array<std::int64_t, 2>{1, 0});
    const Filler fill(options);
    add_cells(root, grid, fill);
    fill.add(root, "PointData", grid.point_data, grid.points.size());
    const auto per_cell = static_cast<std::size_t>(points_per_cell(grid.shape));
    fill.add(root, "CellData", grid.cell_data, grid.connectivity.size() / per_cell);
    const auto numbers = root.create_group("FieldData");
    for (const auto& [name, value] : grid.numbers) {
      Filler({.double_precision = true}).add(numbers, name, std::span<const double>(&value, 1));
    }
  }
  write_durably(file, content.image());
}

}  // namespace packbed::io
