// SPDX-License-Identifier: BSD-3-Clause
#include "dem/neighbors.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <numeric>
#include <tuple>
#include <utility>

namespace packbed::dem {
namespace {

std::array<double, 3> as_array(const Vec3& a) { return {a.x, a.y, a.z}; }

auto key(const PairContact& p) { return std::tuple(p.i, p.j, p.image); }

/// Cells as wide as the farthest reach of two beads, beads sorted into them.
class Grid {
 public:
  Grid(const Particles& particles, const Domain& domain, double reach)
      : particles_(particles), domain_(domain) {
    for (std::size_t axis = 0; axis < 3; ++axis) lay_out(axis, reach);
    sort_beads();
  }

  /// Calls visit(j, image) for every bead and image in the cells around bead i.
  template <class Visit>
  void for_neighbors(std::size_t i, Visit visit) const {
    const auto home = cell_of(particles_.motion[i].x);
    Image image{};
    for (int dz = -reach_[2]; dz <= reach_[2]; ++dz) {
      const int z = step(2, home[2] + dz, image);
      if (z < 0) continue;
      for (int dy = -reach_[1]; dy <= reach_[1]; ++dy) {
        const int y = step(1, home[1] + dy, image);
        if (y < 0) continue;
        for (int dx = -reach_[0]; dx <= reach_[0]; ++dx) {
          const int x = step(0, home[0] + dx, image);
          if (x < 0) continue;
          const auto c = index({x, y, z});
          for (auto k = start_[c]; k < start_[c + 1]; ++k) visit(beads_[k], image);
        }
      }
    }
  }

 private:
  void lay_out(std::size_t axis, double reach) {
    double low = domain_.low[axis];
    double size = domain_.size[axis];
    if (!domain_.periodic[axis]) {  // beads may be anywhere: take their own range
      double high = low = particles_.size() > 0 ? as_array(particles_.motion[0].x)[axis] : 0.0;
      for (std::size_t i = 0; i < particles_.size(); ++i) {
        const double x = as_array(particles_.motion[i].x)[axis];
        low = std::min(low, x);
        high = std::max(high, x);
      }
      size = std::max(high - low, reach);
    }
    constexpr double most_cells = 1024.0;
    low_[axis] = low;
    count_[axis] = static_cast<int>(std::clamp(std::floor(size / reach), 1.0, most_cells));
    width_[axis] = size / count_[axis];
    reach_[axis] = static_cast<int>(std::ceil(reach / width_[axis] * (1.0 + 1e-12)));
  }

  [[nodiscard]] std::array<int, 3> cell_of(const Vec3& x) const {
    const auto a = as_array(x);
    std::array<int, 3> cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double c = std::floor((a[axis] - low_[axis]) / width_[axis]);
      cell[axis] = static_cast<int>(std::clamp(c, 0.0, count_[axis] - 1.0));
    }
    return cell;
  }

  [[nodiscard]] std::size_t index(const std::array<int, 3>& c) const {
    return static_cast<std::size_t>((c[2] * count_[1] + c[1]) * count_[0] + c[0]);
  }

  /// Cell c of an axis taken around periodic sides, with the image that is then meant; -1 if none.
  int step(std::size_t axis, int c, Image& image) const {
    const int n = count_[axis];
    int turns = 0;
    if (domain_.periodic[axis]) {
      turns = c >= 0 ? c / n : -((-c + n - 1) / n);
      c -= turns * n;
    }
    image[axis] = static_cast<std::int8_t>(turns);
    return c >= 0 && c < n ? c : -1;
  }

  void sort_beads() {
    const auto cells = static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]) *
                       static_cast<std::size_t>(count_[2]);
    start_.assign(cells + 1, 0);
    std::vector<std::size_t> cell(particles_.size());
    for (std::size_t i = 0; i < cell.size(); ++i) {
      cell[i] = index(cell_of(particles_.motion[i].x));
      ++start_[cell[i] + 1];
    }
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    auto next = start_;
    beads_.resize(cell.size());
    for (std::size_t i = 0; i < cell.size(); ++i) beads_[next[cell[i]]++] = i;
  }

  const Particles& particles_;
  const Domain& domain_;
  std::array<double, 3> low_{}, width_{};
  std::array<int, 3> count_{}, reach_{};
  std::vector<std::size_t> start_, beads_;
};

