// SPDX-License-Identifier: BSD-3-Clause
// Parts of a sphere between two planes as a stack of discs: the area of each disc's part is known in
// closed form, the integral over the height is a quadrature.
#include <array>
#include <cmath>

#include "analysis/gauss.hpp"
#include "analysis/overlap.hpp"

namespace packbed::analysis {
namespace {

/// Heights at which the integrand has a kink, in order.
class Breaks {
 public:
  Breaks(double radius, const Range& slab) : radius_(radius), slab_(slab) {
    heights_[0] = slab.low;
    heights_[1] = slab.high;
    count_ = 2;
    add(0.0);  // where a tube or plane all but touches the sphere
  }

  /// Where the disc of the stack has this radius.
  void add_disc(double disc_radius) {
    const double squared = (radius_ - disc_radius) * (radius_ + disc_radius);
    if (!(squared > 0.0)) return;
    add(std::sqrt(squared));
    add(-std::sqrt(squared));
  }

  [[nodiscard]] std::span<const double> sorted() {
    std::sort(heights_.begin(), heights_.begin() + count_);
    return {heights_.data(), static_cast<std::size_t>(count_)};
  }

 private:
  void add(double z) {
    if (z > slab_.low && z < slab_.high) heights_[static_cast<std::size_t>(count_++)] = z;
  }

  double radius_;
  Range slab_;
  std::array<double, 19> heights_{};  // ends and middle, two for each of up to eight discs
  int count_ = 0;
};

/// Integral of area(radius of the disc at z). At a break the area goes like a power 3/2 of the distance,
/// which z = middle - half cos(t) makes smooth.
template <class Area>
double stack(double radius, std::span<const double> breaks, const Area& area) {
  const auto& rule = gauss_rule();
  double sum = 0.0;
  for (std::size_t piece = 1; piece < breaks.size(); ++piece) {
    const double half = 0.5 * (breaks[piece] - breaks[piece - 1]);
    const double middle = 0.5 * (breaks[piece] + breaks[piece - 1]);
    for (std::size_t k = 0; k < gauss_points; ++k) {
      const double t = 0.5 * std::numbers::pi * (1.0 + rule.node[k]);
      const double z = middle - half * std::cos(t);
      const double squared = (radius - z) * (radius + z);
      if (squared <= 0.0) continue;
      sum +=
          0.5 * std::numbers::pi * rule.weight[k] * half * std::sin(t) * area(std::sqrt(squared));
    }
  }
  return sum;
}

Range inside_sphere(double radius, const Range& slab) {
  return {std::max(slab.low, -radius), std::min(slab.high, radius)};
}

/// Area of a disc in the quarter plane x' <= x, y' <= y.
double disc_in_quarter(double radius, double x, double y) {
  const double a = radius;
  if (x <= -a || y <= -a) return 0.0;
  if (x >= a) return disc_area_below(a, y);
  if (y >= a) return disc_area_below(a, x);
  if (x * x + y * y <= a * a) {
    return x * y + 0.5 * (disc_area_below(a, x) + disc_area_below(a, y)) -
           0.25 * std::numbers::pi * a * a;
  }
  if (x > 0.0 && y > 0.0) {
    return disc_area_below(a, x) + disc_area_below(a, y) - std::numbers::pi * a * a;
  }
  if (x < 0.0 && y < 0.0) return 0.0;
  return x < 0.0 ? disc_area_below(a, x) : disc_area_below(a, y);
}

}  // namespace

double volume_in_cylinder(double radius,
                          double distance,
                          double cylinder_radius,
                          const Range& slab) {
  const Range z = inside_sphere(radius, slab);
  if (z.low >= z.high || cylinder_radius <= 0.0) return 0.0;
  Breaks breaks(radius, z);
  const double s = std::abs(distance);
  breaks.add_disc(std::abs(cylinder_radius - s));
  breaks.add_disc(cylinder_radius + s);
  return stack(radius, breaks.sorted(),
               [&](double a) { return disc_in_disc(a, cylinder_radius, s); });
}

double volume_in_box(double radius, const Vec3& low, const Vec3& high) {
  const Range z = inside_sphere(radius, {low.z, high.z});
  if (z.low >= z.high || low.x >= high.x || low.y >= high.y) return 0.0;
  Breaks breaks(radius, z);
  for (const double x : {low.x, high.x}) {
    breaks.add_disc(std::abs(x));
    for (const double y : {low.y, high.y}) breaks.add_disc(std::hypot(x, y));
  }
  for (const double y : {low.y, high.y}) breaks.add_disc(std::abs(y));
  return stack(radius, breaks.sorted(), [&](double a) {
    return disc_in_quarter(a, high.x, high.y) - disc_in_quarter(a, low.x, high.y) -
           disc_in_quarter(a, high.x, low.y) + disc_in_quarter(a, low.x, low.y);
  });
}

}  // namespace packbed::analysis
