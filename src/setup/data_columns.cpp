// SPDX-License-Identifier: BSD-3-Clause
#include "setup/data_columns.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::setup {

std::optional<DataColumns::Found> DataColumns::find(std::string_view name,
                                                    std::string_view suffix) const {
  for (std::size_t i = 0; i < table_.header().size(); ++i) {
    if (!suffix.empty() && table_.header()[i] == fmt::format("{}_{}", name, suffix)) {
      return Found{static_cast<int>(i), ""};
    }
    const auto column = split_column_name(table_.header()[i]);
    if (column.name == name) return Found{static_cast<int>(i), column.unit};
  }
  return std::nullopt;
}

DataColumns::Found DataColumns::required(std::string_view name, std::string_view suffix) const {
  const auto found = find(name, suffix);
  if (!found) {
    throw ConfigError(fmt::format("{}: column \"{}\" is missing; the header must be like \"{}\"",
                                  table_.header_place(), name, header_));
  }
  return *found;
}

std::vector<double> DataColumns::values(std::string_view name, Dimension dimension) const {
  const auto& wanted = info(dimension);
  auto [column, unit] = required(name, wanted.suffix);
  const auto& header = table_.header()[static_cast<std::size_t>(column)];
  const bool in_si = header != name && unit.empty();
  if (in_si) unit = wanted.si_unit;
  if (unit.empty() && dimension != Dimension::fraction) {
    throw ConfigError(fmt::format("{}: column \"{}\" has no unit; the header must be like \"{}\"",
                                  table_.header_place(), name, header_));
  }
  std::vector<double> values;
  for (std::size_t row = 0; row < table_.rows(); ++row) {
    const double number = table_.number(row, column);
    try {
      values.push_back(units_.to_si(fmt::format("{} {}", number, unit), dimension));
    } catch (const ValueError& error) {
      throw ConfigError(
          fmt::format("{}: unit [{}] of \"{}\" is refused: {}; the header must be like \"{}\"",
                      table_.header_place(), unit, name, error.what(), header_));
    }
  }
  return values;
}

std::vector<std::string> DataColumns::texts(std::string_view name) const {
  const auto found = required(name);
  std::vector<std::string> all;
  for (std::size_t row = 0; row < table_.rows(); ++row)
    all.push_back(table_.text(row, found.column));
  return all;
}

}  // namespace packbed::setup
