// SPDX-License-Identifier: BSD-3-Clause
// The balance does not depend on the depth but through lambda, so the depth at which the pores close is a quadrature:
//   Z_c(u) = integral from 0 to eps0 of S'(lambda) / (shrink(lambda) rise(lambda, u)) dlambda
// infinite if the rise has a zero (then the wall carries whatever comes). Z_c falls with u; u_crit: Z_c = height.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>

#include "continuum/wall_support/bed_law.hpp"

namespace packbed::continuum {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Law>
std::vector<double> pieces(const Law& /*law*/, double eps0) {
  return {0.0, eps0};
}
// The slope of a table jumps at its rows.
std::vector<double> pieces(const TabulatedModulus& law, double eps0) {
  std::vector<double> ends;
  for (const double lambda : law.rows()) {
    if (lambda < eps0) ends.push_back(lambda);
  }
  ends.push_back(eps0);
  return ends;
}

template <class Law>
class Collapse {
 public:
  Collapse(const CompressibleBed& bed, const WallSupportColumn& column, const Law& law)
      : balance_{bed, column, law}, eps0_(bed.eps0), ends_(pieces(law, bed.eps0)) {}

  // (eps0 - lambda)^3 times the rise: finite at eps0, with the same zeros.
  [[nodiscard]] double scaled_rise(double lambda, double u) const {
    const double c = 1.0 - eps0_;
    const double w = eps0_ - lambda;
    const auto& bed = balance_.bed;
    const double drag =
        180.0 * balance_.column.mu_f * c * c * (1.0 - lambda) * u / (bed.diameter * bed.diameter);
    return drag +
           w * w * w * (balance_.weight(lambda) - balance_.wall(balance_.law.stress(lambda)));
  }

  [[nodiscard]] bool wall_carries_all(double u) const {
    constexpr int grid = 400;
    int least = 0;
    double smallest = infinity;
    for (int i = 0; i <= grid; ++i) {
      const double value = scaled_rise(eps0_ * i / grid, u);
      if (value <= 0.0) return true;
      if (value < smallest) {
        smallest = value;
        least = i;
      }
    }
    const double low = eps0_ * std::max(least - 1, 0) / grid;
    const double high = eps0_ * std::min(least + 1, grid) / grid;
    const auto found = boost::math::tools::brent_find_minima(
        [&](double l) { return scaled_rise(l, u); }, low, high, 40);
    return found.second <= 0.0;
  }

  // lambda = x^2 near 0, where the slope of stiffening laws may be a root.
  [[nodiscard]] double depth(double u) const {
    if (wall_carries_all(u)) return infinity;
    const auto integrand = [&](double x) {
      const double lambda = x * x;
      const double w = eps0_ - lambda;
      return 2.0 * x * balance_.law.slope(lambda) * w * w * w /
             (balance_.shrink(lambda) * scaled_rise(lambda, u));
    };
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < ends_.size(); ++i) {
      sum += boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
          integrand, std::sqrt(ends_[i]), std::sqrt(ends_[i + 1]), 20, 1e-12);
    }
    return sum;
  }

 private:
  detail::BedBalance<Law> balance_;
  double eps0_;
  std::vector<double> ends_;
};

template <class Law>
double critical(const Collapse<Law>& collapse, double height) {
  if (collapse.depth(0.0) <= height) return 0.0;
  double high = 1e-6;  // [m/s]
  while (collapse.depth(high) > height) high *= 2.0;
  double low = 0.5 * high;
  constexpr double still = 1e-12;
  while (collapse.depth(low) <= height) {
    if (low < still) return 0.0;  // on the verge of collapse under its own weight
    low *= 0.5;
  }
  // Where the depth is infinite a finite number of the same sign does for the search.
  const auto excess = [&](double u) { return std::min(collapse.depth(u) / height, 1e6) - 1.0; };
  std::uintmax_t steps = 200;
  const auto [a, b] = boost::math::tools::toms748_solve(
      excess, low, high, boost::math::tools::eps_tolerance<double>(45), steps);
  return 0.5 * (a + b);
}

}  // namespace

double critical_velocity(const CompressibleBed& bed, const WallSupportColumn& column) {
  return std::visit(
      [&](const auto& law) { return critical(Collapse(bed, column, law), column.height); },
      bed.modulus);
}

double critical_velocity_times_height(double modulus, double diameter, double eps0, double mu_f) {
  const double c = 1.0 - eps0;
  const double i = 0.5 - 3.0 * c + 1.5 * c * c + c * c * c - 3.0 * c * c * std::log(c);
  return modulus * diameter * diameter * i / (180.0 * mu_f * c * c);
}

}  // namespace packbed::continuum
