// SPDX-License-Identifier: BSD-3-Clause
#include "dem/contact/contact.hpp"

#include <cmath>
#include <numbers>

namespace packbed::dem {

double damping_ratio(double restitution) {
  const double log_e = std::log(restitution);
  return -log_e / std::hypot(log_e, std::numbers::pi);
}

}  // namespace packbed::dem
