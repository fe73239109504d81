// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Checkpoints: one file with everything that a run needs to go on. This is the container: named
/// arrays, numbers and texts, whatever they mean, all or nothing, with a checksum over every byte
/// (docs/decisions/0006-checkpoints.md; the layout: docs/manual/output-files.md).
///
/// Both classes are used by all ranks together: every member that says "collective" is called by all
/// of them in the same order. If it fails on one rank, all of them throw the same DataError.

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/ranks.hpp"
#include "core/vec3.hpp"
#include "io/checkpoint_files.hpp"
#include "io/hdf5.hpp"

namespace packbed::io {

/// Raise it whenever what a checkpoint holds, or what it means, changes. Other formats are refused.
inline constexpr int checkpoint_format = 4;

/// Writes a checkpoint under a temporary name; commit() gives it its own. Without commit() the folder
/// is as before. The same content on the same number of ranks gives the same bytes.
class CheckpointWriter {
 public:
  /// Collective. Makes the folder if needed and removes what a killed run left half written in it.
  /// Throws DataError if nothing can be written there.
  CheckpointWriter(const std::filesystem::path& folder, std::int64_t number, const Ranks& ranks);
  ~CheckpointWriter();
  CheckpointWriter(const CheckpointWriter&) = delete;
  CheckpointWriter& operator=(const CheckpointWriter&) = delete;
  CheckpointWriter(CheckpointWriter&&) = delete;
  CheckpointWriter& operator=(CheckpointWriter&&) = delete;

  /// Collective: this rank's rows, `width` values each. The file has the rows of all ranks, rank by
  /// rank. The number of rows may differ between ranks and be 0. A name may have folders: "dem/mass".
  /// Throws DataError if the disk is full.
  void array(const std::string& name, std::span<const double> values, std::size_t width = 1);
  void array(const std::string& name, std::span<const std::int64_t> values, std::size_t width = 1);
  void array(const std::string& name, std::span<const std::int32_t> values, std::size_t width = 1);
  void array(const std::string& name, std::span<const std::int8_t> values, std::size_t width = 1);
  void array(const std::string& name, std::span<const std::uint8_t> values, std::size_t width = 1);
  /// The same as three doubles a row.
  void array(const std::string& name, std::span<const Vec3> values);

  /// Collective. Rank 0's value counts.
  void number(const std::string& name, double value);
  void integer(const std::string& name, std::int64_t value);
  /// Text without null characters, JSON say.
  void text(const std::string& name, std::string_view value);

  /// Collective, once, last: checksum, to disk, and renamed. Returns the name.
  std::filesystem::path commit();

 private:
  void array_of(const std::string& name, hdf5::ArrayForm mine, const void* values);
  template <class Act>
  void together(Act act);

  std::filesystem::path file_;
  std::filesystem::path part_;
  Ranks ranks_;
  hdf5::Object content_;
  std::uint64_t taken_;  ///< disk space that is ours [bytes]
  bool is_committed_ = false;
  bool may_close_;  ///< whether all ranks are known to stand at the same place
};

/// Reads a checkpoint that is whole: the constructor has checked every byte.
class CheckpointReader {
 public:
  /// Collective. Throws DataError if the file is missing, no checkpoint, truncated, altered or of
  /// another format.
  CheckpointReader(const std::filesystem::path& file, const Ranks& ranks);

  // All below: by each rank for itself. DataError if the name is not there or is of another type.

  [[nodiscard]] bool has_array(const std::string& name) const;
  [[nodiscard]] bool has_number(const std::string& name) const;
  [[nodiscard]] std::int64_t rows(const std::string& name) const;
  [[nodiscard]] std::size_t width(const std::string& name) const;
  [[nodiscard]] std::vector<std::string> arrays() const;  ///< their names, sorted

  /// Rows first to first + count - 1 of all ranks' rows, `width` values each. T is the type that was
  /// written: double, Vec3, std::int64_t, std::int32_t, std::int8_t or std::uint8_t.
  template <class T>
  [[nodiscard]] std::vector<T> read(const std::string& name,
                                    std::int64_t first,
                                    std::int64_t count) const;
  /// All rows.
  template <class T>
  [[nodiscard]] std::vector<T> read(const std::string& name) const {
    return read<T>(name, 0, rows(name));
  }
  /// All rows, `chunk` of them at a time: visit(first row, their values).
  template <class T>
  void for_each_chunk(const std::string& name,
                      std::int64_t chunk,
                      const std::function<void(std::int64_t, std::span<const T>)>& visit) const {
    const auto all = rows(name);
    for (std::int64_t first = 0; first < all; first += chunk) {
      const auto values = read<T>(name, first, std::min(chunk, all - first));
      visit(first, values);
    }
  }

  [[nodiscard]] double number(const std::string& name) const;
  [[nodiscard]] std::int64_t integer(const std::string& name) const;
  [[nodiscard]] std::string text(const std::string& name) const;

 private:
  std::filesystem::path file_;
  hdf5::Object content_;
};

}  // namespace packbed::io
