// SPDX-License-Identifier: BSD-3-Clause
#include "study/regression.hpp"

#include <vector>

#include <gsl/gsl_fit.h>

#include "study/least_squares.hpp"

namespace packbed::study {

Line regression(std::span<const double> x, std::span<const double> y) {
  Line line;
  double cov00 = 0.0, cov01 = 0.0, cov11 = 0.0, sum = 0.0;
  gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &line.intercept, &line.slope, &cov00, &cov01,
                 &cov11, &sum);
  std::vector<double> model;
  for (const double at : x) model.push_back(line.intercept + line.slope * at);
  line.r2 = r_squared(y, model);
  return line;
}

}  // namespace packbed::study
