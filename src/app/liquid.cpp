// SPDX-License-Identifier: BSD-3-Clause
#include "app/liquid.hpp"

#include "app/quantities.hpp"
#include "continuum/water.hpp"

namespace packbed::app {

Liquid read_liquid(const UnitSystem& units,
                   const std::string& viscosity,
                   const std::string& density,
                   const std::string& temperature) {
  constexpr setup::Bounds range{
      .low = continuum::water_coldest,
      .high = continuum::water_hottest,
      .low_belongs = true,
      .high_belongs = true,
      .refusal = "is outside -20 to 110 degC, where the properties of water are known"};
  Liquid liquid{1000.0, 1e-3};
  if (const auto t =
          optional_quantity(units, {"--temperature", temperature}, Dimension::temperature, range)) {
    liquid = {continuum::water_density(*t), continuum::water_viscosity(*t)};
  }
  liquid.density = quantity_or(units, {"--liquid-density", density}, Dimension::density,
                               setup::bounds::positive, liquid.density);
  liquid.viscosity = quantity_or(units, {"--viscosity", viscosity}, Dimension::viscosity,
                                 setup::bounds::positive, liquid.viscosity);
  return liquid;
}

}  // namespace packbed::app
