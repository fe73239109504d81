// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

namespace packbed::study {

/// y = slope x + intercept by linear least squares.
struct Line {
  double slope = 0.0;
  double intercept = 0.0;
  double r2 = 0.0;
};

/// Two points or more, not all of the same x. GSL.
Line regression(std::span<const double> x, std::span<const double> y);

}  // namespace packbed::study
