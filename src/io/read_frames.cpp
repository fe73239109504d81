// SPDX-License-Identifier: BSD-3-Clause
#include "io/read_frames.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/error.hpp"
#include "io/frame_series.hpp"
#include "io/hdf5.hpp"

namespace packbed::io {
namespace {

/// The open grid of a frame, which knows its file for messages.
class Grid {
 public:
  Grid(const std::filesystem::path& file, const char* what)
      : file_(file), what_(what), open_(hdf5::open_file(file)), root_(open_root()) {}

  [[nodiscard]] bool has(const std::string& name) const { return root_.has(name); }
  [[nodiscard]] double time() const { return numbers("FieldData/time_s", 1).front(); }
  /// Rows of an array, or those that are expected.
  [[nodiscard]] std::vector<double> numbers(const std::string& name,
                                            std::optional<std::size_t> rows = {}) const {
    auto values = read<double>(name, rows, 1, hdf5::Element::float64);
    for (const double v : values) check_finite(name, v);
    return values;
  }
  [[nodiscard]] std::vector<Vec3> vectors(const std::string& name,
                                          std::optional<std::size_t> rows = {}) const {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    auto values = read<Vec3>(name, rows, 3, hdf5::Element::float64);
    for (const auto& v : values) check_finite(name, v.x + v.y + v.z);
    return values;
  }
  [[nodiscard]] std::vector<std::int64_t> integers(const std::string& name,
                                                   std::optional<std::size_t> rows = {}) const {
    return read<std::int64_t>(name, rows, 1, hdf5::Element::int64);
  }
  /// Points of all cells, `per_cell` each.
  [[nodiscard]] std::vector<Vec3> corners(std::size_t per_cell) const {
    const auto points = vectors("Points");
    const auto ids = integers("Connectivity");
    if (ids.size() % per_cell != 0) fail("its cells are of another shape");
    std::vector<Vec3> all;
    all.reserve(ids.size());
    for (const auto id : ids) {
      if (id < 0 || static_cast<std::size_t>(id) >= points.size()) {
        fail(fmt::format("a cell has point {}, of {} points", id, points.size()));
      }
      all.push_back(points[static_cast<std::size_t>(id)]);
    }
    return all;
  }
  [[noreturn]] void fail(const std::string& why) const {
    throw DataError(
        fmt::format("{}: it is no frame of {}, or it is damaged ({})", file_.string(), what_, why));
  }

 private:
  [[nodiscard]] hdf5::Object open_root() const {
    if (!open_.has("VTKHDF")) fail("it has no group \"VTKHDF\"");
    return open_.open_group("VTKHDF");
  }
  template <class T>
  std::vector<T> read(const std::string& name,
                      std::optional<std::size_t> rows,
                      std::size_t width,
                      hdf5::Element element) const {
    if (!root_.has(name)) fail(fmt::format("it has no array \"{}\"", name));
    const auto array = root_.open_array(name);
    const auto form = array.form();
    if (form.width != width || (rows && form.rows != static_cast<std::int64_t>(*rows))) {
      fail(fmt::format("array \"{}\" has {} x {} values", name, form.rows, form.width));
    }
    std::vector<T> values(static_cast<std::size_t>(form.rows));
    if (!values.empty()) {
      array.read_rows(0, {.element = element, .rows = form.rows, .width = width}, values.data());
    }
    return values;
  }
  void check_finite(const std::string& name, double value) const {
    if (!std::isfinite(value)) {
      fail(fmt::format("array \"{}\" has a value that is not finite", name));
    }
  }

  std::filesystem::path file_;
  const char* what_;
  hdf5::Object open_;
  hdf5::Object root_;
};

/// Upright cells: lower side, then the upper one above it. The lower side is cut into two triangles.
struct Prism {
  Vec3 center;
  double volume = 0.0;
};
Prism prism_of(const Vec3* p) {
  double area = 0.0;
  Vec3 moment;
  for (const auto& [a, b, c] : {std::array{p[0], p[1], p[2]}, std::array{p[0], p[2], p[3]}}) {
    const double part = 0.5 * cross(b - a, c - a).z;
    area += part;
    moment += part / 3.0 * (a + b + c);
  }
  Vec3 center = 1.0 / area * moment;
  center.z = 0.5 * (p[0].z + p[4].z);
  return {center, area * (p[4].z - p[0].z)};
}

}  // namespace

std::vector<ListedFrame> listed_frames(const std::filesystem::path& folder,
                                       const std::string& name) {
  const auto series = FrameSeries::read(folder, name);
  std::vector<ListedFrame> frames;
  for (std::size_t k = 0; k < series.size(); ++k) {
    frames.push_back({.number = series.numbers()[k],
                      .time = series.times()[k],
                      .file = series.file(series.numbers()[k])});
  }
  return frames;
}

StoredBeads read_bead_frame(const std::filesystem::path& file) {
  const Grid grid(file, "beads");
  StoredBeads beads;
  beads.time = grid.time();
  beads.x = grid.vectors("Points");
  const auto count = beads.x.size();
  beads.radius = grid.numbers("PointData/radius_m", count);
  beads.id = grid.integers("PointData/id", count);
  beads.velocity = grid.vectors("PointData/velocity_m_s", count);
  if (std::ranges::any_of(beads.radius, [](double r) { return !(r > 0.0); })) {
    grid.fail("a radius is not positive");
  }
  return beads;
}

StoredContacts read_contact_frame(const std::filesystem::path& file) {
  const Grid grid(file, "contacts");
  StoredContacts stored;
  stored.time = grid.time();
  const auto ends = grid.corners(2);
  const auto count = ends.size() / 2;
  const auto normal = grid.numbers("CellData/normal_force_N", count);
  const auto amount = grid.numbers("CellData/tangential_force_N", count);
  const auto overlap = grid.numbers("CellData/overlap_m", count);
  const auto id_i = grid.integers("CellData/id_i", count);
  const auto id_j = grid.integers("CellData/id_j", count);
  constexpr auto vectors = "CellData/tangential_force_vector_N";
  stored.has_tangential_vectors = grid.has(vectors);
  const auto tangential =
      stored.has_tangential_vectors ? grid.vectors(vectors, count) : std::vector<Vec3>(count);
  stored.contacts.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    stored.contacts.push_back({.from = ends[2 * k],
                               .to = ends[2 * k + 1],
                               .id_i = id_i[k],
                               .id_j = id_j[k],
                               .normal_force = normal[k],
                               .tangential_force = amount[k],
                               .overlap = overlap[k],
                               .tangential = tangential[k]});
  }
  return stored;
}

StoredLiquid read_liquid_frame(const std::filesystem::path& file) {
  const Grid grid(file, "the liquid");
  StoredLiquid liquid;
  liquid.time = grid.time();
  constexpr std::size_t per_cell = 8;
  const auto corners = grid.corners(per_cell);
  const auto count = corners.size() / per_cell;
  for (std::size_t c = 0; c < count; ++c) {
    const auto prism = prism_of(&corners[per_cell * c]);
    if (!(prism.volume > 0.0)) grid.fail(fmt::format("cell {} has no volume", c));
    liquid.center.push_back(prism.center);
    liquid.volume.push_back(prism.volume);
  }
  liquid.void_fraction = grid.numbers("CellData/void_fraction", count);
  liquid.velocity = grid.vectors("CellData/velocity_m_s", count);
  liquid.pressure = grid.numbers("CellData/pressure_Pa", count);
  return liquid;
}

}  // namespace packbed::io
