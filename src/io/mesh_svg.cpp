// SPDX-License-Identifier: BSD-3-Clause
#include "io/mesh_svg.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace packbed::io {
namespace {

constexpr double per_mm = 1e3;
constexpr double width = 600.0;  // of the drawing [px]

// y points up here and down in SVG.
std::string place(const mesh::Point& p) {
  return fmt::format("{:.4f},{:.4f}", p.x * per_mm, -p.y * per_mm);
}

std::string cells(const mesh::CrossSection& section) {
  std::string text;
  for (std::size_t c = 0; c < section.cells.size(); ++c) {
    const double share = static_cast<double>(c) / static_cast<double>(section.cells.size());
    std::string corners;
    for (const auto p : section.cells[c]) {
      corners += place(section.points[static_cast<std::size_t>(p)]) + " ";
    }
    corners.pop_back();
    text += fmt::format("<polygon fill=\"hsl(205,55%,{:.0f}%)\" points=\"{}\"/>\n",
                        95.0 - 45.0 * share, corners);
  }
  return text;
}

std::string irregular_points(const mesh::CrossSection& section, double radius) {
  std::vector<int> cells_at(section.points.size(), 0);
  for (const auto& corners : section.cells) {
    for (const auto p : corners) ++cells_at[static_cast<std::size_t>(p)];
  }
  for (const auto& e : section.border) {
    cells_at[static_cast<std::size_t>(e.a)] = cells_at[static_cast<std::size_t>(e.b)] = 0;
  }
  std::string text;
  for (std::size_t p = 0; p < section.points.size(); ++p) {
    // 0: at the border; 1 and 2: at a periodic side
    if (cells_at[p] < 3 || cells_at[p] == 4) continue;
    text += fmt::format("<circle cx=\"{:.4f}\" cy=\"{:.4f}\" r=\"{:.4f}\" fill=\"#c33\"/>\n",
                        section.points[p].x * per_mm, -section.points[p].y * per_mm, radius);
  }
  return text;
}

}  // namespace

std::string mesh_svg(const mesh::ColumnMesh& mesh, const mesh::ColumnShape& shape) {
  const auto& section = mesh.section();
  const auto& low = mesh.locator().low();
  const auto& high = mesh.locator().high();
  const double x = (high.x - low.x) * per_mm;
  const double y = (high.y - low.y) * per_mm;
  const double margin = 0.02 * std::max(x, y);
  const double line = 0.002 * std::max(x, y);
  auto text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" height=\"{:.0f}\" "
      "viewBox=\"{:.4f} {:.4f} {:.4f} {:.4f}\">\n"
      "<title>{} cells in a layer; lengths in mm</title>\n"
      "<g stroke=\"#234\" stroke-width=\"{:.4f}\" stroke-linejoin=\"round\">\n{}</g>\n",
      width, width * (y + 2 * margin) / (x + 2 * margin), low.x * per_mm - margin,
      -high.y * per_mm - margin, x + 2 * margin, y + 2 * margin, section.cells.size(), line,
      cells(section));
  text += irregular_points(section, 4 * line);
  if (const auto* cylinder = std::get_if<mesh::Cylinder>(&shape)) {
    text += fmt::format(
        "<circle cx=\"0\" cy=\"0\" r=\"{:.4f}\" fill=\"none\" stroke=\"#c33\" "
        "stroke-width=\"{:.4f}\"/>\n",
        0.5 * cylinder->inner_diameter * per_mm, line);
  }
  return text + "</svg>\n";
}

}  // namespace packbed::io
