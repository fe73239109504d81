// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "mesh/column_mesh.hpp"

namespace packbed::test {

/// A mesh with a name, for tests over all shapes.
struct NamedShape {
  std::string name;
  mesh::ColumnShape shape;
  mesh::MeshOptions options;

  [[nodiscard]] mesh::ColumnMesh mesh() const { return {shape, mesh::cell_counts(shape, options)}; }
  friend std::ostream& operator<<(std::ostream& out, const NamedShape& s) { return out << s.name; }
};

/// Every shape, every kind of side, and the smallest meshes.
inline std::vector<NamedShape> mesh_shapes() {
  using enum mesh::Boundary;
  const mesh::Slice slice{.inner_diameter = 4e-3, .depth = 0.9e-3, .height = 6e-3};
  const mesh::Cylinder cylinder{.inner_diameter = 10e-3, .height = 3e-3};
  const auto box = [](mesh::Boundary x, mesh::Boundary y, mesh::Boundary z) {
    return mesh::Box{.size = {2e-3, 1.5e-3, 2.5e-3}, .boundaries = {x, y, z}};
  };
  return {{"slice", slice, {}},
          {"slice_of_two", slice, {.cells_y = 2}},
          {"slice_of_three", slice, {.cells_y = 3}},
          {"cylinder", cylinder, {}},
          {"cylinder_odd", cylinder, {.core = 7, .ring = 5}},
          {"cylinder_coarsest", cylinder, {.core = 2, .ring = 1, .layers = 1}},
          {"box", box(wall, wall, wall), {}},
          {"box_periodic", box(periodic, periodic, periodic), {}},
          {"box_periodic_of_two", box(periodic, periodic, periodic), {.cell = 1e-3}},
          {"box_open_of_one", box(open, periodic, open), {.cell = 1e-2}}};
}

}  // namespace packbed::test
