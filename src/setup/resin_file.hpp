// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Reads resin libraries: the one that the program comes with, and users' own.
/// Keys and form: docs/manual/resins.md.

#include <filesystem>
#include <span>
#include <string_view>

#include "core/quantity.hpp"
#include "resin/resin.hpp"
#include "setup/section.hpp"

namespace packbed::setup {

/// What a key of a resin means.
struct ResinKey {
  std::string_view key;
  Dimension dimension;
  Bounds bounds;
  std::string_view meaning;
};

/// All keys that a resin may have, in the order in which they are shown.
std::span<const ResinKey> resin_keys();

/// The library that was built in (resins/library.toml).
resin::Library builtin_library(const UnitSystem& units);

/// Throws DataError if the file cannot be read, ConfigError "FILE:LINE: ..." for a mistake in it.
resin::Library read_library(const std::filesystem::path& file, const UnitSystem& units);

}  // namespace packbed::setup
