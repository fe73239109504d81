// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Nonlinear least squares with bounds: Levenberg-Marquardt of GSL on transformed parameters, and what the
/// data say about the parameters. Theory: docs/theory/bead.md, section 6.

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace packbed::study {

/// One parameter of a model. It stays between `low` and `high`; both finite, or low = -inf and high = inf.
struct FitParameter {
  std::string name;
  double start = 0.0;
  double low = 0.0;
  double high = 0.0;
  bool logarithmic = false;  ///< fitted as ln p; low must be positive. For what spans decades.
};

/// A model with data: fills `residuals` (model less data, over the standard deviation of the datum where it is
/// known) for `values` of the parameters. Must give finite numbers anywhere within the bounds, and not throw.
struct FitProblem {
  std::vector<FitParameter> parameters;
  std::size_t rows = 0;
  std::function<void(std::span<const double> values, std::span<double> residuals)> residuals;
  bool known_errors =
      false;  ///< residuals are in standard deviations: intervals do not scale with the misfit
  std::vector<std::vector<double>> starts = {};  ///< where a search may begin, too; see profile.hpp
};

/// A parameter, or a figure made of them, with its interval.
struct Estimate {
  std::string name;
  double value = 0.0;
  double error = 0.0;  ///< standard error; infinite if the data do not determine it
  double low = 0.0;    ///< interval at 95 %; infinite: the data set no limit on this side
  double high = 0.0;
  bool at_bound = false;  ///< the fit rests on a bound; error and interval mean little
};

/// Parameters that only a combination of is known.
struct Confounded {
  std::vector<std::string> names;
};

struct Fit {
  std::vector<FitParameter> parameters;
  std::vector<Estimate> estimates;  ///< one per parameter
  std::vector<double> correlation;  ///< n x n, row by row; NaN where not determined
  std::vector<Confounded> confounded;
  double sum_of_squares = 0.0;
  std::size_t rows = 0;
  int iterations = 0;
  bool converged = false;
  double quantile = 0.0;  ///< of Student's t (or the normal distribution) for the intervals
  std::vector<double> covariance;  ///< n x n, of ln p for logarithmic parameters

  [[nodiscard]] std::vector<double> values() const;
  [[nodiscard]] std::size_t size() const { return parameters.size(); }
  /// Bayesian information criterion n ln(S/n) + k ln n; smaller is better.
  [[nodiscard]] double bic() const;
};

/// Throws ValueError if there are fewer rows than parameters plus one.
Fit least_squares(const FitProblem& problem);

/// Values and sum of squares alone, without errors, intervals and correlations; found when four steps in a row gain
/// less than `least_gain` in the sum.
Fit least_squares_values(const FitProblem& problem, double least_gain);

/// Best of several starts, each a list of values of the parameters.
struct StartedFit {
  Fit fit;
  int starts = 0;
  int agreeing = 0;  ///< starts that ended at the same sum of squares, to 1e-4
};
StartedFit least_squares(const FitProblem& problem, const std::vector<std::vector<double>>& starts);

/// A figure that follows from the parameters, with its error by propagation (first order).
Estimate derived(const Fit& fit,
                 const std::string& name,
                 const std::function<double(std::span<const double>)>& figure);

/// Linear least squares: amplitudes a with which sum_k a_k basis_k is nearest to data; `sum_of_squares` of what
/// remains. Used for starting values.
struct Amplitudes {
  std::vector<double> values;
  double sum_of_squares = 0.0;
};
Amplitudes amplitudes(const std::vector<std::vector<double>>& basis, std::span<const double> data);

/// 1 - S / (sum of squares about the mean).
double r_squared(std::span<const double> data, std::span<const double> model);

}  // namespace packbed::study
