// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "mesh/column_mesh.hpp"

namespace packbed::io {

/// The cross-section of a mesh as an SVG drawing, y up. Cells are shaded by their numbers, light to dark;
/// points inside where other than four cells meet are marked; the round wall is drawn over the facets.
std::string mesh_svg(const mesh::ColumnMesh& mesh, const mesh::ColumnShape& shape);

}  // namespace packbed::io
