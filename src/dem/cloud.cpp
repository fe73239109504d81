// SPDX-License-Identifier: BSD-3-Clause
#include "dem/cloud.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/random.hpp"
#include "dem/cloud_neighbors.hpp"

namespace packbed::dem {
namespace {

/// Beads of a cloud that is being packed.
class Packing {
 public:
  Packing(const Room& room, std::span<const double> diameters, std::vector<Vec3> x)
      : room_(room), diameters_(diameters), x_(std::move(x)) {
    double sum = 0.0;
    for (const double d : diameters_) sum += d;
    skin_ = skin_of_diameter * sum / static_cast<double>(diameters_.size());
  }

  /// Pushes beads of `scale` times their size apart, until none overlaps another by more than
  /// `limit` of the smaller diameter; at most `sweeps` times. Whether it was reached.
  bool relax(double scale, double limit, int sweeps) {
    renew(scale);
    for (int n = 0; n < sweeps; ++n) {
      sweep(scale);
      if (moved_far()) renew(scale);
      if ((n % 4 == 3 || n + 1 == sweeps) && largest_overlap(scale) <= limit) return true;
    }
    return false;
  }

  /// Of beads in full size, / smaller diameter.
  [[nodiscard]] double largest_overlap() {
    renew(1.0);
    return largest_overlap(1.0);
  }

  /// Moves the lid up and the beads with it.
  void stretch(double factor) {
    for (auto& x : x_) x.z = room_.low + factor * (x.z - room_.low);
    room_.high = room_.low + factor * (room_.high - room_.low);
  }

  [[nodiscard]] const std::vector<Vec3>& x() const { return x_; }
  [[nodiscard]] const Room& room() const { return room_; }

 private:
  static constexpr double skin_of_diameter = 0.35;
  static constexpr double over_relaxation = 1.7;

  void renew(double scale) {
    for (std::size_t i = 0; i < x_.size(); ++i) {
      x_[i] = inside(room_, wrapped(room_, x_[i]), 0.5 * diameters_[i]);
    }
    near_ = find_cloud_neighbors(room_, x_, diameters_, scale, skin_);
    reference_ = x_;
  }

  [[nodiscard]] Vec3 between(std::size_t i, const CloudNeighbor& n) const {
    const auto& size = room_.sides.size;
    return x_[i] - x_[static_cast<std::size_t>(n.j)] -
           Vec3{size[0] * n.image[0], size[1] * n.image[1], 0.0};
  }

  [[nodiscard]] std::span<const CloudNeighbor> row(std::size_t i) const {
    return std::span(near_.list)
        .subspan(static_cast<std::size_t>(near_.first[i]),
                 static_cast<std::size_t>(near_.first[i + 1] - near_.first[i]));
  }

  void sweep(double scale) {
    for (std::size_t i = 0; i < x_.size(); ++i) {
      for (const auto& n : row(i)) {
        const auto j = static_cast<std::size_t>(n.j);
        const Vec3 d = between(i, n);
        const double apart = 0.5 * scale * (diameters_[i] + diameters_[j]);
        const double square = dot(d, d);
        if (square >= apart * apart) continue;
        const double distance = std::sqrt(square);
        const double push = 0.5 * over_relaxation * (apart - distance);
        // Two beads in one place part along z.
        const Vec3 way = distance > 0.0 ? (push / distance) * d : Vec3{0.0, 0.0, push};
        x_[i] += way;
        x_[j] = inside(room_, x_[j] - way, 0.5 * diameters_[j]);
      }
      x_[i] = inside(room_, x_[i], 0.5 * diameters_[i]);
    }
  }

  [[nodiscard]] double largest_overlap(double scale) const {
    double largest = 0.0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      for (const auto& n : row(i)) {
        const auto j = static_cast<std::size_t>(n.j);
        const double overlap = 0.5 * scale * (diameters_[i] + diameters_[j]) - norm(between(i, n));
        largest = std::max(largest, overlap / (scale * std::min(diameters_[i], diameters_[j])));
      }
    }
    return largest;
  }

  [[nodiscard]] bool moved_far() const {
    double largest = 0.0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const Vec3 d = x_[i] - reference_[i];
      largest = std::max(largest, dot(d, d));
    }
    return 4.0 * largest > skin_ * skin_;
  }

  Room room_;
  std::span<const double> diameters_;
  std::vector<Vec3> x_, reference_;
  CloudNeighbors near_;
  double skin_ = 0.0;
};

