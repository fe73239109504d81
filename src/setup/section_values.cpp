// SPDX-License-Identifier: BSD-3-Clause
// Values of a table, key by key; section.cpp has the table itself and the messages.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "setup/section.hpp"

namespace packbed::setup {
namespace {

struct Expected {
  std::string_view name;
  std::string_view example;
};

// What to ask for: the dimension's own example suits beads, not columns and moduli.
Expected expected(std::string_view key, Dimension dimension) {
  const auto has = [&](std::string_view part) { return key.find(part) != std::string_view::npos; };
  if (dimension == Dimension::pressure && has("modulus")) return {"modulus", "30 MPa"};
  const bool of_column = has("height") || has("inner") || has("depth") || has("size");
  if (dimension == Dimension::length && of_column) return {"length", "9.6 mm"};
  return {info(dimension).name, info(dimension).example};
}

std::string list_text(const std::vector<std::string>& items) {
  return fmt::format("[{}]", fmt::join(items, ", "));
}

}  // namespace

std::string such_as(std::string_view key, Dimension dimension) {
  const auto [name, example] = expected(key, dimension);
  return fmt::format("give a {} such as \"{}\"", name, example);
}

void Section::note(EchoEntry entry, bool given, const std::optional<Fallback>& fallback) {
  if (!given && fallback) entry.origin = fallback->origin;
  echo().entries.push_back(std::move(entry));
}

void Section::note_word(std::string_view key,
                        const std::string& word,
                        bool given,
                        const std::optional<Fallback>& fallback) {
  note({.key = std::string(key), .toml = toml_string(word), .words = {word}}, given, fallback);
}

double Section::convert(std::string_view key,
                        const std::string& text,
                        Dimension dimension,
                        const Bounds& bounds) const {
  double value = 0.0;
  try {
    value = reading_->units.to_si(text, dimension);
  } catch (const ValueError& error) {
    fail(key, fmt::format("is refused: {}; {}", error.what(), such_as(key, dimension)));
  }
  if (!bounds.contains(value)) fail(key, bounds.refusal);
  return value;
}

std::optional<std::string> Section::quantity_text(std::string_view key,
                                                  Dimension dimension,
                                                  const std::optional<Fallback>& fallback) {
  const auto* node = find(key);
  if (node == nullptr) {
    if (fallback) return fallback->text;
    return std::nullopt;
  }
  if (const auto* text = node->as_string()) return text->get();
  const bool is_number = node->is_number();
  if (is_number && dimension == Dimension::fraction) {
    const double value = *node->value<double>();
    if (!std::isfinite(value)) fail(key, "is not a finite number");
    return shortest(value);
  }
  if (is_number) {
    fail(key, fmt::format("has no unit; {}", such_as(key, dimension)));
  }
  fail(key, fmt::format("is not a quantity; {}", such_as(key, dimension)));
}

double Section::quantity(std::string_view key,
                         Dimension dimension,
                         const Bounds& bounds,
                         const std::optional<Fallback>& fallback) {
  const bool given = has(key);
  const auto text = quantity_text(key, dimension, fallback);
  if (!text) fail_missing(key, fmt::format("is missing; {}", such_as(key, dimension)));
  const double value = convert(key, *text, dimension, bounds);
  last_text_ = *text;
  const bool bare = dimension == Dimension::fraction && to_number(*text).has_value();
  note({.key = std::string(key),
        .toml = bare ? *text : toml_string(*text),
        .si = {value},
        .dimension = dimension},
       given, fallback);
  return value;
}

std::optional<double> Section::optional_quantity(std::string_view key,
                                                 Dimension dimension,
                                                 const Bounds& bounds) {
  if (has(key)) return quantity(key, dimension, bounds);
  mention(key);
  return std::nullopt;
}

std::array<double, 3> Section::three_quantities(std::string_view key,
                                                Dimension dimension,
                                                const Bounds& bounds) {
  const auto [name, example] = expected(key, dimension);
  const auto wanted =
      fmt::format("give three {0}s such as [\"{1}\", \"{1}\", \"{1}\"]", name, example);
  const auto* node = find(key);
  if (node == nullptr) fail_missing(key, fmt::format("is missing; {}", wanted));
  const auto* array = node->as_array();
  if (array == nullptr || array->size() != 3) fail(key, fmt::format("is refused; {}", wanted));
  std::array<double, 3> values{};
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto* text = array->get(i)->as_string();
    if (text == nullptr) fail(key, fmt::format("is refused; {}", wanted));
    values[i] = convert(key, text->get(), dimension, bounds);
    texts.push_back(toml_string(text->get()));
  }
  note({.key = std::string(key),
        .toml = list_text(texts),
        .si = {values.begin(), values.end()},
        .dimension = dimension,
        .is_list = true},
       true, {});
  return values;
}

std::optional<double> Section::quantity_or_word(std::string_view key,
                                                Dimension dimension,
                                                const Bounds& bounds,
                                                std::string_view word,
                                                const Fallback& fallback) {
  const bool given = has(key);
  const auto* node = table_->get(key);
  const bool is_word =
      given ? node->is_string() && node->as_string()->get() == word : fallback.text == word;
  if (!is_word) return quantity(key, dimension, bounds, fallback);
  find(key);
  note_word(key, std::string(word), given, fallback);
  return std::nullopt;
}

double to_velocity(const std::string& text, double area, const Reading& reading) {
  const auto quantity = split_quantity(text);
  if (quantity.unit == "RHL") {
    if (!reading.full_load) {
      throw ValueError(
          "a relative hydrodynamic load needs column.full_load, or a step \"flow_pack\" whose "
          "flow is 1 RHL");
    }
    return quantity.number * *reading.full_load;
  }
  const auto& units = reading.units;
  if (units.dimension_of(text, Dimension::velocity) == Dimension::volume_flow) {
    return units.to_si(text, Dimension::volume_flow) / area;
  }
  return units.to_si(text, Dimension::velocity);
}

