// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/overlap.hpp"

#include <array>
#include <cmath>

#include "analysis/gauss.hpp"

namespace packbed::analysis {
namespace {

using std::numbers::pi;

/// Integrals of sin^2(t/2) and sin^4(t/2) over -angle < t < angle. For small angles their closed forms
/// are small differences of large numbers, hence the series.
struct Moments {
  double second = 0.0;  ///< angle - sin(angle)
  double fourth = 0.0;  ///< (3 angle - 4 sin(angle) + sin(angle) cos(angle)) / 4
};

Moments moments(double angle) {
  if (angle > 0.7) {
    const double s = std::sin(angle);
    return {angle - s, 0.25 * (3.0 * angle - 4.0 * s + s * std::cos(angle))};
  }
  Moments m;
  double term = angle;
  double power = 1.0;
  for (int j = 1; j <= 12; ++j) {  // 1.4^25 / 25! is below 1e-21
    term *= -angle * angle / ((2.0 * j) * (2.0 * j + 1.0));
    power *= 4.0;
    m.second -= term;
    m.fourth += term * (0.25 * power - 1.0);
  }
  return m;
}

/// Half-width quadrature: nodes of (0, pi/2) and the squares of their sines.
struct QuarterTurn {
  std::array<double, gauss_points> cosine, sine_squared, weight;
  QuarterTurn() : cosine(), sine_squared(), weight() {
    const auto& rule = gauss_rule();
    for (std::size_t k = 0; k < gauss_points; ++k) {
      const double t = 0.25 * pi * (1.0 + rule.node[k]);
      cosine[k] = std::cos(t);
      sine_squared[k] = std::sin(t) * std::sin(t);
      weight[k] = 0.25 * pi * rule.weight[k];
    }
  }
};

/// A sphere (R, its center at distance s from the axis) and a tube (r) whose surfaces meet or of which
/// the tube is all inside the sphere.
struct Crossing {
  double radius, distance, cylinder_radius;
  double gap;           ///< r - s
  double half_squared;  ///< R^2 - (r - s)^2

  /// r (r - s cos t) with sin^2(t/2).
  [[nodiscard]] double lever(double sine_squared) const {
    return cylinder_radius * (gap + 2.0 * distance * sine_squared);
  }
};

/// Integral of c^3 / (R (R + c)) lever dt over the part of the tube inside the sphere, c^2 = R^2 - rho^2.
/// The tube lies in the sphere all around.
double inner_term_all_around(const Crossing& x) {
  static const QuarterTurn nodes;
  const double k2 = 4.0 * x.cylinder_radius * x.distance / x.half_squared;
  const double h = std::sqrt(x.half_squared);
  std::array<double, gauss_points> terms{};
  for (std::size_t k = 0; k < gauss_points; ++k) {
    const double c = h * std::sqrt(std::max(0.0, 1.0 - k2 * nodes.sine_squared[k]));
    terms[k] =
        nodes.weight[k] * c * c * c / (x.radius * (x.radius + c)) * x.lever(nodes.sine_squared[k]);
  }
  double sum = 0.0;
  for (const double term : terms) sum += term;
  return 4.0 * sum;
}

/// The same where the tube is in the sphere for sin^2(t/2) < k2 < 1: with sin(t/2) = k sin(psi) the
/// integrand is smooth, c = h cos(psi).
double inner_term_up_to(const Crossing& x, double k2) {
  static const QuarterTurn nodes;
  const double h = std::sqrt(x.half_squared);
  std::array<double, gauss_points> terms{};
  for (std::size_t k = 0; k < gauss_points; ++k) {
    const double s2 = k2 * nodes.sine_squared[k];
    const double c = h * nodes.cosine[k];
    terms[k] = nodes.weight[k] * nodes.cosine[k] / std::sqrt(1.0 - s2) * c * c * c /
               (x.radius * (x.radius + c)) * x.lever(s2);
  }
  double sum = 0.0;
  for (const double term : terms) sum += term;
  return 4.0 * std::sqrt(k2) * sum;
}

}  // namespace

double disc_area_below(double radius, double x) {
  if (x <= -radius) return 0.0;
  if (x >= radius) return pi * radius * radius;
  return radius * radius * (0.5 * pi + std::asin(x / radius)) +
         x * std::sqrt((radius - x) * (radius + x));
}

double disc_in_disc(double radius, double other_radius, double distance) {
  const double a = std::min(radius, other_radius);
  const double b = std::max(radius, other_radius);
  const double s = distance;
  if (s >= a + b || a <= 0.0) return 0.0;
  if (s <= b - a) return pi * a * a;
  const double chord =
      std::sqrt((s + a + b) * (s + a - b) * std::max(0.0, s - a + b) * (a + b - s));
  // Segments of both discs beyond their common chord; twice the half angle each.
  const double at_a = 2.0 * std::atan2(chord, s * s + (a - b) * (a + b));
  const double at_b = 2.0 * std::atan2(chord, s * s + (b - a) * (a + b));
  return 0.5 * (a * a * moments(at_a).second + b * b * moments(at_b).second);
}

// V = 2/3 (R^3 alpha + 2 R I_1 - I_2 / R - J), section 1 of docs/theory/analysis.md.
double volume_in_cylinder(double radius, double distance, double cylinder_radius) {
  const double s = std::abs(distance);
  const double r = cylinder_radius;
  if (r <= 0.0 || s >= r + radius) return 0.0;
  if (s + radius <= r) return sphere_volume(radius);

  const double gap = r - s;
  const Crossing x{radius, s, r, gap, (radius - std::abs(gap)) * (radius + std::abs(gap))};
  double angle = pi;   // of the tube's part inside the sphere, to one side
  double alpha = 0.0;  // of the sphere's equator inside the tube
  double inner = 0.0;
  if (r + s < radius) {
    inner = inner_term_all_around(x);
  } else {
    const double k2 = std::min(1.0, x.half_squared / (4.0 * r * s));
    angle = 2.0 * std::asin(std::sqrt(k2));
    alpha = 2.0 * (pi - std::atan2(r * std::sin(angle), gap - 2.0 * r * k2));
    inner = inner_term_up_to(x, k2);
  }
  const auto m = moments(angle);
  const double i1 = 2.0 * r * (gap * angle + s * m.second);
  const double i2 =
      r * (2.0 * gap * gap * gap * angle + (4.0 * r * s * gap + 2.0 * s * gap * gap) * m.second +
           8.0 * r * s * s * m.fourth);
  return 2.0 / 3.0 * (radius * radius * radius * alpha + 2.0 * radius * i1 - i2 / radius - inner);
}

}  // namespace packbed::analysis
