// SPDX-License-Identifier: BSD-3-Clause
#include "setup/parse_toml.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"

namespace packbed::setup {
namespace {

// What the TOML parser found, in words for those who never met it.
std::string plain(const std::string& description) {
  if (description.find("control characters") != std::string::npos) {
    return "a text is not closed by a quote in its line";
  }
  if (description.find("cannot redefine existing") != std::string::npos) {
    return fmt::format("{} is given twice", description.substr(description.find('\'')));
  }
  return "not TOML: " + description;
}

// Line of a text, counted from 1.
std::string_view line_of(std::string_view text, std::size_t number) {
  for (; number > 1; --number) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return trimmed(text.substr(0, text.find('\n')));
}

}  // namespace

toml::table parse_toml(std::string_view text, const std::filesystem::path& file) {
  try {
    return toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    const auto line = error.source().begin.line;
    throw ConfigError(fmt::format("{}:{}: {}; the line is: {}", file.string(), line,
                                  plain(std::string(error.description())), line_of(text, line)));
  }
}

}  // namespace packbed::setup
