// SPDX-License-Identifier: BSD-3-Clause
#include "app/quantities.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/text.hpp"

namespace packbed::app {

double quantity(const UnitSystem& units,
                const Option& option,
                Dimension dimension,
                const setup::Bounds& bounds) {
  const auto& wanted = info(dimension);
  const auto help = fmt::format("give a {} such as \"{}\"", wanted.name, wanted.example);
  if (option.text.empty()) throw ConfigError(fmt::format("{} is missing; {}", option.name, help));
  double value = 0.0;
  try {
    value = units.to_si(option.text, dimension);
  } catch (const ValueError& error) {
    throw ConfigError(fmt::format("{} = \"{}\" is refused: {}; {}", option.name, option.text,
                                  error.what(), help));
  }
  if (!bounds.contains(value)) {
    throw ConfigError(
        fmt::format("{} = \"{}\" {}; {}", option.name, option.text, bounds.refusal, help));
  }
  return value;
}

std::optional<double> optional_quantity(const UnitSystem& units,
                                        const Option& option,
                                        Dimension dimension,
                                        const setup::Bounds& bounds) {
  if (option.text.empty()) return std::nullopt;
  return quantity(units, option, dimension, bounds);
}

double quantity_or(const UnitSystem& units,
                   const Option& option,
                   Dimension dimension,
                   const setup::Bounds& bounds,
                   double fallback) {
  return optional_quantity(units, option, dimension, bounds).value_or(fallback);
}

std::vector<double> spread(double low, double high, int count, bool even_ratios) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    const double share = count == 1 ? 1.0 : static_cast<double>(i) / (count - 1);
    values.push_back(even_ratios ? low * std::pow(high / low, share) : low + share * (high - low));
  }
  if (count > 1) values.back() = high;
  return values;
}

void write_csv(const std::string& file,
               const std::vector<std::string>& header,
               const std::vector<std::vector<double>>& columns) {
  if (file.empty()) return;
  std::string text = fmt::format("{}\n", fmt::join(header, ","));
  for (std::size_t row = 0; row < columns.front().size(); ++row) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (c > 0) text += ',';
      text += shortest(columns[c][row]);
    }
    text += '\n';
  }
  write_text_file(file, text);
}

void write_plot(const std::string& file, const std::string& svg) {
  if (!file.empty()) write_text_file(file, svg);
}

}  // namespace packbed::app
