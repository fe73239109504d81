// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include <toml++/toml.h>

namespace packbed::setup {

/// Parses TOML text. Throws ConfigError "FILE:LINE: ..." for what is not TOML, duplicates included.
toml::table parse_toml(std::string_view text, const std::filesystem::path& file);

}  // namespace packbed::setup
