// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Texts of users in a page. Nothing of them becomes a tag, an attribute or a script.

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace packbed::report {

/// `text` with U+FFFD in place of bytes that are not UTF-8: names of files may have them.
std::string valid_utf8(std::string_view text);

/// `text` for the content of an element or a quoted attribute, valid UTF-8.
std::string escaped(std::string_view text);

/// JSON for a script element: no "<" in it, so that nothing in a text ends the element.
std::string script_json(const nlohmann::ordered_json& json);

}  // namespace packbed::report
