// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/library.hpp"
#include "app/print.hpp"
#include "setup/resin_file.hpp"

namespace packbed::app {
namespace {

using Json = nlohmann::ordered_json;

std::string with_spread(const resin::Property& p) {
  return p.spread_text.empty() ? p.text : fmt::format("{} +- {}", p.text, p.spread_text);
}

std::string source_text(const std::string& source,
                        const std::string& where,
                        const std::string& note) {
  return fmt::format("{}{}{}", source, where.empty() ? "" : ", " + where,
                     note.empty() ? "" : " (" + note + ")");
}

void print_list(const resin::Library& library) {
  fmt::print("{:<42} {:<40} {:>10} {:>12} {:>12}\n", "resin", "matrix", "mean", "E relaxed",
             "E linear");
  for (const auto& resin : library.resins) {
    const auto cell = [&](std::string_view key, std::string_view other = "") {
      const auto* p = resin.find(key);
      if (p == nullptr && !other.empty()) p = resin.find(other);
      return p == nullptr ? std::string("-") : p->text;
    };
    fmt::print("{:<42} {:<40} {:>10} {:>12} {:>12}\n", resin.name, resin.matrix,
               cell("diameter_mean", "vendor_diameter_mean"), cell("youngs_modulus_relaxed"),
               cell("youngs_modulus_linear"));
  }
  fmt::print("\n`packbed resins NAME` shows every value with its source; - is not known.\n");
}

void print_resin(const resin::Resin& resin, const resin::Library& library) {
  fmt::print("{}\n", resin.name);
  if (!resin.aliases.empty()) fmt::print("  also        {}\n", fmt::join(resin.aliases, ", "));
  if (!resin.matrix.empty()) fmt::print("  matrix      {}\n", resin.matrix);
  if (!resin.manufacturer.empty()) fmt::print("  maker       {}\n", resin.manufacturer);
  if (!resin.note.empty()) fmt::print("  note        {}\n", resin.note);
  fmt::print("\n");
  std::vector<std::string> used;
  for (const auto& p : resin.properties) {
    fmt::print("  {:<28} {:<26} {}\n", p.key, with_spread(p),
               source_text(p.source, p.where, p.note));
    used.push_back(p.source);
  }
  if (!resin.moduli.empty()) fmt::print("\n  Moduli measured on single beads\n");
  for (const auto& m : resin.moduli) {
    fmt::print("  {:<28} {}\n", m.method, source_text(m.source, m.where, m.note));
    for (const auto& p : m.values) fmt::print("    {:<26} {}\n", p.key, with_spread(p));
    used.push_back(m.source);
  }
  fmt::print("\n  Sources\n");
  for (const auto& source : library.sources) {
    if (std::ranges::find(used, source.name) == used.end()) continue;
    fmt::print("  {:<28} {}\n", source.name, source.citation);
  }
}

void add_value(Json& j, const resin::Property& p) {
  const auto key = p.suffix.empty() ? p.key : fmt::format("{}_{}", p.key, p.suffix);
  j[key] = p.si;
  if (p.spread)
    j[fmt::format("{}_spread{}{}", p.key, p.suffix.empty() ? "" : "_", p.suffix)] = *p.spread;
}

Json resin_json(const resin::Resin& resin) {
  Json j{{"name", resin.name},
         {"aliases", resin.aliases},
         {"matrix", resin.matrix},
         {"manufacturer", resin.manufacturer},
         {"note", resin.note}};
  j["properties"] = Json::object();
  j["sources"] = Json::object();
  for (const auto& p : resin.properties) {
    add_value(j["properties"], p);
    j["sources"][p.key] = source_text(p.source, p.where, p.note);
  }
  j["moduli"] = Json::array();
  for (const auto& m : resin.moduli) {
    Json row{{"method", m.method}, {"source", source_text(m.source, m.where, m.note)}};
    for (const auto& p : m.values) add_value(row, p);
    j["moduli"].push_back(row);
  }
  return j;
}

}  // namespace

int resins(const ResinsCommand& command) {
  const UnitSystem units;
  auto library = setup::builtin_library(units);
  if (!command.library.empty()) library.add(setup::read_library(command.library, units));
  if (command.name.empty()) {
    if (!command.json) {
      print_list(library);
      return 0;
    }
    Json all = Json::array();
    for (const auto& resin : library.resins) all.push_back(resin_json(resin));
    fmt::print("{}", json_text(all));
    return 0;
  }
  const auto& resin = find_resin(library, command.name);
  if (command.json) {
    fmt::print("{}", json_text(resin_json(resin)));
  } else {
    print_resin(resin, library);
  }
  return 0;
}

}  // namespace packbed::app