double Section::flow(std::string_view key, double area, const std::optional<Fallback>& fallback) {
  const bool given = has(key);
  const auto text = quantity_text(key, Dimension::velocity, fallback);
  const auto wanted =
      "give a superficial velocity such as \"300 cm/h\" or a flow rate such as "
      "\"2 L/h\"";
  if (!text) fail_missing(key, fmt::format("is missing; {}", wanted));
  double value = 0.0;
  try {
    value = to_velocity(*text, area, *reading_);
  } catch (const ValueError& error) {
    fail(key, fmt::format("is refused: {}; {}", error.what(), wanted));
  }
  note({.key = std::string(key),
        .toml = toml_string(*text),
        .si = {value},
        .dimension = Dimension::velocity},
       given, fallback);
  return value;
}

std::optional<double> Section::optional_flow(std::string_view key, double area) {
  if (has(key)) return flow(key, area);
  mention(key);
  return std::nullopt;
}

std::optional<std::int64_t> Section::optional_integer(std::string_view key, std::int64_t low) {
  if (has(key)) return integer(key, low);
  mention(key);
  return std::nullopt;
}

std::int64_t Section::integer(std::string_view key,
                              std::int64_t low,
                              const std::optional<Fallback>& fallback) {
  const auto* node = find(key);
  if (node == nullptr) {
    if (!fallback) fail_missing(key, "is missing; give a whole number");
    const double value = *to_number(fallback->text);
    note({.key = std::string(key), .toml = fallback->text, .si = {value}}, false, fallback);
    return static_cast<std::int64_t>(value);
  }
  if (!node->is_integer()) fail(key, "is not a whole number");
  const auto value = node->as_integer()->get();
  if (value < low) fail(key, fmt::format("must be at least {}", low));
  note({.key = std::string(key),
        .toml = fmt::format("{}", value),
        .si = {static_cast<double>(value)}},
       true, fallback);
  return value;
}

bool Section::boolean(std::string_view key, bool fallback) {
  const auto* node = find(key);
  if (node != nullptr && !node->is_boolean()) fail(key, "is refused; give true or false");
  const bool value = node == nullptr ? fallback : node->as_boolean()->get();
  note({.key = std::string(key), .toml = value ? "true" : "false"}, node != nullptr, Fallback{""});
  return value;
}

std::optional<std::string> Section::optional_word(std::string_view key) {
  const auto* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_string()) fail(key, "is refused; give a text in quotes");
  if (trimmed(node->as_string()->get()).empty()) fail(key, "is empty");
  note_word(key, node->as_string()->get(), true, {});
  return node->as_string()->get();
}

std::string Section::word(std::string_view key, const std::optional<Fallback>& fallback) {
  if (auto given = optional_word(key)) return *given;
  if (!fallback) fail_missing(key, "is missing; give a text in quotes");
  note_word(key, fallback->text, false, fallback);
  return fallback->text;
}

std::vector<std::string> Section::words(std::string_view key) {
  std::vector<std::string> all;
  const auto* node = find(key);
  if (node == nullptr) return all;
  const auto* array = node->as_array();
  if (array == nullptr || !array->is_homogeneous<std::string>()) {
    fail(key, "is refused; give a list of texts such as [\"a\", \"b\"]");
  }
  std::vector<std::string> quoted;
  for (const auto& item : *array) {
    all.push_back(item.as_string()->get());
    quoted.push_back(toml_string(all.back()));
  }
  note({.key = std::string(key), .toml = list_text(quoted), .words = all, .is_list = true}, true,
       {});
  return all;
}

std::size_t Section::choice(std::string_view key,
                            std::initializer_list<std::string_view> names,
                            const std::optional<Fallback>& fallback) {
  std::vector<std::string> quoted;
  for (const auto name : names) quoted.push_back(fmt::format("\"{}\"", name));
  const auto wanted = fmt::format("give {}", either_of(quoted));
  if (!has(key) && !fallback) fail_missing(key, fmt::format("is missing; {}", wanted));
  if (has(key) && !table_->get(key)->is_string()) {
    fail(key, fmt::format("is refused; {}", wanted));
  }
  const auto text = word(key, fallback);
  const auto* const found = std::ranges::find(names, text);
  if (found == names.end()) fail(key, fmt::format("is not known; {}", wanted));
  return static_cast<std::size_t>(found - names.begin());
}

std::optional<std::filesystem::path> Section::path_at(std::string_view key) {
  const auto* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_string()) fail(key, "is refused; give its name in quotes");
  return (reading_->file.parent_path() / node->as_string()->get()).lexically_normal();
}

std::optional<std::filesystem::path> Section::optional_file(std::string_view key) {
  const auto path = path_at(key);
  if (!path) return std::nullopt;
  if (!std::filesystem::is_regular_file(*path)) {
    fail(key, fmt::format("is refused: there is no file {}; names are taken from the folder of the "
                          "case file",
                          path->string()));
  }
  note_word(key, std::filesystem::absolute(*path).string(), true, {});
  return path;
}

std::optional<std::filesystem::path> Section::optional_run(std::string_view key) {
  const auto path = path_at(key);
  if (!path) return std::nullopt;
  if (!std::filesystem::is_regular_file(*path / "summary.json")) {
    fail(key, fmt::format("is refused: {} is not the folder of a run that has ended (it has no "
                          "summary.json); names are taken from the folder of the case file",
                          path->string()));
  }
  note_word(key, std::filesystem::absolute(*path).string(), true, {});
  return path;
}

}  // namespace packbed::setup
