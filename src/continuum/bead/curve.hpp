// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace packbed::continuum {

/// One measured compression of one bead, row by row in the order of time. SI units.
struct BeadCurve {
  std::string name;              ///< for messages and tables
  double radius = 0.0;           ///< [m]
  std::vector<double> time;      ///< [s]
  std::vector<double> approach;  ///< displacement of the plates [m]
  std::vector<double> force;     ///< [N]
};

}  // namespace packbed::continuum
