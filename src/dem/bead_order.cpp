// SPDX-License-Identifier: BSD-3-Clause
#include "dem/bead_order.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace packbed::dem {
namespace {

/// y-strip, z-slab and y-row in one number. Beads that have escaped farther than a million cells all count as being
/// in the outermost row, and are ordered by x and id.
std::int64_t row_of(const Vec3& x, const Domain& domain, double cell) {
  constexpr double outermost = 1e6;
  const auto slab = [&](double a, std::size_t axis) {
    const double s = std::floor((a - domain.low[axis]) / cell);
    return static_cast<std::int64_t>(std::clamp(s, -outermost, outermost));
  };
  constexpr std::int64_t rows = 1 << 22;
  constexpr std::int64_t strip = 8;  // rows of it: a slab of a strip and its pairs fit the cache
  const std::int64_t y = slab(x.y, 1) + rows / 2;
  return ((y / strip) * rows + slab(x.z, 2)) * strip + y % strip;
}

/// What is sorted: within a row, order by cell and then x is order by x.
struct Key {
  std::int64_t row = 0;
  double x = 0.0;
  std::int32_t bead = 0;
};

}  // namespace

std::vector<Image> wrap(Particles& particles, const Domain& domain) {
  std::vector<Image> wraps(particles.size());
  for (std::size_t i = 0; i < wraps.size(); ++i) {
    double* x[3] = {&particles.motion[i].x.x, &particles.motion[i].x.y, &particles.motion[i].x.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!domain.periodic[axis]) continue;
      const double turns = std::floor((*x[axis] - domain.low[axis]) / domain.size[axis]);
      *x[axis] -= turns * domain.size[axis];
      wraps[i][axis] = static_cast<std::int8_t>(-turns);
    }
  }
  return wraps;
}

std::vector<std::int32_t> key_order(const Particles& particles, const Domain& domain, double cell) {
  std::vector<Key> keys(particles.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Vec3& x = particles.motion[i].x;
    keys[i] = {row_of(x, domain, cell), x.x, static_cast<std::int32_t>(i)};
  }
  const auto id = [&](const Key& k) {
    return particles.properties[static_cast<std::size_t>(k.bead)].id;
  };
  const auto before = [&](const Key& a, const Key& b) {
    if (a.row != b.row) return a.row < b.row;
    if (a.x != b.x) return a.x < b.x;
    return id(a) < id(b);
  };
  if (!std::ranges::is_sorted(keys, before)) std::ranges::sort(keys, before);
  std::vector<std::int32_t> order(keys.size());
  std::ranges::transform(keys, order.begin(), &Key::bead);
  return order;
}

std::vector<std::int32_t> places(const std::vector<std::int32_t>& order, std::size_t beads) {
  std::vector<std::int32_t> place(beads, -1);
  for (std::size_t k = 0; k < order.size(); ++k) {
    place[static_cast<std::size_t>(order[k])] = static_cast<std::int32_t>(k);
  }
  return place;
}

}  // namespace packbed::dem
