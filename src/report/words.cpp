// SPDX-License-Identifier: BSD-3-Clause
#include "report/words.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "report/plot.hpp"

namespace packbed::report {

std::string text(const Json& values, const char* pointer) {
  const Json::json_pointer at(pointer);
  if (!values.contains(at)) return {};
  const auto& value = values.at(at);
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return fmt::format("{:g}", value.get<double>());
  return value.dump();
}

std::string in_si(const std::string& words,
                  Dimension dimension,
                  const UnitSystem& units,
                  std::string (*write)(double)) {
  try {
    return write(units.to_si(words, dimension));
  } catch (const ValueError&) {
    return words;  // a word such as "auto", or a flow rate where a velocity is looked for
  }
}

std::string length(const std::string& words, const UnitSystem& units) {
  return in_si(words, Dimension::length, units, [](double meters) {
    return meters < 0.5e-3 ? fmt::format("{:.4g} um", per_um * meters)
                           : fmt::format("{:.4g} mm", per_mm * meters);
  });
}

std::string flow(const std::string& words, const UnitSystem& units) {
  return in_si(words, Dimension::velocity, units,
               [](double velocity) { return fmt::format("{:.4g} cm/h", per_cm_h * velocity); });
}

}  // namespace packbed::report
