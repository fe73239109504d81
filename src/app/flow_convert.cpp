// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/flow_commands.hpp"
#include "app/print.hpp"
#include "app/quantities.hpp"
#include "continuum/compression.hpp"
#include "core/error.hpp"

namespace packbed::app {
namespace {

using continuum::Compression;
using enum Dimension;
namespace bounds = setup::bounds;

constexpr setup::Bounds below_1{
    .low = 0.0, .high = 1.0, .low_belongs = true, .refusal = "is outside [0, 1)"};

std::optional<double> eps0_of(const ConvertCommand& c, const UnitSystem& units) {
  return optional_quantity(units, {"--settled-porosity", c.settled_porosity}, fraction,
                           bounds::between_0_and_1);
}

double needed(const std::optional<double>& eps0, const char* option) {
  if (!eps0) throw ConfigError(fmt::format("{} needs --settled-porosity", option));
  return *eps0;
}

Compression read(const ConvertCommand& c,
                 const UnitSystem& units,
                 const std::optional<double>& eps0,
                 double consolidated) {
  std::vector<std::string> given;
  Compression result;
  const auto take = [&](const char* name, const std::string& text, const setup::Bounds& accepted,
                        auto make) {
    if (text.empty()) return;
    given.emplace_back(name);
    result = make(quantity(units, {name, text}, fraction, accepted));
  };
  take("--compression", c.compression, below_1, [](double v) { return Compression{v}; });
  take("--relative-to-packed", c.relative, bounds::not_negative,
       [](double v) { return Compression::from_relative_to_packed(v); });
  take("--factor", c.factor, bounds::at_least_1,
       [](double v) { return Compression::from_factor(v); });
  take("--packing-factor", c.packing_factor, bounds::at_least_1,
       [&](double v) { return Compression::from_packing_factor(v, consolidated); });
  take("--density", c.density, bounds::between_0_and_1,
       [&](double v) { return Compression::from_density(v, needed(eps0, "--density")); });
  take("--porosity", c.porosity, bounds::between_0_and_1,
       [&](double v) { return Compression::from_porosity(v, needed(eps0, "--porosity")); });
  if (!c.height.empty()) {
    given.emplace_back("--height");
    const double h = quantity(units, {"--height", c.height}, length, bounds::positive);
    result = Compression::from_factor(
        quantity(units, {"--settled-height", c.settled_height}, length, bounds::positive) / h);
  }
  if (given.size() != 1) {
    throw ConfigError(
        fmt::format("give exactly one of --compression, --relative-to-packed, --factor, "
                    "--packing-factor, --density, --porosity and --height{}",
                    given.empty() ? "" : fmt::format("; given are {}", fmt::join(given, ", "))));
  }
  return result;
}

}  // namespace

int flow_convert(const ConvertCommand& c) {
  const UnitSystem units;
  const auto eps0 = eps0_of(c, units);
  const double consolidated =
      quantity_or(units, {"--consolidated", c.consolidated}, fraction, below_1, 0.0);
  const auto compression = read(c, units, eps0, consolidated);
  if (compression.lambda < 0.0) {
    throw ConfigError(fmt::format("that is a bed looser than the settled one (compression {:.4g})",
                                  compression.lambda));
  }
  if (eps0 && compression.lambda >= *eps0) {
    throw ConfigError(
        fmt::format("a compression of {:.4g} leaves no pores at a settled porosity of {:.4g}",
                    compression.lambda, *eps0));
  }
  nlohmann::ordered_json j{{"compression", compression.lambda},
                           {"compression_relative_to_packed", compression.relative_to_packed()},
                           {"compression_factor", compression.factor()},
                           {"packing_factor", compression.packing_factor(consolidated)}};
  if (eps0) {
    j["packing_density"] = compression.density(*eps0);
    j["porosity"] = compression.porosity(*eps0);
  }
  if (const auto h0 = optional_quantity(units, {"--settled-height", c.settled_height}, length,
                                        bounds::positive)) {
    j["height_m"] = *h0 * (1.0 - compression.lambda);
  }
  if (c.json) {
    fmt::print("{}", json_text(j));
    return 0;
  }
  const auto line = [&](const char* key, const char* name) {
    if (j.contains(key)) fmt::print("{:<44} {:.6g}\n", name, j[key].get<double>());
  };
  line("compression", "compression lambda = (H0 - H) / H0");
  line("compression_relative_to_packed", "relative to the packed bed (H0 - H) / H");
  line("compression_factor", "compression factor H0 / H");
  line("packing_factor", "packing factor H consolidated / H");
  line("packing_density", "packing density 1 - eps");
  line("porosity", "porosity eps");
  line("height_m", "height H [m]");
  return 0;
}

}  // namespace packbed::app
