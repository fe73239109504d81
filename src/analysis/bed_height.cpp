// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/bed_height.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <boost/math/tools/toms748_solve.hpp>

#include "analysis/overlap.hpp"
#include "analysis/slots.hpp"

namespace packbed::analysis {
namespace {

constexpr double widest_window = 0.3e-3;  // [m]
constexpr double resolution = 1e-12;      // [m]

/// Solid volume per height over a range [m2].
double solid_area(std::span<const Bead> beads, const Range& z, const Ranks& ranks) {
  const std::array<double, 2> heights = {z.low, z.high};
  return solid_between(beads, heights, ranks)[0] / (z.high - z.low);
}

/// Mean height of the beads, by volume, and the top of the highest.
struct Extent {
  double mean = 0.0;
  double top = 0.0;
};

Extent extent(std::span<const Bead> beads, double largest_volume, const Ranks& ranks) {
  Extent e;
  std::vector<double> volumes;
  std::vector<double> moments;
  for (const auto& bead : beads) {
    volumes.push_back(sphere_volume(bead.radius));
    moments.push_back(volumes.back() * bead.x.z);
    e.top = std::max(e.top, bead.x.z + bead.radius);
  }
  e.top = ranks.max(e.top);
  const double volume = order_independent_sum(volumes, ranks);
  if (largest_volume > 0.0) e.mean = order_independent_sum(moments, ranks) / volume;
  return e;
}

/// Solid volume per height in three bins, at the middle one [m2].
double mean_of_three(std::span<const double> solid, std::size_t k, double bin) {
  const double below = k > 0 ? solid[k - 1] : 0.0;
  const double above = k + 1 < solid.size() ? solid[k + 1] : 0.0;
  return (below + solid[k] + above) / (3.0 * bin);
}

/// The uppermost height at which the solid area of the window falls to `half`, or nothing.
class Top {
 public:
  Top(std::span<const Bead> beads, double top, double window, const Ranks& ranks)
      : beads_(beads), ranks_(ranks), window_(window), bin_(window / 3.0) {
    edges_ = even_edges(0.0, bin_ * (std::ceil(top / bin_) + 2.0), bin_);
    solid_ = solid_between(beads, edges_, ranks);
  }

  [[nodiscard]] std::optional<double> where(double half) const {
    for (std::size_t k = solid_.size(); k-- > 0;) {
      if (mean_of_three(solid_, k, bin_) < half) continue;
      const double z = (static_cast<double>(k) + 0.5) * bin_;
      return crossing({z, z + bin_}, half);
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] double crossing(const Range& between, double half) const {
    std::vector<Bead> near;
    for (const auto& bead : beads_) {
      if (bead.x.z + bead.radius > between.low - window_ &&
          bead.x.z - bead.radius < between.high + window_) {
        near.push_back(bead);
      }
    }
    const auto excess = [&](double z) {
      return solid_area(near, {z - 0.5 * window_, z + 0.5 * window_}, ranks_) - half;
    };
    const double low = excess(between.low);
    const double high = excess(between.high);
    if (low <= 0.0) return between.low;  // equal to half up to rounding
    if (high >= 0.0) return between.high;
    std::uintmax_t iterations = 100;
    const auto root = boost::math::tools::toms748_solve(
        excess, between.low, between.high, low, high,
        [](double a, double b) { return std::abs(b - a) < resolution; }, iterations);
    return 0.5 * (root.first + root.second);
  }

  std::span<const Bead> beads_;
  const Ranks& ranks_;
  double window_;
  double bin_;
  std::vector<double> edges_, solid_;
};

}  // namespace

double bed_height(std::span<const Bead> beads, const Ranks& ranks) {
  const auto e = extent(beads, largest_bead_volume(beads, ranks), ranks);
  if (!(e.mean > 0.0)) return 0.0;
  const Top top(beads, e.top, std::min(widest_window, e.mean), ranks);
  // A bed of even density is twice as high as its center of mass.
  double height = 2.0 * e.mean;
  for (int round = 0; round < 20; ++round) {
    const double bulk = solid_area(beads, middle_half(height), ranks);
    // Beads in two heaps far apart: there is no bed.
    const auto found = bulk > 0.0 ? top.where(0.5 * bulk) : std::nullopt;
    if (!found) return height;
    const double moved = std::abs(*found - height);
    height = *found;
    if (moved < resolution) break;
  }
  return height;
}

double mean_porosity(std::span<const Bead> beads,
                     double cross_section,
                     const Range& z,
                     const Ranks& ranks) {
  if (!(z.high > z.low)) return 1.0;
  return 1.0 - solid_area(beads, z, ranks) / cross_section;
}

BedFigures bed_figures(std::span<const Bead> beads, double cross_section, const Ranks& ranks) {
  BedFigures f;
  f.height = bed_height(beads, ranks);
  f.mean_porosity = mean_porosity(beads, cross_section, {0.0, f.height}, ranks);
  f.middle_porosity = mean_porosity(beads, cross_section, middle_half(f.height), ranks);
  return f;
}

}  // namespace packbed::analysis