struct Column {
  double x, y;
};

/// Places of a square lattice across the column, about `spacing` apart.
std::vector<Column> lattice(const Room& room, double spacing) {
  const auto& s = room.sides;
  const auto count = [&](std::size_t axis) {
    return std::max(1, static_cast<int>(std::lround(s.size[axis] / spacing)));
  };
  std::vector<Column> places;
  for (int b = 0; b < count(1); ++b) {
    for (int a = 0; a < count(0); ++a) {
      const Column place{s.low[0] + (a + 0.5) / count(0) * s.size[0],
                         s.low[1] + (b + 0.5) / count(1) * s.size[1]};
      if (!room.round || std::hypot(place.x, place.y) < 0.5 * s.size[0]) places.push_back(place);
    }
  }
  return places;
}

/// A jittered lattice that fills the room; bead k takes the k-th place from below.
std::vector<Vec3> start(const Room& room, const CloudOptions& options, std::size_t count) {
  const double height = room.high - room.low;
  const double spacing = std::cbrt(room.area * height / static_cast<double>(count));
  const auto across = lattice(room, spacing);
  const std::size_t layers = (count + across.size() - 1) / across.size();
  const double layer = height / static_cast<double>(layers);
  const auto jitter = [&](std::size_t k, std::uint64_t axis) {
    constexpr double share = 0.8;  // of the spacing
    const auto index = 3 * (options.first_index + k) + axis;
    return share * (uniform(options.seed, Stream::bead_position, index) - 0.5);
  };
  std::vector<Vec3> x(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto& place = across[k % across.size()];
    x[k] = {place.x + jitter(k, 0) * spacing, place.y + jitter(k, 1) * spacing,
            room.low + (static_cast<double>(k / across.size()) + 0.5 + jitter(k, 2)) * layer};
  }
  return x;
}

double volume(std::span<const double> diameters) {
  double sum = 0.0;
  for (const double d : diameters) sum += d * d * d;
  return std::numbers::pi / 6.0 * sum;
}

void check(const CloudOptions& options, const Room& room, double largest) {
  if (largest > room.width()) {
    throw ValueError(fmt::format(
        "a bead of {:.4g} um does not fit between sides {:.4g} um apart; make the column wider",
        1e6 * largest, 1e6 * room.width()));
  }
  if (!(options.solid_fraction > 0.0 && options.solid_fraction < 0.64)) {
    throw ValueError(
        fmt::format("a cloud of solid fraction {} cannot be made; it must be above 0 "
                    "and below 0.64, where random beads jam",
                    options.solid_fraction));
  }
}

/// Grows the beads to their size; whether no overlap is beyond the limit.
bool grow(Packing& packing, double limit) {
  constexpr double early[] = {0.7, 0.85, 0.95};
  constexpr int early_sweeps = 12;
  constexpr int last_sweeps = 400;
  for (const double scale : early) packing.relax(scale, limit, early_sweeps);
  // A little beyond the size, so that what is left of overlaps vanishes at the size.
  return packing.relax(1.0 + 0.5 * limit, limit, last_sweeps);
}

}  // namespace

Cloud make_cloud(const CloudOptions& options, std::span<const double> diameters) {
  Room room = room_of(options.shape, options.low);
  if (diameters.empty()) return {.x = {}, .high = options.low};
  const double largest = *std::ranges::max_element(diameters);
  check(options, room, largest);
  const double solid = volume(diameters);
  room.high = room.low + std::max(solid / (options.solid_fraction * room.area), largest);

  Packing packing(room, diameters, start(room, options, diameters.size()));
  constexpr double stretch = 1.03;
  constexpr int most_stretches = 100;
  constexpr int sweeps = 100;
  bool done = grow(packing, options.overlap_limit);
  for (int n = 0; !done && n < most_stretches; ++n) {
    packing.stretch(stretch);
    done = packing.relax(1.0 + 0.5 * options.overlap_limit, options.overlap_limit, sweeps);
  }
  if (!done) {
    throw DivergenceError(fmt::format(
        "{} beads could not be placed without overlap in a column {:.4g} mm wide; make it wider or "
        "the beads smaller",
        diameters.size(), 1e3 * packing.room().width()));
  }
  const double overlap = packing.largest_overlap();
  const double high = packing.room().high;
  return {.x = packing.x(),
          .high = high,
          .solid_fraction = solid / (room.area * (high - options.low)),
          .largest_overlap = overlap};
}

}  // namespace packbed::dem
