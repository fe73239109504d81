// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Columns of a measured table by name, converted from the unit in their header: "force [uN]". Tables that packbed wrote
/// have the SI unit at the end of the name, "force_N"; they are read, too.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/csv.hpp"
#include "core/quantity.hpp"

namespace packbed::setup {

class DataColumns {
 public:
  /// `header`: an example of the whole header, shown where a column is missing.
  DataColumns(const CsvTable& table, const UnitSystem& units, std::string header)
      : table_(table), units_(units), header_(std::move(header)) {}

  [[nodiscard]] bool has(std::string_view name, Dimension dimension) const {
    return find(name, info(dimension).suffix).has_value();
  }
  [[nodiscard]] bool has_text(std::string_view name) const { return find(name).has_value(); }

  /// All rows in SI. Throws ConfigError "FILE:LINE: ..." for a missing column, a missing or wrong unit, a cell
  /// that is no number. A fraction needs no unit; [-] and [%] are accepted.
  [[nodiscard]] std::vector<double> values(std::string_view name, Dimension dimension) const;
  /// All rows of a pressure per length in Pa/m: "name [bar/m]" or "name_Pa_m".
  [[nodiscard]] std::vector<double> pressure_gradients(std::string_view name) const;
  /// All rows as text.
  [[nodiscard]] std::vector<std::string> texts(std::string_view name) const;

  [[nodiscard]] const CsvTable& table() const { return table_; }

 private:
  struct Found {
    int column;
    std::string unit;
  };
  [[nodiscard]] std::vector<double> converted(const Found& found,
                                              std::string_view name,
                                              std::string_view unit,
                                              Dimension dimension) const;
  [[nodiscard]] std::optional<Found> find(std::string_view name,
                                          std::string_view suffix = "") const;
  [[nodiscard]] Found required(std::string_view name, std::string_view suffix = "") const;

  const CsvTable& table_;
  const UnitSystem& units_;
  std::string header_;
};

}  // namespace packbed::setup
