// SPDX-License-Identifier: BSD-3-Clause
#include "continuum/bead/loop.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace packbed::continuum {

double LoopWork::restitution() const { return std::sqrt(unloading / loading); }

LoopWork loop_work(std::span<const double> approach, std::span<const double> force) {
  const auto top = static_cast<std::size_t>(std::ranges::max_element(approach) - approach.begin());
  const auto strip = [&](std::size_t i) {
    return 0.5 * (force[i] + force[i - 1]) * (approach[i] - approach[i - 1]);
  };
  LoopWork work;
  for (std::size_t i = 1; i <= top; ++i) work.loading += strip(i);
  for (std::size_t i = top + 1; i < force.size() && force[i - 1] > 0.0; ++i) {
    work.unloading -= strip(i);
  }
  if (!(work.loading > 0.0)) {
    throw ValueError("the curve has no loading: the displacement is largest in the first row");
  }
  if (!(work.unloading > 0.0)) {
    throw ValueError(
        "the curve has no unloading: the displacement does not fall after its largest");
  }
  return work;
}

}  // namespace packbed::continuum
