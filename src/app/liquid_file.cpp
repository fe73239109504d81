// SPDX-License-Identifier: BSD-3-Clause
#include "app/liquid_file.hpp"

#include <tuple>
#include <utility>

#include "core/sorted_shares.hpp"

namespace packbed::app {
namespace {

constexpr std::size_t cell_width = 14;
constexpr std::size_t face_width = 4;

void append(std::vector<double>& values, const Vec3& a) {
  values.insert(values.end(), {a.x, a.y, a.z});
}

Vec3 vec3_at(const double* v) { return {v[0], v[1], v[2]}; }

}  // namespace

void write_fluid_state(io::CheckpointWriter& writer, const fluid::FluidState& state) {
  auto share = state;
  share.cells = sorted_shares(
      std::move(share.cells), [](const auto& c) { return std::tuple(c.cell); }, Ranks::all());
  share.faces = sorted_shares(
      std::move(share.faces), [](const auto& f) { return std::tuple(f.face, f.owner); },
      Ranks::all());
  std::vector<std::int64_t> cells;
  std::vector<double> values;
  for (const auto& c : share.cells) {
    cells.push_back(c.cell);
    values.insert(values.end(), {c.eps, c.p});
    for (const auto& a : {c.u, c.grad_p, c.force, c.drag}) append(values, a);
  }
  writer.array("liquid/cell", cells);
  writer.array("liquid/cell_values", values, cell_width);
  std::vector<std::int64_t> faces;
  values.clear();
  for (const auto& f : share.faces) {
    faces.insert(faces.end(), {f.face, f.owner});
    values.insert(values.end(), {f.q, f.flux, f.pressure, f.conductance});
  }
  writer.array("liquid/face", faces, 2);
  writer.array("liquid/face_values", values, face_width);
  writer.number("liquid/time_s", share.time);
  writer.number("liquid/top_m", share.top);
  writer.number("liquid/inlet_m_s", share.inlet);
  writer.number("liquid/per_decade", share.per_decade);
}

bool has_fluid_state(const io::CheckpointReader& reader) { return reader.has_array("liquid/cell"); }

fluid::FluidState read_fluid_state(const io::CheckpointReader& reader) {
  fluid::FluidState s;
  s.time = reader.number("liquid/time_s");
  s.top = reader.number("liquid/top_m");
  s.inlet = reader.number("liquid/inlet_m_s");
  s.per_decade = reader.number("liquid/per_decade");
  const auto cells = reader.read<std::int64_t>("liquid/cell");
  const auto cell_values = reader.read<double>("liquid/cell_values");
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const double* v = &cell_values[cell_width * k];
    s.cells.push_back({.cell = cells[k],
                       .eps = v[0],
                       .p = v[1],
                       .u = vec3_at(v + 2),
                       .grad_p = vec3_at(v + 5),
                       .force = vec3_at(v + 8),
                       .drag = vec3_at(v + 11)});
  }
  const auto faces = reader.read<std::int64_t>("liquid/face");
  const auto face_values = reader.read<double>("liquid/face_values");
  for (std::size_t k = 0; 2 * k < faces.size(); ++k) {
    const double* v = &face_values[face_width * k];
    s.faces.push_back({.face = faces[2 * k],
                       .owner = faces[2 * k + 1],
                       .q = v[0],
                       .flux = v[1],
                       .pressure = v[2],
                       .conductance = v[3]});
  }
  return s;
}

}  // namespace packbed::app
