// SPDX-License-Identifier: BSD-3-Clause
#include "report/html.hpp"

namespace packbed::report {

using Json = nlohmann::ordered_json;

std::string valid_utf8(std::string_view text) {
  const auto dumped = Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
  return Json::parse(dumped).get<std::string>();
}

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : valid_utf8(text)) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      case '\'':
        html += "&#39;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string script_json(const Json& json) {
  std::string script;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    // Only texts have these letters, and in JSON a text may spell any letter so.
    switch (c) {
      case '<':
        script += "\\u003c";
        break;
      case '>':
        script += "\\u003e";
        break;
      case '&':
        script += "\\u0026";
        break;
      default:
        script += c;
    }
  }
  return script;
}

}  // namespace packbed::report
