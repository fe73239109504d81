// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// A plane mesh of convex quadrilaterals: what a column mesh is extruded from, along z.

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace packbed::mesh {

struct Point {
  double x = 0.0;  ///< [m]
  double y = 0.0;  ///< [m]
};

/// Pieces of the border of a column mesh.
enum class Patch : std::uint8_t { inlet, outlet, wall, x_low, x_high, y_low, y_high };
inline constexpr std::array<const char*, 7> patch_names = {"inlet",  "outlet", "wall",  "x_low",
                                                           "x_high", "y_low",  "y_high"};

/// Edge between two cells. The owner lies to the left of a -> b, so (dy, -dx) points to the neighbor.
struct InnerEdge {
  std::int32_t a = 0;
  std::int32_t b = 0;
  std::int32_t owner = 0;  ///< < neighbor
  std::int32_t neighbor = 0;
  Point
      shift;  ///< to be added to the neighbor to see it from the owner: not 0 over a periodic side
};

/// Edge at the border; its cell lies to the left of a -> b.
struct BorderEdge {
  std::int32_t a = 0;
  std::int32_t b = 0;
  std::int32_t cell = 0;
  Patch patch = Patch::wall;
};

struct CrossSection {
  std::vector<Point> points{};
  std::vector<std::array<std::int32_t, 4>> cells{};  ///< corners, counterclockwise
  std::vector<InnerEdge> inner{};                    ///< sorted by owner, neighbor
  std::vector<BorderEdge> border{};                  ///< sorted by patch, cell
  std::vector<double> area{};                        ///< one per cell [m2]
  std::vector<Point> center{};                       ///< centroids, one per cell
  /// Cells that share a corner with a cell, itself and periodic images included, in rising order; those of
  /// cell c are vertex_neighbor[first_neighbor[c]] and following.
  std::vector<std::int32_t> vertex_neighbor{};
  std::vector<std::int32_t> first_neighbor{};  ///< one per cell, and the end

  [[nodiscard]] std::int32_t cell_count() const { return static_cast<std::int32_t>(cells.size()); }
};

struct AreaAndCenter {
  double area = 0.0;  ///< [m2]
  Point center{};     ///< centroid
};

/// Of a quadrilateral, corners counterclockwise.
AreaAndCenter measure(const std::vector<Point>& points, const std::array<std::int32_t, 4>& corners);

/// Whether the two sides of a rectangle in x, in y are one.
struct PeriodicSides {
  bool x = false;
  bool y = false;
};

/// nx x ny equal cells over a rectangle; cell (i, j) has the number j nx + i. A periodic direction of a
/// single cell keeps its two sides as patches, since a face needs two cells.
CrossSection rectangle_section(
    const Point& low, const Point& high, std::int32_t nx, std::int32_t ny, PeriodicSides periodic);

/// Fills edges, areas, centers and neighbors in from points and cells. `patch_of` tells where an edge
/// (a, b) of the border belongs; sides that are periodic are joined edge by edge.
void connect(CrossSection& section,
             const std::function<Patch(std::int32_t, std::int32_t)>& patch_of,
             PeriodicSides periodic);

}  // namespace packbed::mesh
