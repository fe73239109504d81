// SPDX-License-Identifier: BSD-3-Clause
#include "io/mesh_svg.hpp"

#include <gtest/gtest.h>

namespace packbed::io {
namespace {

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

std::string drawing(const mesh::ColumnShape& shape, const mesh::MeshOptions& options) {
  return mesh_svg({shape, mesh::cell_counts(shape, options)}, shape);
}

TEST(MeshSvg, DrawsEachCellAndTheFourPointsWhereThreeBlocksMeet) {
  const auto svg = drawing(mesh::Cylinder{.inner_diameter = 10e-3, .height = 70e-3}, {});

  EXPECT_EQ(count(svg, "<polygon"), 588);
  EXPECT_EQ(count(svg, "<circle"), 4 + 1);  // and the wall
}

TEST(MeshSvg, PutsCornersInMillimetersWithYUp) {
  const mesh::Box box{.size = {2e-3, 1e-3, 1e-3}, .boundaries = {}};
  const auto svg = drawing(box, {.cells_x = 1, .cells_y = 1});

  EXPECT_NE(svg.find("0.0000,-0.0000 2.0000,-0.0000 2.0000,-1.0000 0.0000,-1.0000"),
            std::string::npos)
      << svg;
}

}  // namespace
}  // namespace packbed::io
