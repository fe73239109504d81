// SPDX-License-Identifier: BSD-3-Clause
#include "column/bed_figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace packbed::column {
namespace {

constexpr double bin = 0.1e-3;  // of the profile that gives the height [m]

/// Volume of a ball below a plane [m3].
double volume_below(const Ball& ball, double z) {
  const double r = 0.5 * ball.diameter;
  const double h = std::clamp(z - (ball.z - r), 0.0, ball.diameter);
  return std::numbers::pi / 3.0 * h * h * (3.0 * r - h);
}

double volume_below(std::span<const Ball> balls, double z) {
  double sum = 0.0;
  for (const auto& ball : balls) sum += volume_below(ball, z);
  return sum;
}

/// Solid volume in bins from z = 0 up to the highest bead [m3].
std::vector<double> volumes_of_bins(std::span<const Ball> balls, double top) {
  std::vector<double> volumes(static_cast<std::size_t>(std::max(1.0, std::ceil(top / bin))) + 2);
  for (const auto& ball : balls) {
    const double low = ball.z - 0.5 * ball.diameter;
    auto k = static_cast<std::size_t>(std::max(0.0, std::floor(low / bin)));
    double below = 0.0;
    for (; below < volume_below(ball, ball.z + ball.diameter) && k < volumes.size(); ++k) {
      const double next = volume_below(ball, static_cast<double>(k + 1) * bin);
      volumes[k] += next - below;
      below = next;
    }
  }
  return volumes;
}

/// Mean solid volume of the bins that hold the middle half of it [m3]: the bulk, however high the bed.
double volume_of_bulk_bin(const std::vector<double>& volumes) {
  double total = 0.0;
  for (const double v : volumes) total += v;
  double sum = 0.0, middle = 0.0, bins = 0.0;
  for (const double v : volumes) {
    const double before = sum;
    sum += v;
    if (v <= 0.0) continue;
    const double inside = std::min(sum, 0.75 * total) - std::max(before, 0.25 * total);
    if (inside <= 0.0) continue;
    middle += inside;
    bins += inside / v;
  }
  return bins > 0.0 ? middle / bins : 0.0;
}

double height_of(const std::vector<double>& volumes) {
  const double half = 0.5 * volume_of_bulk_bin(volumes);
  const auto smooth = [&](std::size_t k) {  // mean of three bins
    const double before = k > 0 ? volumes[k - 1] : volumes[k];
    const double behind = k + 1 < volumes.size() ? volumes[k + 1] : 0.0;
    return (before + volumes[k] + behind) / 3.0;
  };
  for (std::size_t k = volumes.size(); k-- > 0;) {
    const double here = smooth(k);
    if (here < half || here <= 0.0) continue;
    const double above = k + 1 < volumes.size() ? smooth(k + 1) : 0.0;
    const double part = here > above ? (here - half) / (here - above) : 0.0;
    return (static_cast<double>(k) + 0.5 + part) * bin;
  }
  return 0.0;
}

}  // namespace

std::vector<Ball> gather_balls(const dem::Particles& particles, const Ranks& ranks) {
  std::vector<Ball> balls;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (!particles.is_own(i)) continue;
    balls.push_back(
        {particles.properties[i].id, particles.motion[i].x.z, particles.properties[i].diameter});
  }
  if (ranks.size() > 1) balls = ranks.gather(balls);
  std::ranges::sort(balls, {}, &Ball::id);
  return balls;
}

BedFigures bed_figures(std::span<const Ball> balls, double area) {
  if (balls.empty()) return {};
  BedFigures f;
  for (const auto& ball : balls) {
    f.top = std::max(f.top, ball.z + 0.5 * ball.diameter);
    f.mean_diameter += ball.diameter / static_cast<double>(balls.size());
  }
  f.height = height_of(volumes_of_bins(balls, f.top));
  const double low = 0.25 * f.height, high = 0.75 * f.height;
  const double solid = volume_below(balls, high) - volume_below(balls, low);
  f.porosity = f.height > 0.0 ? 1.0 - solid / (area * (high - low)) : 1.0;
  return f;
}

BedFigures bed_figures(const dem::Particles& particles, double area, const Ranks& ranks) {
  const auto balls = gather_balls(particles, ranks);
  BedFigures f;
  if (ranks.is_first()) f = bed_figures(balls, area);
  if (ranks.size() == 1) return f;
  std::vector<std::vector<BedFigures>> to_each(static_cast<std::size_t>(ranks.size()));
  if (ranks.is_first()) std::ranges::fill(to_each, std::vector<BedFigures>{f});
  return ranks.exchange(to_each)[0][0];
}

}  // namespace packbed::column
