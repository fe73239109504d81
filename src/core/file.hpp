// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Whole files in and out, with messages that say why it failed.

#include <filesystem>
#include <string>
#include <string_view>

namespace packbed {

/// The whole file without a byte order mark. Throws DataError saying why it cannot be read.
std::string read_text_file(const std::filesystem::path& file);

/// Writes under a temporary name and renames, so that no half file is ever found.
/// Throws DataError saying why it cannot be written.
void write_text_file(const std::filesystem::path& file, std::string_view text);

}  // namespace packbed
