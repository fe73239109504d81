// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Tables of a user: comma-separated text with one header row. Byte order mark, CRLF, blank lines
/// and comment lines (#) are accepted; quoted cells are not needed by any of our tables.

#include <filesystem>
#include <string>
#include <vector>

namespace packbed {

/// One table as text. All rows have as many cells as the header.
class CsvTable {
 public:
  /// Reads `file`. Throws DataError if it cannot be read; ConfigError, naming the line, for a row
  /// of another length, a repeated column, an empty table, or separators other than commas.
  explicit CsvTable(const std::filesystem::path& file);

  [[nodiscard]] const std::vector<std::string>& header() const { return header_; }
  [[nodiscard]] std::size_t rows() const { return lines_.size(); }
  /// Position of a column, or -1.
  [[nodiscard]] int find(const std::string& name) const;
  [[nodiscard]] const std::string& text(std::size_t row, int column) const;
  /// A finite number. Throws ConfigError naming file, line and column.
  [[nodiscard]] double number(std::size_t row, int column) const;
  /// Line of a row in the file, from 1.
  [[nodiscard]] std::size_t line(std::size_t row) const { return lines_[row]; }
  /// "beads.csv:12", for messages.
  [[nodiscard]] std::string place(std::size_t row) const;
  [[nodiscard]] std::string header_place() const;

 private:
  void read_header(const std::string& line, std::size_t number);

  std::filesystem::path file_;
  std::size_t header_line_ = 0;
  std::vector<std::string> header_;
  std::vector<std::size_t> lines_;  ///< line number of each row
  std::vector<std::string> cells_;  ///< row by row
};

/// A column header "diameter [um]" in its parts; the unit is empty if there is none.
struct ColumnName {
  std::string name;
  std::string unit;
};
ColumnName split_column_name(const std::string& header);

}  // namespace packbed
