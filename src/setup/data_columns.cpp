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

std::vector<double> DataColumns::converted(const Found& found,
                                           std::string_view name,
                                           std::string_view unit,
                                           Dimension dimension) const {
  std::vector<double> values;
  for (std::size_t row = 0; row < table_.rows(); ++row) {
    const double number = table_.number(row, found.column);
    try {
      values.push_back(units_.to_si(fmt::format("{} {}", number, unit), dimension));
    } catch (const ValueError& error) {
      throw ConfigError(
          fmt::format("{}: unit [{}] of \"{}\" is refused: {}; the header must be like \"{}\"",
                      table_.header_place(), found.unit, name, error.what(), header_));
    }
  }
  return values;
}

std::vector<double> DataColumns::values(std::string_view name, Dimension dimension) const {
  const auto& wanted = info(dimension);
  const auto found = required(name, wanted.suffix);
  const auto& header = table_.header()[static_cast<std::size_t>(found.column)];
  const bool in_si = header != name && found.unit.empty();
  if (found.unit.empty() && !in_si && dimension != Dimension::fraction) {
    throw ConfigError(fmt::format("{}: column \"{}\" has no unit; the header must be like \"{}\"",
                                  table_.header_place(), name, header_));
  }
  const bool is_plain = dimension == Dimension::fraction && (in_si || found.unit == "-");
  if (is_plain) return converted(found, name, "", dimension);
  return converted(found, name, in_si ? wanted.si_unit : std::string_view(found.unit), dimension);
}

std::vector<double> DataColumns::pressure_gradients(std::string_view name) const {
  const auto found = required(name, "Pa_m");
  if (table_.header()[static_cast<std::size_t>(found.column)] == fmt::format("{}_Pa_m", name)) {
    return converted(found, name, "Pa", Dimension::pressure);
  }
  constexpr std::string_view per_meter = "/m";
  if (!found.unit.ends_with(per_meter)) {
    throw ConfigError(
        fmt::format("{}: unit [{}] of \"{}\" is refused: it is not a pressure per m; the header "
                    "must be like \"{}\"",
                    table_.header_place(), found.unit, name, header_));
  }
  const auto unit = found.unit.substr(0, found.unit.size() - per_meter.size());
  return converted(found, name, unit, Dimension::pressure);
}

std::vector<std::string> DataColumns::texts(std::string_view name) const {
  const auto found = required(name);
  std::vector<std::string> all;
  for (std::size_t row = 0; row < table_.rows(); ++row)
    all.push_back(table_.text(row, found.column));
  return all;
}

}  // namespace packbed::setup
