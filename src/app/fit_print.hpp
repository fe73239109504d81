// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Fits as tables and as JSON.

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "study/curve_fit.hpp"

namespace packbed::app {

/// "linear" or "profile", as the user wrote it. Throws ConfigError.
study::Intervals read_intervals(const std::string& text);

/// A figure in the unit that people use, by the SI unit at the end of its name: "G0_Pa" in MPa.
struct Shown {
  std::string name;  ///< "G0 [MPa]"
  double factor;
};
Shown shown(const std::string& name);

/// { value, error, low, high [, at_bound] }; what is not finite becomes null: unknown, or open.
nlohmann::ordered_json estimate_json(const study::Estimate& estimate);

/// Correlations of the parameters: an array of arrays.
nlohmann::ordered_json correlation_json(const study::Fit& fit);

nlohmann::ordered_json fit_json(const study::CurveFit& fit);
/// Mean and standard deviation of every figure over the curves.
nlohmann::ordered_json over_curves_json(const std::vector<study::CurveFit>& fits);

void print_estimate(const study::Estimate& estimate);
void print_correlation(const study::Fit& fit);
void print_fit(const study::CurveFit& fit);
void print_over_curves(const std::vector<study::CurveFit>& fits);

}  // namespace packbed::app
