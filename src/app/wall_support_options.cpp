// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <fmt/format.h>

#include "app/library.hpp"
#include "app/liquid.hpp"
#include "app/quantities.hpp"
#include "app/wall_support_commands.hpp"
#include "core/csv.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "setup/data_columns.hpp"

namespace packbed::app {
namespace {

using enum Dimension;
namespace bounds = setup::bounds;
using continuum::BedModulus;

constexpr setup::Bounds bed_poisson{.low = 0.0,
                                    .high = 0.5,
                                    .low_belongs = true,
                                    .high_belongs = true,
                                    .refusal = "is outside [0, 0.5]"};

/// Values of a resin, or of the option that replaces them.
class BedValues {
 public:
  BedValues(const UnitSystem& units, const WallSupportOptions& options) : units_(units) {
    if (options.resin.empty()) return;
    library_ = setup::builtin_library(units);
    if (!options.library.empty()) library_.add(setup::read_library(options.library, units));
    resin_ = &find_resin(library_, options.resin);
  }
  [[nodiscard]] double value(const Option& option,
                             const std::string& key,
                             Dimension dimension,
                             const setup::Bounds& accepted) const {
    if (!option.text.empty() || resin_ == nullptr)
      return quantity(units_, option, dimension, accepted);
    return property(*resin_, key, std::string(option.name));
  }
  [[nodiscard]] const resin::Property* find(std::string_view key) const {
    return resin_ == nullptr ? nullptr : resin_->find(key);
  }

 private:
  const UnitSystem& units_;
  resin::Library library_;
  const resin::Resin* resin_ = nullptr;
};

BedModulus read_table(const WallSupportOptions& o, const UnitSystem& units) {
  const CsvTable table(o.table);
  const setup::DataColumns columns(table, units, "compression,modulus [MPa]");
  try {
    return continuum::TabulatedModulus::from(columns.values("compression", fraction),
                                             columns.values("modulus", pressure));
  } catch (const ValueError& error) {
    throw ConfigError(fmt::format("{}: {}", o.table, error.what()));
  }
}

BedModulus read_modulus(const WallSupportOptions& o,
                        const UnitSystem& units,
                        const BedValues& values) {
  if (!o.table.empty()) {
    if (!o.modulus.empty()) throw ConfigError("--modulus-table and --B exclude each other");
    return read_table(o, units);
  }
  const double b = values.value({"--B", o.modulus}, "bed_modulus", pressure, bounds::positive);
  const double reference = quantity_or(units, {"--reference-compression", o.reference_compression},
                                       fraction, bounds::between_0_and_1, 0.05);
  const std::vector<std::string> known{"constant", "hertz", "power"};
  if (o.stiffening == "power") {
    return continuum::PowerModulus{
        b, reference, quantity(units, {"--exponent", o.exponent}, fraction, bounds::positive)};
  }
  if (!o.exponent.empty())
    throw ConfigError("--exponent belongs to --stiffening power; leave it out");
  if (o.stiffening == "hertz") return continuum::PowerModulus{b, reference, 1.5};
  if (o.stiffening != "constant") {
    throw ConfigError(fmt::format("--stiffening \"{}\" is not known; known are {}", o.stiffening,
                                  either_of(known)));
  }
  if (!o.reference_compression.empty())
    throw ConfigError(
        "--reference-compression belongs to --stiffening hertz or power; leave it out");
  return continuum::ConstantModulus{b};
}

}  // namespace

WallSupportBed read_wall_support(const WallSupportOptions& o, const UnitSystem& units) {
  const BedValues values(units, o);
  WallSupportBed result;
  result.bed = {
      .modulus = read_modulus(o, units, values),
      .diameter = values.value({"--bead-diameter", o.bead_diameter}, "hydrodynamic_diameter",
                               length, bounds::positive),
      .wall_friction = values.value({"--wall-friction", o.wall_friction}, "bed_wall_friction",
                                    fraction, bounds::not_negative),
      .poisson = values.value({"--poisson", o.poisson}, "bed_poisson_ratio", fraction, bed_poisson),
      .density_difference = values.value({"--density-difference", o.density_difference},
                                         "bed_density_difference", density, bounds::not_negative),
      .eps0 = values.value({"--settled-porosity", o.settled_porosity}, "settled_porosity", fraction,
                           bounds::between_0_and_1)};
  result.column.height =
      o.height.empty() ? 0.0 : quantity(units, {"--height", o.height}, length, bounds::positive);
  result.column.mu_f = read_liquid(units, o.viscosity, "", o.temperature).viscosity;
  if (o.reading != "material" && o.reading != "fixed") {
    throw ConfigError(
        fmt::format("--reading \"{}\" is not known; known are material or fixed", o.reading));
  }
  result.column.reading =
      o.reading == "material" ? continuum::Reading::material : continuum::Reading::fixed;
  result.calibrated =
      optional_quantity(units, {"--calibrated-compression", o.calibrated_compression}, fraction,
                        bounds::between_0_and_1);
  const auto* known = values.find("bed_calibrated_compression");
  if (!result.calibrated && known != nullptr) result.calibrated = known->si;
  return result;
}

}  // namespace packbed::app
