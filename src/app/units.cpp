// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/print.hpp"
#include "core/quantity.hpp"
#include "core/text.hpp"

namespace packbed::app {
namespace {

// Ways to write each dimension, shown with their value in SI; tests read them all.
struct Examples {
  Dimension dimension;
  std::vector<std::string> texts;
};

const std::vector<Examples> examples = {
    {Dimension::length, {"90 um", "90 µm", "31 mm", "20 cm", "1 inch"}},
    {Dimension::time, {"2 us", "10 ms", "0.5 s", "2 min", "3 h"}},
    {Dimension::velocity, {"2763 cm/h", "300 cm h-1", "20 mm/min", "0.1 m/s"}},
    {Dimension::volume_flow, {"2 L/h", "33 mL/min", "1e-6 m3/s"}},
    {Dimension::pressure, {"3 bar", "30 MPa", "101325 Pa", "45 psi"}},
    {Dimension::viscosity, {"1 mPa s", "1 mPas", "1 cP", "0.001 Pa.s"}},
    {Dimension::density, {"1140 kg/m3", "1.14 g/cm3", "998 kg m-3", "1.05 g/mL"}},
    {Dimension::temperature, {"20 degC", "293.15 K", "68 degF"}},
    {Dimension::force, {"0.5 N", "48 mN", "50 uN"}},
    {Dimension::frequency, {"30 Hz", "1800 min-1"}},
    {Dimension::inverse_length, {"1e10 m-1"}},
    {Dimension::fraction, {"0.38", "38 %"}},
};

}  // namespace

int units(const UnitsCommand& command) {
  const UnitSystem system;
  nlohmann::ordered_json root = nlohmann::ordered_json::object();
  for (const auto& [dimension, texts] : examples) {
    const auto& d = info(dimension);
    if (!command.json) fmt::print("{}\n", d.name);
    for (const auto& text : texts) {
      const double si = system.to_si(text, dimension);
      const std::string key = d.suffix.empty() ? "value" : fmt::format("value_{}", d.suffix);
      root[std::string(d.name)].push_back({{"text", text}, {key, si}});
      if (!command.json) {
        fmt::print("  {:<14} = {} {}\n", text, shortest(si), d.si_unit == "1" ? "" : d.si_unit);
      }
    }
  }
  if (command.json) fmt::print("{}", json_text(root));
  return 0;
}

}  // namespace packbed::app
