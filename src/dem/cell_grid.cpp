// SPDX-License-Identifier: BSD-3-Clause
#include "dem/cell_grid.hpp"

#include <numeric>

namespace packbed::dem {
namespace {

double component(const Vec3& a, std::size_t axis) {
  return axis == 0 ? a.x : (axis == 1 ? a.y : a.z);
}

}  // namespace

CellGrid::CellGrid(const Particles& particles, const Domain& domain, double width)
    : domain_(domain) {
  do {  // beads far apart get wider cells, not empty ones
    for (std::size_t axis = 0; axis < 3; ++axis) lay_out(particles, axis, width);
    width *= 1.5;
  } while (cells() > 8 * particles.size() + 1000);
  sort_beads(particles);
}

void CellGrid::lay_out(const Particles& particles, std::size_t axis, double width) {
  double low = domain_.low[axis];
  double size = domain_.size[axis];
  if (!domain_.periodic[axis]) {  // beads may be anywhere: take their own range
    double high = low = component(particles.motion[0].x, axis);
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const double x = component(particles.motion[i].x, axis);
      low = std::min(low, x);
      high = std::max(high, x);
    }
    size = std::max(high - low, width);
  }
  constexpr double most_cells = 1024.0;
  low_[axis] = low;
  count_[axis] = static_cast<int>(std::clamp(std::floor(size / width), 1.0, most_cells));
  per_length_[axis] = count_[axis] / size;
}

void CellGrid::sort_beads(const Particles& particles) {
  const std::size_t beads = particles.size();
  start_.assign(cells() + 2, 0);
  AlignedVector<std::uint32_t> home(beads);
  for (std::size_t i = 0; i < beads; ++i) {
    const Vec3& x = particles.motion[i].x;
    const auto inside = [&](std::size_t axis) {
      return std::clamp(cell(axis, component(x, axis)), 0, count_[axis] - 1);
    };
    home[i] = static_cast<std::uint32_t>(row_start(inside(2) * count_[1] + inside(1)) +
                                         static_cast<std::size_t>(inside(0)));
    ++start_[home[i] + 2];
  }
  // start_[c + 1] is where the next bead of cell c goes; at the end it is where the cell ends.
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  place_.resize(beads + lanes);
  for (auto* a : {&x_, &y_, &z_, &radius_}) a->resize(beads + lanes);  // whole lanes are read
  for (std::size_t i = 0; i < beads; ++i) {
    const auto k = start_[home[i] + 1]++;
    const Vec3& x = particles.motion[i].x;
    place_[k] = static_cast<std::uint32_t>(i);
    x_[k] = x.x;
    y_[k] = x.y;
    z_[k] = x.z;
    radius_[k] = particles.radius(i);
  }
}

}  // namespace packbed::dem
