// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/settled_porosity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace packbed::column {
namespace {

struct Measured {
  double friction;
  double porosity;
  double coordination;
};

constexpr std::array without_rolling_friction = {
    Measured{0.0, 0.3586, 5.90}, Measured{0.02, 0.3644, 5.67}, Measured{0.1, 0.3778, 5.18},
    Measured{0.2, 0.3980, 4.84}, Measured{0.5, 0.4124, 4.45}};
constexpr std::array with_rolling_friction = {
    Measured{0.0, 0.3586, 5.90}, Measured{0.02, 0.3651, 5.56}, Measured{0.05, 0.3778, 5.34},
    Measured{0.1, 0.3930, 4.93}, Measured{0.2, 0.4206, 4.39},  Measured{0.5, 0.4480, 3.65}};
constexpr double measured_rolling_friction = 0.35;  // of the second list
// At rolling friction 0.1 and friction 0.1 two thirds of the difference are reached (0.3880).
constexpr double saturation = 0.09;

double interpolated(std::span<const Measured> list, double friction, double Measured::*what) {
  std::size_t k = 0;
  while (k + 2 < list.size() && friction >= list[k + 1].friction) ++k;
  const double width = list[k + 1].friction - list[k].friction;
  const double share = std::clamp((friction - list[k].friction) / width, 0.0, 1.0);
  return (1.0 - share) * list[k].*what + share * list[k + 1].*what;
}

double measured(double friction, double rolling_friction, double Measured::*what) {
  const double share = std::min(1.0, (1.0 - std::exp(-rolling_friction / saturation)) /
                                         (1.0 - std::exp(-measured_rolling_friction / saturation)));
  return (1.0 - share) * interpolated(without_rolling_friction, friction, what) +
         share * interpolated(with_rolling_friction, friction, what);
}

}  // namespace

double settled_porosity(double friction, double rolling_friction) {
  return measured(friction, rolling_friction, &Measured::porosity);
}

double settling_friction(double porosity, double rolling_friction) {
  double low = with_rolling_friction.front().friction;
  double high = with_rolling_friction.back().friction;
  for (int n = 0; n < 50; ++n) {
    const double middle = 0.5 * (low + high);
    (settled_porosity(middle, rolling_friction) < porosity ? low : high) = middle;
  }
  return high;
}

double settled_coordination(double porosity, double rolling_friction) {
  return measured(settling_friction(porosity, rolling_friction), rolling_friction,
                  &Measured::coordination);
}

}  // namespace packbed::column
