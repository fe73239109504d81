// SPDX-License-Identifier: BSD-3-Clause
#include "coupling/section_weights.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "core/error.hpp"
#include "coupling/kernel.hpp"

namespace packbed::coupling {
namespace {

constexpr double samples_per_reach = 4.0;

double distance(const mesh::Point& a, const mesh::Point& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// The k-th of n points along a side of length 1, two Gauss points in each of n / 2 pieces; of one, the middle.
double gauss_point(int k, int n) {
  const double inside = k % 2 == 0 ? -1.0 : 1.0;
  return n == 1 ? 0.5 : (k / 2 + 0.5 + 0.5 * inside / std::sqrt(3.0)) / (0.5 * n);
}

/// Point of a quadrilateral with the corners c, and the Jacobian there; 0 <= s, t <= 1.
struct Mapped {
  mesh::Point x;
  double jacobian;
};
Mapped map(const std::array<mesh::Point, 4>& c, double s, double t) {
  const auto between = [&](auto of) {
    return (1 - s) * (1 - t) * of(c[0]) + s * (1 - t) * of(c[1]) + s * t * of(c[2]) +
           (1 - s) * t * of(c[3]);
  };
  const auto along_s = [&](auto of) {
    return (1 - t) * (of(c[1]) - of(c[0])) + t * (of(c[2]) - of(c[3]));
  };
  const auto along_t = [&](auto of) {
    return (1 - s) * (of(c[3]) - of(c[0])) + s * (of(c[2]) - of(c[1]));
  };
  const auto x = [](const mesh::Point& p) { return p.x; };
  const auto y = [](const mesh::Point& p) { return p.y; };
  return {{between(x), between(y)}, along_s(x) * along_t(y) - along_s(y) * along_t(x)};
}

}  // namespace

SectionWeights::SectionWeights(const mesh::CrossSection& section, const Options& options)
    : options_(options), sum_(static_cast<std::size_t>(section.cell_count()), 0.0) {
  if (!(options.reach > 0.0)) {
    throw ValueError(
        fmt::format("the averaging width is {} m; it must be positive", options.reach));
  }
  for (const double length : {options.periodic_x, options.is_empty_y ? 0.0 : options.periodic_y}) {
    if (length > 0.0 && 2.0 * options.reach > length) {
      throw ValueError(fmt::format(
          "the averaging width of {:.4g} mm is more than half of the periodic length of {:.4g} mm; "
          "give a smaller one or a larger column",
          1e3 * options.reach, 1e3 * length));
    }
  }
  for (std::int32_t c = 0; c < section.cell_count(); ++c) sample_cell(section, c);
  sort_into_buckets();
}

void SectionWeights::sample_cell(const mesh::CrossSection& section, std::int32_t cell) {
  std::array<mesh::Point, 4> c;
  for (std::size_t k = 0; k < 4; ++k) {
    c[k] =
        section.points[static_cast<std::size_t>(section.cells[static_cast<std::size_t>(cell)][k])];
  }
  const auto samples = [&](double length) {
    return 2 * static_cast<int>(std::ceil(0.5 * samples_per_reach * length / options_.reach));
  };
  const int ns = samples(std::max(distance(c[0], c[1]), distance(c[3], c[2])));
  const int nt =
      options_.is_empty_y ? 1 : samples(std::max(distance(c[0], c[3]), distance(c[1], c[2])));
  for (int s = 0; s < ns; ++s) {
    for (int t = 0; t < nt; ++t) {
      const auto m = map(c, gauss_point(s, ns), gauss_point(t, nt));
      samples_.push_back({m.x, m.jacobian / (ns * nt), cell});
    }
  }
}

int SectionWeights::bucket(double a, std::size_t axis) const {
  return static_cast<int>(std::floor((a - low_[axis]) / options_.reach));
}

void SectionWeights::sort_into_buckets() {
  low_ = {samples_.front().x.x, samples_.front().x.y};
  std::array<double, 2> high = low_;
  for (const auto& s : samples_) {
    low_ = {std::min(low_[0], s.x.x), std::min(low_[1], s.x.y)};
    high = {std::max(high[0], s.x.x), std::max(high[1], s.x.y)};
  }
  for (std::size_t axis = 0; axis < 2; ++axis) count_[axis] = bucket(high[axis], axis) + 1;
  const auto bucket_of = [&](const Sample& s) {
    return static_cast<std::size_t>(bucket(s.x.y, 1) * count_[0] + bucket(s.x.x, 0));
  };
  std::ranges::stable_sort(samples_, {}, bucket_of);
  first_.assign(static_cast<std::size_t>(count_[0] * count_[1]) + 1, 0);
  for (const auto& s : samples_) ++first_[bucket_of(s) + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
}

// Adds the kernel around x to the sums of the cells.
void SectionWeights::visit(const mesh::Point& x) {
  const double scale = 1.0 / (options_.reach * options_.reach);
  const int bx = bucket(x.x, 0);
  const int by = options_.is_empty_y ? 0 : bucket(x.y, 1);
  const int last_y = std::min(options_.is_empty_y ? count_[1] - 1 : by + 1, count_[1] - 1);
  const int first_x = std::max(bx - 1, 0);
  const int last_x = std::min(bx + 1, count_[0] - 1);
  if (first_x > last_x) return;
  for (int j = std::max(by - 1, 0); j <= last_y; ++j) {  // buckets of a row stand side by side
    const auto row = static_cast<std::size_t>(j * count_[0]);
    const auto end = first_[row + static_cast<std::size_t>(last_x) + 1];
    for (auto k = first_[row + static_cast<std::size_t>(first_x)]; k < end; ++k) {
      const auto& s = samples_[k];
      const double dx = s.x.x - x.x;
      const double dy = options_.is_empty_y ? 0.0 : s.x.y - x.y;
      const double share = kernel(scale * (dx * dx + dy * dy)) * s.area;
      if (share <= 0.0) continue;
      auto& sum = sum_[static_cast<std::size_t>(s.cell)];
      if (sum == 0.0) touched_.push_back(s.cell);
      sum += share;
    }
  }
}

void SectionWeights::at(const mesh::Point& x, std::vector<CellWeight>& weights) {
  weights.clear();
  const auto moves = [](double length) {
    return length > 0.0 ? std::vector<double>{0.0, -length, length} : std::vector<double>{0.0};
  };
  if (options_.periodic_x == 0.0 && (options_.is_empty_y || options_.periodic_y == 0.0)) {
    visit(x);
  } else {
    for (const double dx : moves(options_.periodic_x)) {
      for (const double dy : moves(options_.is_empty_y ? 0.0 : options_.periodic_y)) {
        visit({x.x + dx, x.y + dy});
      }
    }
  }
  std::ranges::sort(touched_);
  double total = 0.0;
  for (const auto c : touched_) total += sum_[static_cast<std::size_t>(c)];
  for (const auto c : touched_) {
    weights.push_back({c, sum_[static_cast<std::size_t>(c)] / total});
    sum_[static_cast<std::size_t>(c)] = 0.0;
  }
  touched_.clear();
}

}  // namespace packbed::coupling