PairContact moved(const PairContact& old,
                  const std::vector<std::int32_t>& place,
                  const std::vector<Image>& wraps) {
  PairContact p = old;
  const auto& wrap_i = wraps[static_cast<std::size_t>(old.i)];
  const auto& wrap_j = wraps[static_cast<std::size_t>(old.j)];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    p.image[axis] = static_cast<std::int8_t>(old.image[axis] + wrap_i[axis] - wrap_j[axis]);
  }
  p.i = place[static_cast<std::size_t>(old.i)];
  p.j = place[static_cast<std::size_t>(old.j)];
  if (p.i > p.j) {  // the pair seen from its other end
    std::swap(p.i, p.j);
    for (auto& turns : p.image) turns = static_cast<std::int8_t>(-turns);
    p.history.spring = -p.history.spring;
    p.history.angle = -p.history.angle;
  }
  return p;
}

}  // namespace

std::vector<Image> wrap(Particles& particles, const Domain& domain) {
  std::vector<Image> wraps(particles.size());
  for (std::size_t i = 0; i < wraps.size(); ++i) {
    auto x = as_array(particles.motion[i].x);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!domain.periodic[axis]) continue;
      const double turns = std::floor((x[axis] - domain.low[axis]) / domain.size[axis]);
      x[axis] -= turns * domain.size[axis];
      wraps[i][axis] = static_cast<std::int8_t>(-turns);
    }
    particles.motion[i].x = to_vec3(x);
  }
  return wraps;
}

std::vector<std::int32_t> key_order(const Particles& particles, const Domain& domain, double cell) {
  using Key = std::tuple<std::int64_t, std::int64_t, std::int64_t, double, std::int64_t>;
  std::vector<Key> keys(particles.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto& x = particles.motion[i].x;
    const auto slab = [&](double a, std::size_t axis) {
      return static_cast<std::int64_t>(std::floor((a - domain.low[axis]) / cell));
    };
    keys[i] = {slab(x.z, 2), slab(x.y, 1), slab(x.x, 0), x.x, particles.properties[i].id};
  }
  std::vector<std::int32_t> order(keys.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](std::int32_t k) { return keys[static_cast<std::size_t>(k)]; });
  return order;
}

std::vector<PairContact> find_pairs(const Particles& particles, const Domain& domain, double skin) {
  double largest = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    largest = std::max(largest, 2.0 * particles.radius(i));
  }
  std::vector<PairContact> pairs;
  if (particles.size() < 2) return pairs;
  const Grid grid(particles, domain, largest + skin);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const auto first = pairs.size();
    const Vec3 x_i = particles.motion[i].x;
    grid.for_neighbors(i, [&](std::size_t j, const Image& image) {
      if (j <= i || (!particles.is_own(i) && !particles.is_own(j))) return;
      const Vec3 d = x_i - (particles.motion[j].x + offset(domain, image));
      const double near = particles.radius(i) + particles.radius(j) + skin;
      if (dot(d, d) >= near * near) return;
      PairContact p;
      p.i = static_cast<std::int32_t>(i);
      p.j = static_cast<std::int32_t>(j);
      p.image = image;
      pairs.push_back(p);
    });
    std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(first), pairs.end(),
              [](const auto& a, const auto& b) { return key(a) < key(b); });
  }
  return pairs;
}

std::size_t carry_over(std::vector<PairContact>& pairs,
                       std::vector<PairContact> old_pairs,
                       const std::vector<std::int32_t>& place,
                       const std::vector<Image>& wraps) {
  for (auto& p : old_pairs) p = moved(p, place, wraps);
  std::ranges::sort(old_pairs, [](const auto& a, const auto& b) { return key(a) < key(b); });
  auto old = old_pairs.begin();
  std::size_t unknown = 0;
  for (auto& p : pairs) {
    while (old != old_pairs.end() && key(*old) < key(p)) ++old;
    if (old != old_pairs.end() && key(*old) == key(p)) {
      p.coefficients = old->coefficients;
      p.history = old->history;
    } else {
      p.coefficients.a = -1.0;  // to be filled in by the contact law
      ++unknown;
    }
  }
  return unknown;
}

}  // namespace packbed::dem
