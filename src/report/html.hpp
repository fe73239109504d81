// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Texts of users in a page. Nothing of them becomes a tag, an attribute or a script.

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace packbed::report {

/// `text` for the content of an element or a quoted attribute. Bytes that are not UTF-8 become U+FFFD.
std::string escaped(std::string_view text);

/// JSON for a script element: no "<" in it, so that nothing in a text ends the element.
std::string script_json(const nlohmann::ordered_json& json);

}  // namespace packbed::report
