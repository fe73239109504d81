// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Shares of the cells of a cross-section in a kernel around a point of the plane.

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/cross_section.hpp"

namespace packbed::coupling {

/// Share of one cell.
struct CellWeight {
  std::int32_t cell = 0;
  double weight = 0.0;
};

/// The kernel is summed over points in the cells, a quarter of its reach apart in the mean, and divided by its
/// sum over the section: shares add up to 1, at walls too, and change smoothly with the point.
class SectionWeights {
 public:
  struct Options {
    double reach = 0.0;  ///< distance from which the kernel is zero [m]
    double periodic_x =
        0.0;  ///< length of the section where its sides are one; 0: they are not [m]
    double periodic_y = 0.0;  ///< likewise [m]
    bool is_empty_y = false;  ///< of one cell in y, which does not count
  };

  /// Throws ValueError for a reach that is not positive or beyond half a periodic length.
  SectionWeights(const mesh::CrossSection& section, const Options& options);

  /// Into `weights`, by rising cell. A point farther than the reach from all cells gives none.
  void at(const mesh::Point& x, std::vector<CellWeight>& weights) const;

 private:
  /// Four points of one cell; those that it does not need have no area.
  struct Samples {
    std::array<double, 4> x{};     ///< [m]
    std::array<double, 4> y{};     ///< [m]; 0 where y does not count
    std::array<double, 4> area{};  ///< [m2]
  };
  void sample_cell(const mesh::CrossSection& section, std::int32_t cell);
  void find_near_cells();
  void add(const mesh::Point& x, std::vector<CellWeight>& weights) const;
  [[nodiscard]] int bucket(double a, std::size_t axis) const;

  Options options_;
  std::vector<Samples> samples_{};              ///< by cell
  std::vector<std::uint32_t> samples_first_{};  ///< of each cell, and the end
  // The plane, as far as the reach beyond all samples, in squares ("buckets").
  std::array<double, 2> low_{};            ///< [m]
  std::array<int, 2> count_{};             ///< in x, y
  std::vector<std::int32_t> near_{};       ///< cells within the reach of some point of a bucket
  std::vector<std::uint32_t> near_first_;  ///< of each bucket, and the end
};

}  // namespace packbed::coupling
