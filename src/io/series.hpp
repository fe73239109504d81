// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Tables that grow while a run is under way: one row per output, units in the header.
///
/// What a killed run leaves: a row is written at once with its line end, and given to the operating
/// system before row() returns. So a killed program leaves whole rows, and perhaps the beginning of
/// one more. A checkpoint notes bytes() after sync(); resume() cuts the file there, so that no row
/// is doubled or lost, whatever was written after the checkpoint. A row that does not fit on the disk
/// is taken away again: the file ends with a whole row.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <variant>
#include <vector>

namespace packbed::io {

using Cell = std::variant<double, std::int64_t, std::string>;

class SeriesWriter {
 public:
  /// A new file with these columns. Throws DataError if it cannot be written, here and at any row.
  SeriesWriter(const std::filesystem::path& file, const std::vector<std::string>& columns);

  /// Goes on with a file after its first `bytes` bytes; what stands behind them is cut off.
  /// Throws DataError if the file is missing or shorter, has other columns, or if no row ends there.
  static SeriesWriter resume(const std::filesystem::path& file,
                             const std::vector<std::string>& columns,
                             std::int64_t bytes);

  /// One value per column, doubles in full precision.
  void row(const std::vector<Cell>& cells);

  /// Length of the file so far, header included.
  [[nodiscard]] std::int64_t bytes() const { return bytes_; }
  /// Waits until all rows are on disk, safe from a power failure.
  void sync() const;

 private:
  SeriesWriter(std::filesystem::path file, std::size_t columns, std::int64_t bytes);
  void append(const std::string& line);

  std::filesystem::path file_;
  std::ofstream stream_;
  std::size_t columns_;
  std::int64_t bytes_ = 0;
};

}  // namespace packbed::io
