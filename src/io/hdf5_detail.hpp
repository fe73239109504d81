// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// What the sources of hdf5.hpp share. Nobody else includes it, since it brings the headers of HDF5.

#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <hdf5.h>

#include "core/error.hpp"
#include "io/hdf5.hpp"

namespace packbed::io::hdf5::detail {

/// Why the last call of HDF5 failed.
std::string reason();

/// What every call of HDF5 returns is passed through here; negative means that it failed.
template <class Result>
Result ok(Result result, const std::filesystem::path& file, const std::string& what) {
  if (result >= 0) return result;
  throw DataError(fmt::format("{}: {} failed ({})", file.string(), what, reason()));
}

/// Closes an identifier of any kind.
void close_id(hid_t id) noexcept;

/// An identifier that lives within one function.
class Local {
 public:
  Local(hid_t id, const std::filesystem::path& file, const std::string& what)
      : id_(ok(id, file, what)) {}
  ~Local() { close_id(id_); }
  Local(const Local&) = delete;
  Local& operator=(const Local&) = delete;
  Local(Local&&) = delete;
  Local& operator=(Local&&) = delete;
  operator hid_t() const { return id_; }  // NOLINT(google-explicit-constructor): to be handed on

 private:
  hid_t id_;
};

/// A list of properties of this kind, with their defaults.
inline Local new_list(hid_t kind, const std::filesystem::path& file) {
  return {H5Pcreate(kind), file, "setting HDF5 up"};
}

hid_t memory_type(Element element);
hid_t file_type(Element element);

}  // namespace packbed::io::hdf5::detail
