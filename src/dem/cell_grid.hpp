// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Beads sorted into cells, one number of each bead beside the other, so that distances are compared
/// eight at a time. Cells along x stand side by side, so that neighbors come in rows.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/aligned.hpp"
#include "dem/domain.hpp"
#include "dem/particles.hpp"

namespace packbed::dem {

class CellGrid {
 public:
  static constexpr std::size_t lanes = 8;

  /// Cells are at least `width` wide [m]; wider where beads lie far apart.
  CellGrid(const Particles& particles, const Domain& domain, double width);

  /// Calls visit(place, image) for each bead (every image of it) whose surface is nearer than `gap` to a
  /// sphere at x and whose radius is not larger than that of the sphere.
  template <class Visit>
  void for_smaller_near(const Vec3& x, double radius, double gap, Visit visit) const {
    constexpr double margin = 1.0 + 1e-9;  // of rounding in cells
    const double reach = margin * (2.0 * radius + gap);
    const Range z_cells = range(2, x.z, reach);
    const Range y_cells = range(1, x.y, reach);
    const Range x_cells = range(0, x.x, reach);
    Image image{};
    for (int z = z_cells.first; z <= z_cells.last; ++z) {
      const int slab = around(2, z, image) * count_[1];
      for (int y = y_cells.first; y <= y_cells.last; ++y) {
        const std::size_t row = row_start(slab + around(1, y, image));
        for (int c = x_cells.first; c <= x_cells.last;) {  // cells of one image stand side by side
          const int begin = around(0, c, image);
          const int end = std::min(begin + x_cells.last - c, count_[0] - 1);
          visit_row(start_[row + static_cast<std::size_t>(begin)],
                    start_[row + static_cast<std::size_t>(end) + 1], x - offset(domain_, image),
                    radius, gap, image, visit);
          c += end - begin + 1;
        }
      }
    }
  }

 private:
  struct Range {
    int first = 0;
    int last = 0;
  };

  template <class Visit>
  void visit_row(std::size_t first,
                 std::size_t last,
                 const Vec3& x,
                 double radius,
                 double gap,
                 const Image& image,
                 Visit visit) const {
    for (std::size_t k = first; k < last; k += lanes) {
      unsigned near = near_lanes(k, x, radius, gap);
      if (last - k < lanes) near &= (1U << (last - k)) - 1U;
      for (; near != 0; near &= near - 1) {
        visit(place_[k + static_cast<std::size_t>(__builtin_ctz(near))], image);
      }
    }
  }

  /// One bit for each of eight beads from the k-th on that is near and not larger.
  [[nodiscard]] unsigned near_lanes(std::size_t k, const Vec3& x, double radius, double gap) const {
    using Eight = double __attribute__((vector_size(64), aligned(8), may_alias));
    const auto at = [k](const AlignedVector<double>& a) {
      return reinterpret_cast<const Eight&>(a[k]);
    };
    const Eight dx = x.x - at(x_);
    const Eight dy = x.y - at(y_);
    const Eight dz = x.z - at(z_);
    const Eight r = at(radius_);
    const Eight near = radius + r + gap;
    const auto is_near = (dx * dx + dy * dy + dz * dz < near * near) & (r <= radius);
#ifdef __AVX512DQ__
    return static_cast<unsigned char>(_mm512_movepi64_mask(reinterpret_cast<__m512i>(is_near)));
#else
    unsigned bits = 0;
    for (int lane = 0; lane < 8; ++lane) bits |= is_near[lane] != 0 ? 1U << lane : 0U;
    return bits;
#endif
  }

  [[nodiscard]] std::size_t cells() const {
    return static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]) *
           static_cast<std::size_t>(count_[2]);
  }
  void lay_out(const Particles& particles, std::size_t axis, double width);
  void sort_beads(const Particles& particles);

  /// Cell of a coordinate: inside the box, unless the axis is periodic.
  [[nodiscard]] int cell(std::size_t axis, double x) const {
    const double c = std::floor((x - low_[axis]) * per_length_[axis]);
    return static_cast<int>(domain_.periodic[axis] ? c : std::clamp(c, 0.0, count_[axis] - 1.0));
  }
  [[nodiscard]] Range range(std::size_t axis, double x, double reach) const {
    return {cell(axis, x - reach), cell(axis, x + reach)};
  }

  /// Cell c taken around a periodic side, with the image that is then meant.
  int around(std::size_t axis, int c, Image& image) const {
    const int n = count_[axis];
    if (c >= 0 && c < n) {
      image[axis] = 0;
      return c;
    }
    const int turns = c >= 0 ? c / n : -((-c + n - 1) / n);
    image[axis] = static_cast<std::int8_t>(turns);
    return c - turns * n;
  }

  /// First cell of a row along x.
  [[nodiscard]] std::size_t row_start(int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(count_[0]);
  }

  Domain domain_;
  std::array<double, 3> low_{}, per_length_{};
  std::array<int, 3> count_{};
  AlignedVector<std::uint32_t> start_{};  ///< of each cell, and the end
  AlignedVector<std::uint32_t> place_{};  ///< of the beads, by cell
  AlignedVector<double> x_{}, y_{}, z_{}, radius_{};
};

}  // namespace packbed::dem
