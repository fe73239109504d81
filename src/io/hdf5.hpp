// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// As much of HDF5 as our files need: objects that close themselves, and a DataError that names the
/// file, what was being done and why it failed, for every call that fails. HDF5 itself prints nothing.
/// No header of HDF5 is included, so that what uses our files need not know it.
///
/// Files hold no times, and numbers in little-endian form, so equal content gives equal bytes.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/ranks.hpp"

namespace packbed::io::hdf5 {

/// Types of numbers, in memory and in files.
enum class Element : std::uint8_t { float64, float32, int64, int32, int8, uint8 };

template <class T>
constexpr Element element_of();
template <>
constexpr Element element_of<double>() {
  return Element::float64;
}
template <>
constexpr Element element_of<std::int64_t>() {
  return Element::int64;
}
template <>
constexpr Element element_of<std::int32_t>() {
  return Element::int32;
}
template <>
constexpr Element element_of<std::int8_t>() {
  return Element::int8;
}
template <>
constexpr Element element_of<std::uint8_t>() {
  return Element::uint8;
}
std::size_t bytes_of(Element element);
std::string name_of(Element element);  ///< "float64", ...

/// An array in a file: rows of `width` numbers. In the file it has one dimension if width is 1.
struct ArrayForm {
  Element element = Element::float64;
  std::int64_t rows = 0;
  std::size_t width = 1;
  int deflate = 0;  ///< zlib level, 0 (none) to 9
};

/// An open file, group or array.
class Object {
 public:
  ~Object();
  Object(Object&& other) noexcept;
  Object& operator=(Object&& other) noexcept;
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;

  /// Closes now, and throws if that fails, as the destructor cannot.
  void close();
  /// Leaves it open for ever: for ranks that cannot close together any more.
  void abandon() noexcept { id_ = -1; }

  [[nodiscard]] Object create_group(const std::string& name) const;
  [[nodiscard]] Object open_group(const std::string& name) const;
  /// Space in the file is taken at once. Groups in the name are made.
  [[nodiscard]] Object create_array(const std::string& name, const ArrayForm& form) const;
  [[nodiscard]] Object open_array(const std::string& name) const;
  [[nodiscard]] bool has(const std::string& name) const;
  /// Names of all arrays below, sorted.
  [[nodiscard]] std::vector<std::string> arrays() const;

  // Of an array:

  [[nodiscard]] ArrayForm form() const;
  /// Rows from `first` on, of which there are `values.rows`. values.element is that of the memory.
  /// Collective: all ranks write at once, each its rows.
  void write_rows(std::int64_t first,
                  const ArrayForm& values,
                  const void* data,
                  bool is_collective = false) const;
  void read_rows(std::int64_t first, const ArrayForm& values, void* data) const;

  // Small things:

  void write_attribute(const std::string& name, double value) const;
  void write_attribute(const std::string& name, std::span<const std::int64_t> values) const;
  void write_attribute(const std::string& name, std::string_view ascii) const;
  [[nodiscard]] bool has_number(const std::string& name) const;
  [[nodiscard]] double read_number(const std::string& name) const;
  [[nodiscard]] std::int64_t read_integer(const std::string& name) const;
  /// A text as a value of its own. All ranks make it, those with `writes` fill it.
  void write_text(const std::string& name, std::string_view value, bool writes) const;
  [[nodiscard]] std::string read_text(const std::string& name) const;

  // Of a file:

  void flush() const;
  [[nodiscard]] std::uint64_t end() const;  ///< its length once it is closed; not through MPI-IO
  /// A file in memory, as it would be on disk.
  [[nodiscard]] std::vector<std::byte> image() const;

 private:
  friend Object create_file(const std::filesystem::path&, std::size_t, const Ranks&);
  friend Object create_in_memory(const std::filesystem::path&);
  friend Object open_file(const std::filesystem::path&);
  Object(std::int64_t id, std::filesystem::path file, std::string name);
  [[nodiscard]] std::string label(const std::string& name) const;

  std::int64_t id_;
  std::filesystem::path file_;  ///< for messages
  std::string name_;            ///< within the file, for messages
};

/// A new file with `user_block` bytes in front (0, or a power of 2 from 512 on) that HDF5 leaves
/// alone. On several ranks: opened by all of them through MPI-IO; every change of the structure is
/// then made by all ranks together.
Object create_file(const std::filesystem::path& file, std::size_t user_block, const Ranks& ranks);
/// A new file in memory; `file` is for messages.
Object create_in_memory(const std::filesystem::path& file);
/// For reading, by this process alone.
Object open_file(const std::filesystem::path& file);

}  // namespace packbed::io::hdf5
