// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// From the text of a case file to a Case.

#include <filesystem>
#include <string_view>

#include "core/quantity.hpp"
#include "setup/case.hpp"

namespace packbed::setup {

/// Reads and checks a case file and the files that it names. Throws DataError if a file cannot be
/// read; ConfigError, on one line with file, line, key, value and what is accepted, for the first
/// mistake.
Case read_case(const std::filesystem::path& file, const UnitSystem& units);

/// The same for a text, as if it stood in `file`.
Case read_case_text(std::string_view text,
                    const std::filesystem::path& file,
                    const UnitSystem& units);

/// The shape of the column that a case describes. Nothing else of the case is read: files that it names may be gone.
mesh::ColumnShape read_column_shape(std::string_view text,
                                    const std::filesystem::path& file,
                                    const UnitSystem& units);

}  // namespace packbed::setup
