// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Which cell of a cross-section holds a point.

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/cross_section.hpp"

namespace packbed::mesh {

/// A cell is bounded by the lines of its inner edges alone; its edges at the border do not bound. Cells at
/// the border thus reach outward between their other edges, and every point of the plane is in a cell.
/// A point on an edge or corner is in the lowest-numbered cell there; where rounding at a corner leaves
/// a point in none, in the one that it misses by the least.
///
/// Edges over a periodic side do not bound either: the two cells there lie apart.
class SectionLocator {
 public:
  explicit SectionLocator(const CrossSection& section);

  /// Points outside of the bounding box count as the nearest point of the box.
  [[nodiscard]] std::int32_t cell_at(const Point& p) const;

  /// Cells that cell_at may give for points within `reach` [m] of p in x and in y, in rising order;
  /// perhaps a few more.
  [[nodiscard]] std::vector<std::int32_t> cells_within(const Point& p, double reach) const;

  [[nodiscard]] const Point& low() const { return low_; }    ///< of the bounding box
  [[nodiscard]] const Point& high() const { return high_; }  ///< of the bounding box

 private:
  /// Line of an edge; gives the distance of a point [m], positive on the side of the cell.
  struct Line {
    Point normal;
    Point through;
    double operator()(const Point& p) const;
  };
  struct Cell {
    std::array<Line, 4> lines;
    std::size_t count = 0;  ///< of lines that bound it
    /// Distance from the nearest of its lines [m]; negative outside.
    [[nodiscard]] double depth(const Point& p) const;
  };
  using Range = std::array<std::size_t, 4>;  ///< first and last bucket in x, in y
  [[nodiscard]] std::size_t bucket(double a, std::size_t axis) const;
  [[nodiscard]] bool may_meet(std::size_t cell, std::size_t bx, std::size_t by) const;
  void bound_cells(const CrossSection& section);
  [[nodiscard]] std::vector<Point> reach_of(std::size_t cell) const;
  [[nodiscard]] Range range_of(std::size_t cell) const;
  void fill_buckets();

  std::vector<Cell> cells_;
  Point low_;
  Point high_;
  std::array<std::size_t, 2> count_{};  ///< buckets in x, y
  std::array<double, 2> width_{};       ///< of a bucket [m]
  std::vector<std::int32_t> first_;     ///< of each bucket in candidates_, and the end
  std::vector<std::int32_t> candidates_;
};

}  // namespace packbed::mesh
