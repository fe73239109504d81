// SPDX-License-Identifier: BSD-3-Clause
#include "dem/neighbors.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace packbed::dem {
namespace {

std::array<double, 3> as_array(const Vec3& a) { return {a.x, a.y, a.z}; }

/// Pairs sorted by their key: first counted into place by i, then each bead's few by j and image.
template <class Pair>
std::vector<Pair> sorted(const std::vector<Pair>& pairs, std::size_t beads) {
  std::vector<std::size_t> start(beads + 1);
  for (const auto& p : pairs) ++start[static_cast<std::size_t>(p.i) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  auto next = start;
  std::vector<Pair> result(pairs.size());
  for (const auto& p : pairs) result[next[static_cast<std::size_t>(p.i)]++] = p;
  const auto key = [](const PairKey& p) -> const PairKey& { return p; };
  for (std::size_t i = 0; i < beads; ++i) {
    std::ranges::sort(result.begin() + static_cast<std::ptrdiff_t>(start[i]),
                      result.begin() + static_cast<std::ptrdiff_t>(start[i + 1]), {}, key);
  }
  return result;
}

/// Beads sorted into cells about as wide as a mean bead. A bead looks for the smaller ones, within
/// its own diameter: the cost of a contact does not grow with the ratio of sizes.
class Grid {
 public:
  Grid(const Particles& particles, const Domain& domain, double width) : domain_(domain) {
    do {  // beads far apart get wider cells, not empty ones
      for (std::size_t axis = 0; axis < 3; ++axis) lay_out(particles, axis, width);
      width *= 1.5;
    } while (cells() > 8 * particles.size() + 1000);
    sort_beads(particles);
  }

  struct Bead {
    Vec3 x;
    double radius = 0.0;
  };

  /// Calls visit(j, bead j, image) for every bead and image in the cells within reach of x.
  template <class Visit>
  void for_neighbors(const Vec3& x, double reach, Visit visit) const {
    const auto at = as_array(x);
    std::array<int, 3> first{};
    std::array<int, 3> last{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      first[axis] = cell(axis, at[axis] - reach);
      last[axis] = cell(axis, at[axis] + reach);
    }
    Image image{};
    for (int z = first[2]; z <= last[2]; ++z) {
      const int slab = around(2, z, image) * count_[1];
      for (int y = first[1]; y <= last[1]; ++y) {
        const std::size_t row = row_start(slab + around(1, y, image));
        for (int c = first[0]; c <= last[0];) {  // cells of one image stand side by side
          const int begin = around(0, c, image);
          const int end = std::min(begin + last[0] - c, count_[0] - 1);
          const auto k_end = start_[row + static_cast<std::size_t>(end) + 1];
          for (auto k = start_[row + static_cast<std::size_t>(begin)]; k < k_end; ++k) {
            visit(place_[k], beads_[k], image);
          }
          c += end - begin + 1;
        }
      }
    }
  }

 private:
  [[nodiscard]] std::size_t cells() const {
    return static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]) *
           static_cast<std::size_t>(count_[2]);
  }

