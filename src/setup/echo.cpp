// SPDX-License-Identifier: BSD-3-Clause
#include "setup/echo.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "core/text.hpp"

namespace packbed::setup {
namespace {

std::string comment(const EchoEntry& entry) {
  std::string text;
  if (entry.dimension && *entry.dimension != Dimension::fraction) {
    for (const double value : entry.si) {
      text += fmt::format("{}{}", text.empty() ? "" : ", ", shortest(value));
    }
    text += fmt::format(" {}", info(*entry.dimension).si_unit);
  }
  if (!entry.origin.empty()) text += (text.empty() ? "" : "; ") + entry.origin;
  return text;
}

}  // namespace

std::string toml_string(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += fmt::format("\\{}", c);
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      quoted += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

std::vector<FlatValue> flat_values(const Echo& echo) {
  std::vector<FlatValue> all;
  std::map<std::string, int> counts;  // of arrays of tables
  for (const auto& table : echo) {
    std::string name = table.header;
    std::erase_if(name, [](char c) { return c == '[' || c == ']'; });
    if (table.header.starts_with("[[")) name += fmt::format("[{}]", ++counts[name]);
    for (const auto& entry : table.entries) {
      std::string value;
      for (const double si : entry.si) value += (value.empty() ? "" : ", ") + shortest(si);
      if (entry.si.empty()) value = entry.toml;
      all.push_back({name.empty() ? entry.key : name + "." + entry.key, value});
    }
  }
  return all;
}

std::string to_toml(const Echo& echo) {
  std::string text;
  for (const auto& table : echo) {
    if (!table.header.empty())
      text += fmt::format("{}{}\n", text.empty() ? "" : "\n", table.header);
    std::vector<std::string> lines;
    std::size_t width = 0;
    for (const auto& entry : table.entries) {
      lines.push_back(fmt::format("{} = {}", entry.key, entry.toml));
      width = std::max(width, std::min<std::size_t>(lines.back().size(), 40));
    }
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const auto note = comment(table.entries[i]);
      text += note.empty() ? lines[i] + "\n" : fmt::format("{:<{}}  # {}\n", lines[i], width, note);
    }
  }
  return text;
}

}  // namespace packbed::setup
