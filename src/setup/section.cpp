// SPDX-License-Identifier: BSD-3-Clause
#include "setup/section.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"

namespace packbed::setup {
namespace {

// A value as a user would write it.
std::string as_text(const toml::node& node) {
  if (const auto* text = node.as_string()) return toml_string(text->get());
  if (const auto* number = node.as_floating_point()) return shortest(number->get());
  std::ostringstream stream;
  std::vector<std::string> items;
  if (const auto* array = node.as_array()) {
    for (const auto& item : *array) items.push_back(as_text(item));
    return fmt::format("[{}]", fmt::join(items, ", "));
  }
  if (const auto* table = node.as_table()) {
    for (const auto& [key, item] : *table) {
      items.push_back(fmt::format("{} = {}", std::string(key.str()), as_text(item)));
    }
    return fmt::format("{{ {} }}", fmt::join(items, ", "));
  }
  node.visit([&](const auto& value) { stream << value; });
  return stream.str();
}

}  // namespace

Section::Section(Reading& reading, const toml::table& table, std::string name, std::string header)
    : reading_(&reading), table_(&table), name_(std::move(name)), header_(std::move(header)) {}

// Made with its first key, so that tables stand in the order in which they were read.
EchoTable& Section::echo() {
  if (!echo_) {
    echo_ = reading_->echo.size();
    reading_->echo.push_back({header_, {}});
  }
  return reading_->echo[*echo_];
}

// --- messages

std::string Section::place(const toml::node* node) const {
  const auto line = node == nullptr ? 0U : node->source().begin.line;
  if (line == 0) return reading_->file.string();
  return fmt::format("{}:{}", reading_->file.string(), line);
}

std::string Section::full(std::string_view key) const {
  return name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key);
}

void Section::fail(std::string_view key, std::string_view message) const {
  const auto* node = table_->get(key);
  if (node == nullptr) fail_missing(key, message);
  throw ConfigError(fmt::format("{}: {} = {} {}", place(node), full(key), as_text(*node), message));
}

void Section::fail_missing(std::string_view key, std::string_view message) const {
  // A key that was never asked for and looks like this one is a slip of the pen.
  for (const auto& [found, node] : *table_) {
    const std::string name(found.str());
    const std::array<std::string, 1> wanted = {std::string(key)};
    if (std::ranges::find(known_, name) == known_.end() && nearest(name, wanted)) {
      throw ConfigError(fmt::format("{}: {} is not a known key, did you mean \"{}\"?", place(&node),
                                    full(name), key));
    }
  }
  const bool is_there = name_.empty() || table_->source().begin.line > 0;
  throw ConfigError(fmt::format("{}: {} {}{}", place(table_), full(key), message,
                                is_there ? "" : fmt::format(" (there is no {})", header_)));
}

void Section::mention(std::string_view key) {
  if (std::ranges::find(known_, key) == known_.end()) known_.emplace_back(key);
}

void Section::mention(std::initializer_list<std::string_view> keys) {
  for (const auto key : keys) mention(key);
}

void Section::fail_here(std::string_view message) const {
  throw ConfigError(fmt::format("{}: {} {}", place(table_), header_, message));
}

void Section::refuse(std::string_view key, std::string_view why) {
  if (has(key)) fail(key, why);
}

void Section::finish() const {
  for (const auto& [key, node] : *table_) {
    const std::string found(key.str());
    if (std::ranges::find(known_, found) != known_.end()) continue;
    const auto near = nearest(found, known_);
    throw ConfigError(
        fmt::format("{}: {} is not a known key{}; known {}: {}", place(&node), full(found),
                    near ? fmt::format(", did you mean \"{}\"?", *near) : "",
                    name_.empty() ? "at the top are" : fmt::format("in {} are", header_),
                    fmt::join(known_, ", ")));
  }
}

// --- keys and tables inside

const toml::node* Section::find(std::string_view key) {
  mention(key);
  return table_->get(key);
}

std::vector<std::string> Section::keys() const {
  std::vector<std::string> all;
  for (const auto& [key, node] : *table_) all.emplace_back(key.str());
  return all;
}

Section Section::table(std::string_view key) {
  static const toml::table empty;
  const auto* node = find(key);
  if (node != nullptr && !node->is_table()) fail(key, "is refused; it must be a table");
  const auto name = full(key);
  return {*reading_, node == nullptr ? empty : *node->as_table(), name, fmt::format("[{}]", name)};
}

std::vector<Section> Section::tables(std::string_view key) {
  std::vector<Section> all;
  const auto* node = find(key);
  if (node == nullptr) return all;
  const auto* array = node->as_array();
  const auto header = fmt::format(
      "[[{}{}]]", header_.starts_with("[[") ? header_.substr(2, header_.size() - 4) + "." : "",
      key);
  if (array == nullptr || !array->is_homogeneous<toml::table>()) {
    fail(key, fmt::format("is refused; write {} above each of its tables", header));
  }
  // Names count from 1, so that a message points at the third step as protocol[3].
  for (std::size_t i = 0; i < array->size(); ++i) {
    all.emplace_back(*reading_, *array->get(i)->as_table(), fmt::format("{}[{}]", full(key), i + 1),
                     header);
  }
  return all;
}

}  // namespace packbed::setup
