// SPDX-License-Identifier: BSD-3-Clause
#include "dem/cloud_neighbors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace packbed::dem {
namespace {

/// Cells across the room, with a copy of the beads of each, row by row along x.
class Cells {
 public:
  struct Bead {
    Vec3 x;
    double diameter;
    std::int32_t index;
  };

  Cells(const Room& room, std::span<const Vec3> x, std::span<const double> diameters, double width)
      : periodic_(room.sides.periodic) {
    constexpr double most_cells = 4096.0;
    low_ = {room.sides.low[0], room.sides.low[1], room.low};
    const std::array<double, 3> size = {room.sides.size[0], room.sides.size[1],
                                        room.high - room.low};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      count_[axis] = static_cast<int>(std::clamp(std::floor(size[axis] / width), 1.0, most_cells));
      per_length_[axis] = count_[axis] / size[axis];
    }
    sort(x, diameters);
  }

  /// Calls visit(bead, image x, image y) for all beads nearer than `reach`, and some more.
  template <class Visit>
  void around(const Vec3& x, double reach, const Visit& visit) const {
    int first[3], last[3];
    const std::array<double, 3> at = {x.x, x.y, x.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      first[axis] = cell(at[axis] - reach, axis);
      last[axis] = cell(at[axis] + reach, axis);
    }
    for (int z = first[2]; z <= last[2]; ++z) {
      for (int y = first[1]; y <= last[1]; ++y) {
        const int y_image = turns(y, 1);
        const auto row = index(0, y - y_image * count_[1], z);
        for (int c = first[0]; c <= last[0];) {  // cells of one image stand side by side
          const int x_image = turns(c, 0);
          const int begin = c - x_image * count_[0];
          const int end = std::min(begin + last[0] - c, count_[0] - 1);
          const auto k_end = start_[row + static_cast<std::size_t>(end) + 1];
          for (auto k = start_[row + static_cast<std::size_t>(begin)]; k < k_end; ++k) {
            visit(beads_[k], x_image, y_image);
          }
          c += end - begin + 1;
        }
      }
    }
  }

 private:
  /// Inside the room, unless the axis is periodic.
  [[nodiscard]] int cell(double at, std::size_t axis) const {
    const int c = static_cast<int>(std::floor((at - low_[axis]) * per_length_[axis]));
    return periodic_[axis] ? c : std::clamp(c, 0, count_[axis] - 1);
  }

  [[nodiscard]] int turns(int c, std::size_t axis) const {
    const int n = count_[axis];
    return c >= 0 ? c / n : -((-c + n - 1) / n);
  }

  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(count_[1]) +
            static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(count_[0]) +
           static_cast<std::size_t>(x);
  }

  [[nodiscard]] std::size_t home(const Vec3& x) const {
    const auto within = [&](double at, std::size_t axis) {
      return std::clamp(cell(at, axis), 0, count_[axis] - 1);
    };
    return index(within(x.x, 0), within(x.y, 1), within(x.z, 2));
  }

  void sort(std::span<const Vec3> x, std::span<const double> diameters) {
    start_.assign(index(0, 0, count_[2]) + 1, 0);
    for (const auto& at : x) ++start_[home(at) + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    auto next = start_;
    beads_.resize(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      beads_[next[home(x[i])]++] = {x[i], diameters[i], static_cast<std::int32_t>(i)};
    }
  }

  std::array<bool, 3> periodic_;
  std::array<double, 3> low_{}, per_length_{};
  std::array<int, 3> count_{};
  std::vector<std::uint32_t> start_;
  std::vector<Bead> beads_;
};

}  // namespace

CloudNeighbors find_cloud_neighbors(const Room& room,
                                    std::span<const Vec3> x,
                                    std::span<const double> diameters,
                                    double scale,
                                    double skin) {
  CloudNeighbors near;
  near.first.assign(1, 0);
  if (x.empty()) return near;
  const double mean = std::accumulate(diameters.begin(), diameters.end(), 0.0) /
                      static_cast<double>(diameters.size());
  const Cells cells(room, x, diameters, scale * mean + skin);
  constexpr std::size_t usual = 7;  // pairs of a bead
  near.list.reserve(usual * x.size());
  near.first.reserve(x.size() + 1);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec3 x_i = x[i];
    const double d_i = diameters[i];
    const auto place = static_cast<std::int32_t>(i);
    // The larger bead finds the smaller.
    cells.around(x_i, scale * d_i + skin, [&](const Cells::Bead& b, int x_image, int y_image) {
      const Vec3 shift{room.sides.size[0] * x_image, room.sides.size[1] * y_image, 0.0};
      const Vec3 d = x_i - b.x - shift;
      const double reach = 0.5 * scale * (d_i + b.diameter) + skin;
      if (dot(d, d) >= reach * reach) return;
      if (b.diameter > d_i || (b.diameter == d_i && b.index >= place)) return;
      near.list.push_back(
          {b.index, {static_cast<std::int8_t>(x_image), static_cast<std::int8_t>(y_image)}});
    });
    near.first.push_back(static_cast<std::int64_t>(near.list.size()));
  }
  return near;
}

}  // namespace packbed::dem
