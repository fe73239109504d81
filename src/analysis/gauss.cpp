// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/gauss.hpp"

#include <boost/math/quadrature/gauss.hpp>

namespace packbed::analysis {
namespace {

GaussRule make_rule() {
  using Boost = boost::math::quadrature::gauss<double, gauss_points>;
  const auto& nodes = Boost::abscissa();  // the positive half
  const auto& weights = Boost::weights();
  GaussRule rule;
  for (std::size_t k = 0; k < gauss_points / 2; ++k) {
    rule.node[2 * k] = -nodes[k];
    rule.node[2 * k + 1] = nodes[k];
    rule.weight[2 * k] = rule.weight[2 * k + 1] = weights[k];
  }
  return rule;
}

}  // namespace

const GaussRule& gauss_rule() {
  static const GaussRule rule = make_rule();
  return rule;
}

}  // namespace packbed::analysis
