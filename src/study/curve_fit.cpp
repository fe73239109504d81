// SPDX-License-Identifier: BSD-3-Clause
#include "study/curve_fit.hpp"

#include <algorithm>

namespace packbed::study {

void add_figure(CurveFit& fit,
                const std::string& name,
                const std::function<double(std::span<const double>)>& figure) {
  fit.figures.push_back(derived(fit.fit, name, figure));
  fit.figures_of.push_back(figure);
}

void profile_intervals(CurveFit& fit) {
  profile_parameters(fit.problem, fit.fit);
  for (std::size_t i = 0; i < fit.figures.size(); ++i) {
    profile_figure(fit.problem, fit.fit, fit.figures_of[i], fit.figures[i]);
  }
}

const Estimate* find(const CurveFit& fit, const std::string& name) {
  for (const auto* list : {&fit.fit.estimates, &fit.figures}) {
    const auto found = std::ranges::find(*list, name, &Estimate::name);
    if (found != list->end()) return &*found;
  }
  return nullptr;
}

std::optional<double> fact(const CurveFit& fit, const std::string& name) {
  for (const auto& [known, value] : fit.facts) {
    if (known == name) return value;
  }
  return std::nullopt;
}

}  // namespace packbed::study
