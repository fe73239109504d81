// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace packbed::report {

/// A table of numbers that a run has written, column by column. Empty cells are NaN.
class Columns {
 public:
  Columns() = default;
  /// Throws DataError "FILE:LINE: ..." for a file that cannot be read, or is not such a table.
  explicit Columns(const std::filesystem::path& file);

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] bool empty() const { return rows_ == 0; }
  [[nodiscard]] bool has(std::string_view name) const {
    return columns_.find(name) != columns_.end();
  }
  /// All rows of a column. Throws DataError naming the file if there is none.
  [[nodiscard]] const std::vector<double>& operator[](std::string_view name) const;

 private:
  std::filesystem::path file_;
  std::size_t rows_ = 0;
  std::map<std::string, std::vector<double>, std::less<>> columns_;
};

}  // namespace packbed::report
