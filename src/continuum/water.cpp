// SPDX-License-Identifier: BSD-3-Clause
#include "continuum/water.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <span>

namespace packbed::continuum {
namespace {

struct Term {
  double factor;
  int power;
};

double sum_of_powers(std::span<const Term> terms, double x) {
  double sum = 0.0;
  for (const auto& term : terms) sum += term.factor * std::pow(x, term.power);
  return sum;
}

// IAPWS SR6-08 eq. (2), table 1: coefficients a_5 .. a_10 with n_i, b_5 .. b_10 with m_i.
constexpr double a5 = 1.93763157e-2;
constexpr std::array<Term, 5> a{{{6.74458446e3, 4},
                                 {-2.22521604e5, 5},
                                 {1.00231247e8, 7},
                                 {-1.63552118e9, 8},
                                 {8.32299658e9, 9}}};
constexpr std::array<Term, 6> b{{{5.78545292e-3, 1},
                                 {-1.53195665e-2, 2},
                                 {3.11337859e-2, 3},
                                 {-4.23546241e-2, 4},
                                 {3.38713507e-2, 5},
                                 {-1.19946761e-2, 6}}};

}  // namespace

double water_density(double temperature) {
  assert(temperature >= water_coldest && temperature <= water_hottest);
  // v = R T_R / p0 (a5 + sum a_i alpha^n_i + sum b_i beta^m_i)
  constexpr double r = 461.51805;  // J/(kg K)
  constexpr double t_r = 10.0;     // K
  constexpr double p0 = 1e5;       // Pa
  const double alpha = t_r / (593.0 - temperature);
  const double beta = t_r / (temperature - 232.0);
  const double v = r * t_r / p0 * (a5 + sum_of_powers(a, alpha) + sum_of_powers(b, beta));
  return 1.0 / v;
}

double water_viscosity(double temperature) {
  assert(temperature >= water_coldest && temperature <= water_hottest);
  // IAPWS SR6-08 eq. (7): mu = 1e-6 Pa s sum c_i (T / 300 K)^d_i
  const double t = temperature / 300.0;
  return 1e-6 * (280.68 * std::pow(t, -1.9) + 511.45 * std::pow(t, -7.7) +
                 61.131 * std::pow(t, -19.6) + 0.45903 * std::pow(t, -40.0));
}

}  // namespace packbed::continuum
