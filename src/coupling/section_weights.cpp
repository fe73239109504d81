// SPDX-License-Identifier: BSD-3-Clause
#include "coupling/section_weights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"
#include "coupling/kernel.hpp"

namespace packbed::coupling {
namespace {

constexpr double samples_per_reach = 4.0;
constexpr double buckets_per_reach = 2.0;

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

/// By rising cell, those of several images of a point added up.
void join(std::vector<CellWeight>& weights) {
  std::ranges::stable_sort(weights, {}, &CellWeight::cell);
  std::size_t kept = 0;
  for (std::size_t k = 1; k < weights.size(); ++k) {
    if (weights[k].cell == weights[kept].cell) {
      weights[kept].weight += weights[k].weight;
    } else {
      weights[++kept] = weights[k];
    }
  }
  if (!weights.empty()) weights.resize(kept + 1);
}

}  // namespace

SectionWeights::SectionWeights(const mesh::CrossSection& section, const Options& options)
    : options_(options) {
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
  samples_first_.push_back(static_cast<std::uint32_t>(samples_.size()));
  find_near_cells();
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
  samples_first_.push_back(static_cast<std::uint32_t>(samples_.size()));
  for (int k = 0; k < ns * nt; ++k) {
    const auto m = map(c, gauss_point(k / nt, ns), gauss_point(k % nt, nt));
    const auto lane = static_cast<std::size_t>(k % 4);
    if (lane == 0) {  // lanes that stay empty are where the first one is
      samples_.emplace_back();
      samples_.back().x.fill(m.x.x);
      samples_.back().y.fill(options_.is_empty_y ? 0.0 : m.x.y);
    }
    auto& four = samples_.back();
    four.x[lane] = m.x.x;
    four.y[lane] = options_.is_empty_y ? 0.0 : m.x.y;
    four.area[lane] = m.jacobian / (ns * nt);
  }
}

int SectionWeights::bucket(double a, std::size_t axis) const {
  return static_cast<int>(std::floor((a - low_[axis]) * buckets_per_reach / options_.reach));
}

void SectionWeights::find_near_cells() {
  constexpr double far = std::numeric_limits<double>::max();
  low_ = {far, far};
  std::array<double, 2> high = {-far, -far};
  for (const auto& four : samples_) {
    for (std::size_t k = 0; k < 4; ++k) {
      low_ = {std::min(low_[0], four.x[k]), std::min(low_[1], four.y[k])};
      high = {std::max(high[0], four.x[k]), std::max(high[1], four.y[k])};
    }
  }
  const double reach = options_.reach;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    low_[axis] -= reach;
    count_[axis] = bucket(high[axis] + reach, axis) + 1;
  }
  const double width = reach / buckets_per_reach;
  const auto beyond = [&](double a, int b, std::size_t axis) {  // how far a is out of bucket b
    const double begin = low_[axis] + width * b;
    return std::max({begin - a, a - begin - width, 0.0});
  };
  std::vector<std::vector<std::int32_t>> near(static_cast<std::size_t>(count_[0] * count_[1]));
  for (std::size_t c = 0; c + 1 < samples_first_.size(); ++c) {
    for (auto s = samples_first_[c]; s < samples_first_[c + 1]; ++s) {
      for (std::size_t k = 0; k < 4; ++k) {
        const double x = samples_[s].x[k];
        const double y = samples_[s].y[k];
        const int last_x = std::min(bucket(x + reach, 0), count_[0] - 1);
        const int last_y = std::min(bucket(y + reach, 1), count_[1] - 1);
        for (int j = std::max(bucket(y - reach, 1), 0); j <= last_y; ++j) {
          for (int i = std::max(bucket(x - reach, 0), 0); i <= last_x; ++i) {
            if (std::hypot(beyond(x, i, 0), beyond(y, j, 1)) > reach) continue;
            auto& cells = near[static_cast<std::size_t>(j * count_[0] + i)];
            const auto cell = static_cast<std::int32_t>(c);
            if (cells.empty() || cells.back() != cell) cells.push_back(cell);
          }
        }
      }
    }
  }
  for (const auto& cells : near) {
    near_first_.push_back(static_cast<std::uint32_t>(near_.size()));
    near_.insert(near_.end(), cells.begin(), cells.end());
  }
  near_first_.push_back(static_cast<std::uint32_t>(near_.size()));
}

// The kernel around x, summed over each cell near it.
void SectionWeights::add(const mesh::Point& x, std::vector<CellWeight>& weights) const {
  const int i = bucket(x.x, 0);
  const int j = bucket(x.y, 1);
  if (i < 0 || j < 0 || i >= count_[0] || j >= count_[1]) return;
  const double scale = 1.0 / (options_.reach * options_.reach);
  const auto b = static_cast<std::size_t>(j * count_[0] + i);
  for (auto n = near_first_[b]; n < near_first_[b + 1]; ++n) {
    const auto c = static_cast<std::size_t>(near_[n]);
    std::array<double, 4> sum{};
    for (auto s = samples_first_[c]; s < samples_first_[c + 1]; ++s) {
      const auto& four = samples_[s];
      for (std::size_t k = 0; k < 4; ++k) {
        const double dx = four.x[k] - x.x;
        const double dy = four.y[k] - x.y;
        sum[k] += kernel(scale * (dx * dx + dy * dy)) * four.area[k];
      }
    }
    const double whole = (sum[0] + sum[1]) + (sum[2] + sum[3]);
    if (whole > 0.0) weights.push_back({near_[n], whole});
  }
}

void SectionWeights::at(const mesh::Point& x, std::vector<CellWeight>& weights) const {
  weights.clear();
  const auto images = [](double length) {
    return length > 0.0 ? std::vector<double>{0.0, -length, length} : std::vector<double>{0.0};
  };
  const double y = options_.is_empty_y ? 0.0 : x.y;
  if (options_.periodic_x == 0.0 && (options_.is_empty_y || options_.periodic_y == 0.0)) {
    add({x.x, y}, weights);
  } else {
    for (const double dx : images(options_.periodic_x)) {
      for (const double dy : images(options_.is_empty_y ? 0.0 : options_.periodic_y)) {
        add({x.x + dx, y + dy}, weights);
      }
    }
    join(weights);
  }
  double total = 0.0;
  for (const auto& w : weights) total += w.weight;
  for (auto& w : weights) w.weight /= total;
}

}  // namespace packbed::coupling
