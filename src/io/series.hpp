// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Tables that grow while a run is under way: one row per output, units in the header.

#include <filesystem>
#include <fstream>
#include <string>
#include <variant>
#include <vector>

namespace packbed::io {

using Cell = std::variant<double, std::int64_t, std::string>;

class SeriesWriter {
 public:
  /// Throws DataError if the file cannot be written, here and at any row.
  SeriesWriter(const std::filesystem::path& file, const std::vector<std::string>& columns);

  /// One value per column, doubles in full precision. The row is on disk when it returns.
  void row(const std::vector<Cell>& cells);

 private:
  void check() const;

  std::filesystem::path file_;
  std::ofstream stream_;
  std::size_t columns_;
};

}  // namespace packbed::io
