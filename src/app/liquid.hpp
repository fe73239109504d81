// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/quantity.hpp"

namespace packbed::app {

struct Liquid {
  double density = 0.0;    ///< [kg/m3]
  double viscosity = 0.0;  ///< [Pa s]
};

/// Water of the temperature, if one is given; otherwise 1000 kg/m3 and 1 mPa s, as the thesis uses. Density and
/// viscosity replace either. Throws ConfigError for what is refused.
Liquid read_liquid(const UnitSystem& units,
                   const std::string& viscosity,
                   const std::string& density,
                   const std::string& temperature);

}  // namespace packbed::app