  void lay_out(const Particles& particles, std::size_t axis, double width) {
    double low = domain_.low[axis];
    double size = domain_.size[axis];
    if (!domain_.periodic[axis]) {  // beads may be anywhere: take their own range
      double high = low = as_array(particles.motion[0].x)[axis];
      for (std::size_t i = 0; i < particles.size(); ++i) {
        const double x = as_array(particles.motion[i].x)[axis];
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

  /// Cell of a coordinate: inside the box, unless the axis is periodic.
  [[nodiscard]] int cell(std::size_t axis, double x) const {
    const double c = std::floor((x - low_[axis]) * per_length_[axis]);
    return static_cast<int>(domain_.periodic[axis] ? c : std::clamp(c, 0.0, count_[axis] - 1.0));
  }

  /// Cell c taken around a periodic side, with the image that is then meant.
  int around(std::size_t axis, int c, Image& image) const {
    const int n = count_[axis];
    const int turns = c >= 0 ? c / n : -((-c + n - 1) / n);
    image[axis] = static_cast<std::int8_t>(turns);
    return c - turns * n;
  }

  /// First cell of a row along x.
  [[nodiscard]] std::size_t row_start(int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(count_[0]);
  }

  void sort_beads(const Particles& particles) {
    start_.assign(cells() + 1, 0);
    std::vector<std::size_t> home(particles.size());
    for (std::size_t i = 0; i < home.size(); ++i) {
      const auto x = as_array(particles.motion[i].x);
      const auto inside = [&](std::size_t axis) {
        return std::clamp(cell(axis, x[axis]), 0, count_[axis] - 1);
      };
      home[i] = row_start(inside(2) * count_[1] + inside(1)) + static_cast<std::size_t>(inside(0));
      ++start_[home[i] + 1];
    }
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    auto next = start_;
    place_.resize(home.size());
    beads_.resize(home.size());
    for (std::size_t i = 0; i < home.size(); ++i) {
      const auto k = next[home[i]]++;
      place_[k] = i;
      beads_[k] = {particles.motion[i].x, particles.radius(i)};
    }
  }

  const Domain& domain_;
  std::array<double, 3> low_{}, per_length_{};
  std::array<int, 3> count_{};
  std::vector<std::size_t> start_, place_;
  std::vector<Bead> beads_;
};

/// The pair seen from its other end.
void turn_around(PairKey& p) {
  std::swap(p.i, p.j);
  for (auto& turns : p.image) turns = static_cast<std::int8_t>(-turns);
}

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
  if (p.i > p.j) {
    turn_around(p);
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
  std::vector<std::pair<Key, std::int32_t>> keys(particles.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto& x = particles.motion[i].x;
    const auto slab = [&](double a, std::size_t axis) {
      constexpr double outermost = 1e15;  // what lies beyond is ordered by x and id
      return static_cast<std::int64_t>(
          std::clamp(std::floor((a - domain.low[axis]) / cell), -outermost, outermost));
    };
    keys[i] = {{slab(x.z, 2), slab(x.y, 1), slab(x.x, 0), x.x, particles.properties[i].id},
               static_cast<std::int32_t>(i)};
  }
  if (!std::ranges::is_sorted(keys)) std::ranges::sort(keys);
  std::vector<std::int32_t> order(keys.size());
  std::ranges::transform(keys, order.begin(), [](const auto& key) { return key.second; });
  return order;
}

std::vector<PairKey> find_pairs(const Particles& particles, const Domain& domain, double skin) {
  const std::size_t count = particles.size();
  if (count < 2) return {};
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) sum += 2.0 * particles.radius(i);
  const Grid grid(particles, domain, sum / static_cast<double>(count) + skin);
  std::vector<PairKey> pairs;
  pairs.reserve(4 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 x_i = particles.motion[i].x;
    const double r_i = particles.radius(i);
    constexpr double margin = 1.0 + 1e-9;  // of rounding in cells
    const double reach = margin * (2.0 * r_i + skin);
    grid.for_neighbors(x_i, reach, [&](std::size_t j, const Grid::Bead& b, const Image& image) {
      if (b.radius > r_i || (b.radius == r_i && j <= i)) return;  // j finds i
      const Vec3 d = x_i - (b.x + offset(domain, image));
      const double near = r_i + b.radius + skin;
      if (dot(d, d) >= near * near || i == j) return;
      if (!particles.is_own(i) && !particles.is_own(j)) return;
      PairKey p{
          .i = static_cast<std::int32_t>(i), .j = static_cast<std::int32_t>(j), .image = image};
      if (j < i) turn_around(p);
      pairs.push_back(p);
    });
  }
  return sorted(pairs, count);
}

std::vector<PairContact> carry_over(const std::vector<PairContact>& old_pairs,
                                    const std::vector<std::int32_t>& place,
                                    const std::vector<Image>& wraps) {
  std::vector<PairContact> pairs = old_pairs;
  for (auto& p : pairs) p = moved(p, place, wraps);
  return sorted(pairs, place.size());
}

}  // namespace packbed::dem
