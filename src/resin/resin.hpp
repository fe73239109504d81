// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The resin library: what is known of each resin, every value with its source.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace packbed::resin {

/// One value of a resin. `key` and its unit are listed in docs/manual/resins.md.
struct Property {
  std::string key;
  std::string text;              ///< as the library writes it: "1.14 g/cm3"
  double si = 0.0;               ///< in SI
  std::string si_unit;           ///< "kg/m3"; empty for pure numbers
  std::string suffix;            ///< of a JSON key: "kg_m3"; empty for pure numbers
  std::optional<double> spread;  ///< standard deviation, in SI
  std::string spread_text;
  std::string source;  ///< short name of a Source
  std::string where;   ///< table or section of the source
  std::string note;
};

/// Moduli from one experiment on single beads; its numbers depend on how it was done.
struct ModulusMeasurement {
  std::string method;
  std::vector<Property> values;
  std::string source;
  std::string where;
  std::string note;
};

struct Resin {
  std::string name;
  std::vector<std::string> aliases;
  std::string matrix;
  std::string manufacturer;
  std::string note;
  std::vector<Property> properties;
  std::vector<ModulusMeasurement> moduli;

  /// Null if the library does not know the value.
  [[nodiscard]] const Property* find(std::string_view key) const;
};

struct Source {
  std::string name;  ///< short: "thesis"
  std::string citation;
};

struct Library {
  std::vector<Source> sources;
  std::vector<Resin> resins;

  /// By name or alias, upper and lower case alike. Null if there is none.
  [[nodiscard]] const Resin* find(std::string_view name) const;
  /// Names and aliases, for messages.
  [[nodiscard]] std::vector<std::string> names() const;
  /// Adds the resins and sources of another library; they replace ours of the same name, and their
  /// names and aliases are found first.
  void add(Library other);
};

}  // namespace packbed::resin
