// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Intervals by profile likelihood: how far a figure can be moved, all parameters following, until the misfit says
/// no. They need not be symmetric, and may be open. Theory: docs/theory/bead.md, section 6.

#include <functional>
#include <span>

#include "study/least_squares.hpp"

namespace packbed::study {

/// How the 95 % intervals of a fit are made.
enum class Intervals {
  linear,   ///< from the covariance at the solution: first order, and always there
  profile,  ///< from the sums of squares of fits with the figure held elsewhere
};

/// Gives each estimate of `fit`, the solution of `problem`, the interval in which
///   S(p) <= S_min + s^2 t^2,   S(p) the least sum of squares with this parameter at p,
/// s^2 the variance and t the quantile of the linear interval. Standard errors stay. A side on which S does not get
/// there before the bound of a parameter is open: infinite. Where S seems to be beyond, the search is repeated from
/// each of problem.starts: a fit with the parameter held may have several minima.
void profile_parameters(const FitProblem& problem, Fit& fit);

/// The same for a figure that follows from the parameters; `estimate` is what derived() made of it.
void profile_figure(const FitProblem& problem,
                    const Fit& fit,
                    const std::function<double(std::span<const double>)>& figure,
                    Estimate& estimate);

}  // namespace packbed::study
