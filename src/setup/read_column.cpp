// SPDX-License-Identifier: BSD-3-Clause
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "setup/read_sections.hpp"

namespace packbed::setup {
namespace {

mesh::Slice read_slice(Section& section) {
  section.refuse("size",
                 "does not apply to shape = \"slice\"; give inner_diameter, slice_depth "
                 "and height");
  section.refuse("boundaries", "does not apply to shape = \"slice\"; x has walls, y is periodic");
  return {.inner_diameter = section.quantity("inner_diameter", Dimension::length, bounds::positive),
          .depth = section.quantity("slice_depth", Dimension::length, bounds::positive),
          .height = section.quantity("height", Dimension::length, bounds::positive)};
}

mesh::Cylinder read_cylinder(Section& section) {
  section.refuse("size", "does not apply to shape = \"cylinder\"; give inner_diameter and height");
  section.refuse("boundaries", "does not apply to shape = \"cylinder\"");
  section.refuse("slice_depth", "does not apply to shape = \"cylinder\"");
  return {.inner_diameter = section.quantity("inner_diameter", Dimension::length, bounds::positive),
          .height = section.quantity("height", Dimension::length, bounds::positive)};
}

mesh::Box read_box(Section& section) {
  for (const auto* key : {"inner_diameter", "slice_depth", "height"}) {
    section.refuse(key, "does not apply to shape = \"box\"; give size = [x, y, z]");
  }
  mesh::Box box{};
  box.size = section.three_quantities("size", Dimension::length, bounds::positive);
  auto sides = section.table("boundaries");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    constexpr std::array<std::string_view, 3> names = {"x", "y", "z"};
    box.boundaries[axis] = static_cast<mesh::Boundary>(
        sides.choice(names[axis], {"periodic", "wall", "open"}, Fallback{"wall"}));
  }
  sides.finish();
  return box;
}

// Stiffer than any bead: thesis table B.2.
Material read_material(Section& section) {
  const Fallback modulus{"10 GPa", "default: thesis table B.2"};
  const Fallback poisson{"0.5", "default: thesis table B.2"};
  const Material material{.youngs_modulus = section.quantity("youngs_modulus", Dimension::pressure,
                                                             bounds::positive, modulus),
                          .poisson_ratio = section.quantity("poisson_ratio", Dimension::fraction,
                                                            bounds::poisson_ratio, poisson)};
  return material;
}

Material read_wall(Section section) {
  const auto material = read_material(section);
  section.finish();
  return material;
}

void read_frits(Section section, ColumnOptions& column, bool has_liquid) {
  column.frit = read_material(section);
  for (const auto& [key, resistance] :
       {std::pair{"inlet_resistance", &column.inlet_resistance},
        std::pair{"outlet_resistance", &column.outlet_resistance}}) {
    if (has_liquid) {
      *resistance =
          section.quantity(key, Dimension::inverse_length, bounds::not_negative, Fallback{"0 m-1"});
    } else {
      section.refuse(key, "needs a [liquid] section");
    }
  }
  section.finish();
}

mesh::ColumnShape read_shape(Section& section) {
  switch (section.choice("shape", {"slice", "cylinder", "box"})) {
    case 0:
      return read_slice(section);
    case 1:
      return read_cylinder(section);
    default:
      return read_box(section);
  }
}

std::string_view shape_name(const mesh::ColumnShape& shape) {
  return std::holds_alternative<mesh::Slice>(shape) ? "slice" : "box";
}

void refuse_counts_of_other_shapes(Section& section, const mesh::ColumnShape& shape) {
  if (std::holds_alternative<mesh::Cylinder>(shape)) {
    for (const auto* key : {"cells_x", "cells_y"}) {
      section.refuse(key, "does not apply to shape = \"cylinder\"; give core and ring");
    }
    return;
  }
  for (const auto* key : {"core", "ring"}) {
    section.refuse(key, fmt::format("does not apply to shape = \"{}\"; give cells_x and cells_y",
                                    shape_name(shape)));
  }
}

// Cells of about 0.35 mm are the thesis's (table 5.2) in x and y; in z it has 1.17 mm.
mesh::MeshOptions read_mesh(Section section, const mesh::ColumnShape& shape) {
  section.mention({"cell", "cells_x", "cells_y", "core", "ring", "layers"});
  refuse_counts_of_other_shapes(section, shape);
  mesh::MeshOptions options;
  options.cell = section.quantity("cell", Dimension::length, bounds::positive,
                                  Fallback{"0.35 mm", "default: thesis table 5.2"});
  if (std::holds_alternative<mesh::Cylinder>(shape)) {
    options.core = section.optional_integer("core", 2);
    options.ring = section.optional_integer("ring", 1);
  } else {
    options.cells_x = section.optional_integer("cells_x", 1);
    options.cells_y = section.optional_integer("cells_y", 1);
  }
  options.layers = section.optional_integer("layers", 1);
  section.finish();
  try {
    mesh::cell_counts(shape, options);
  } catch (const ValueError& error) {
    section.fail_here(fmt::format("{}; give a larger cell or fewer of them", error.what()));
  }
  return options;
}

}  // namespace

ColumnOptions read_column(Section section, bool has_liquid) {
  section.mention({"shape", "inner_diameter", "slice_depth", "height", "size", "boundaries", "wall",
                   "frit", "mesh", "full_load"});
  ColumnOptions column;
  column.shape = read_shape(section);
  column.full_load = section.optional_flow("full_load", mesh::flow_cross_section(column.shape));
  if (column.full_load && *column.full_load <= 0.0) section.fail("full_load", "must be positive");
  if (column.full_load && !has_liquid) section.fail("full_load", "needs a [liquid] section");
  column.wall = read_wall(section.table("wall"));
  if (std::holds_alternative<mesh::Box>(column.shape)) {
    section.refuse("frit", "does not apply to shape = \"box\", whose walls are all column.wall");
    column.frit = column.wall;
  } else {
    read_frits(section.table("frit"), column, has_liquid);
  }
  if (has_liquid) {
    column.mesh = read_mesh(section.table("mesh"), column.shape);
  } else {
    section.refuse("mesh", "does not apply to a dry column; the mesh is for a [liquid]");
  }
  section.finish();
  return column;
}

namespace {

/// The flow of the first step "flow_pack" in a list of steps, as text.
std::optional<std::string> flow_of_packing(const toml::array* steps) {
  if (steps == nullptr) return std::nullopt;
  for (const auto& node : *steps) {
    const auto* step = node.as_table();
    if (step == nullptr) continue;
    if (step->at_path("step").value<std::string>() == "flow_pack") {
      return step->at_path("flow").value<std::string>();
    }
    if (auto inner = flow_of_packing(step->at_path("steps").as_array())) return inner;
  }
  return std::nullopt;
}

}  // namespace

// A flow that cannot be read is refused where its step is.
std::optional<double> full_load(const ColumnOptions& column,
                                const toml::table& file,
                                const Reading& reading) {
  if (column.full_load) return column.full_load;
  const auto text = flow_of_packing(file.at_path("protocol").as_array());
  if (!text) return std::nullopt;
  try {
    return to_velocity(*text, mesh::flow_cross_section(column.shape), reading);
  } catch (const ValueError&) {
    return std::nullopt;
  }
}

}  // namespace packbed::setup
