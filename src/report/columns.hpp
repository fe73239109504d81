// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace packbed::report {

/// A table that a run has written, column by column: numbers, and texts where they are asked for. Empty cells are
/// NaN.
class Columns {
 public:
  Columns() = default;
  /// Throws DataError "FILE:LINE: ..." for a file that cannot be read, or is not such a table.
  /// `text_column` is the name of a column of texts; empty: there is none.
  explicit Columns(const std::filesystem::path& file, std::string_view text_column = {});

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] bool empty() const { return rows_ == 0; }
  [[nodiscard]] bool has(std::string_view name) const {
    return columns_.find(name) != columns_.end();
  }
  /// All rows of a column. Throws DataError naming the file if there is none.
  [[nodiscard]] const std::vector<double>& operator[](std::string_view name) const;
  /// The column of texts; empty if there is none.
  [[nodiscard]] const std::vector<std::string>& texts() const { return texts_; }

 private:
  std::filesystem::path file_;
  std::size_t rows_ = 0;
  std::map<std::string, std::vector<double>, std::less<>> columns_;
  std::vector<std::string> texts_;
};

}  // namespace packbed::report
