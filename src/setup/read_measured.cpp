// SPDX-License-Identifier: BSD-3-Clause
#include "setup/read_measured.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/csv.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "setup/data_columns.hpp"

namespace packbed::setup {
namespace {

constexpr auto example =
    "superficial velocity [cm/h],pressure drop [bar],pressure drop per height [bar/m],"
    "compression [-],bed height [mm]";

const std::array<std::string, 5> names = {"superficial velocity", "pressure drop",
                                          "pressure drop per height", "compression", "bed height"};

void refuse_unknown_columns(const CsvTable& table) {
  for (const auto& header : table.header()) {
    const auto name = split_column_name(header).name;
    if (std::ranges::find(names, name) != names.end()) continue;
    const auto near = nearest(name, names);
    throw ConfigError(fmt::format(
        "{}: column \"{}\" is not known{}; the header must be like \"{}\"", table.header_place(),
        header, near ? fmt::format(", did you mean \"{}\"?", *near) : "", example));
  }
}

bool has(const CsvTable& table, const std::string& name) {
  return std::ranges::any_of(table.header(), [&](const std::string& header) {
    return split_column_name(header).name == name;
  });
}

void need(const CsvTable& table,
          const std::vector<double>& values,
          bool (*is_good)(double),
          std::string_view what) {
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (is_good(values[row])) continue;
    throw ConfigError(fmt::format("{}: {}", table.place(row), what));
  }
}

}  // namespace

MeasuredFlow read_measured(const std::filesystem::path& file, const UnitSystem& units) {
  const CsvTable table(file);
  refuse_unknown_columns(table);
  const DataColumns columns(table, units, example);
  const auto values = [&](const std::string& name, Dimension dimension) {
    return has(table, name) ? columns.values(name, dimension) : std::vector<double>{};
  };
  MeasuredFlow m;
  m.superficial_velocity = columns.values(names[0], Dimension::velocity);
  m.pressure_drop = values(names[1], Dimension::pressure);
  if (has(table, names[2])) m.pressure_gradient = columns.pressure_gradients(names[2]);
  m.compression = values(names[3], Dimension::fraction);
  m.bed_height = values(names[4], Dimension::length);
  if (table.header().size() == 1) {
    throw ConfigError(
        fmt::format("{}: there is nothing beside the velocity; the header must be like \"{}\"",
                    table.header_place(), example));
  }
  need(
      table, m.compression, [](double c) { return c < 1.0; }, "compression must be below 1");
  need(
      table, m.bed_height, [](double h) { return h > 0.0; }, "bed height must be positive");
  return m;
}

std::string to_csv(const MeasuredFlow& m) {
  struct Column {
    std::string_view header;
    const std::vector<double>& values;
  };
  std::vector<Column> columns;
  for (const Column& column :
       {Column{"superficial velocity [m/s]", m.superficial_velocity},
        Column{"pressure drop [Pa]", m.pressure_drop},
        Column{"pressure drop per height [Pa/m]", m.pressure_gradient},
        Column{"compression [-]", m.compression}, Column{"bed height [m]", m.bed_height}}) {
    if (!column.values.empty()) columns.push_back(column);
  }
  std::string text;
  for (const auto& column : columns) {
    text += fmt::format("{}{}", text.empty() ? "" : ",", column.header);
  }
  for (std::size_t row = 0; row < m.superficial_velocity.size(); ++row) {
    text += '\n';
    for (std::size_t i = 0; i < columns.size(); ++i) {
      text += fmt::format("{}{}", i == 0 ? "" : ",", shortest(columns[i].values[row]));
    }
  }
  return text + "\n";
}

}  // namespace packbed::setup
