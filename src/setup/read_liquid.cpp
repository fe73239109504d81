// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "continuum/water.hpp"
#include "core/text.hpp"
#include "setup/read_sections.hpp"

namespace packbed::setup {
namespace {

// Temperatures at which water is liquid at 0.1 MPa; the fit of its properties reaches further.
constexpr Bounds liquid_water{.low = 273.15,
                              .high = 373.15,
                              .low_belongs = true,
                              .high_belongs = true,
                              .refusal = "is outside 0 to 100 degC, where water is liquid"};

}  // namespace

LiquidOptions read_liquid(Section section) {
  LiquidOptions liquid{};
  section.mention({"name", "temperature", "density", "viscosity", "wall_void_fraction"});
  const bool own_values = section.has("density") || section.has("viscosity");
  liquid.name = section.word("name", Fallback{own_values ? "own" : "water"});
  if (edit_distance(liquid.name, "water") != 0 && !own_values) {
    section.fail("name", "is not known; give \"water\", or density and viscosity of your liquid");
  }
  if (own_values) {
    section.refuse("temperature", "does not go with density and viscosity; give one or the other");
    liquid.density = section.quantity("density", Dimension::density, bounds::positive);
    liquid.viscosity = section.quantity("viscosity", Dimension::viscosity, bounds::positive);
  } else {
    const double t =
        section.quantity("temperature", Dimension::temperature, liquid_water, Fallback{"20 degC"});
    liquid.temperature = t;
    liquid.density = continuum::water_density(t);
    liquid.viscosity = continuum::water_viscosity(t);
  }
  liquid.wall_void_fraction = section.quantity_or_word(
      "wall_void_fraction", Dimension::fraction, bounds::void_fraction, "bed", Fallback{"bed"});
  section.finish();
  return liquid;
}

}  // namespace packbed::setup
