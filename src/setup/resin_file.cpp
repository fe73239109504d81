// SPDX-License-Identifier: BSD-3-Clause
#include "setup/resin_file.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/file.hpp"
#include "setup/builtin_library.hpp"
#include "setup/parse_toml.hpp"

namespace packbed::setup {
namespace {

using enum Dimension;

constexpr std::array keys = {
    ResinKey{"diameter_mean", length, bounds::positive, "mean of the number, wet"},
    ResinKey{"diameter_median", length, bounds::positive, "median of the number, wet"},
    ResinKey{"diameter_standard_deviation", length, bounds::positive, "of the number"},
    ResinKey{"diameter_min", length, bounds::positive, "smallest bead"},
    ResinKey{"diameter_max", length, bounds::positive, "largest bead"},
    ResinKey{"sauter_diameter", length, bounds::positive, "d32"},
    ResinKey{"vendor_diameter_mean", length, bounds::positive, "mean, as the vendor gives it"},
    ResinKey{"vendor_diameter_min", length, bounds::positive, "lower end of the vendor's range"},
    ResinKey{"vendor_diameter_max", length, bounds::positive, "upper end of the vendor's range"},
    ResinKey{"density", density, bounds::positive, "wet bead"},
    ResinKey{"dry_density", density, bounds::positive, "dry matrix"},
    ResinKey{"intraparticle_porosity", fraction, bounds::between_0_and_1, "pores of the bead"},
    ResinKey{"youngs_modulus_relaxed", pressure, bounds::positive,
             "of the material after relaxation; used with contact = \"hertz\""},
    ResinKey{"youngs_modulus_linear", pressure, bounds::positive,
             "of the linear contact law; used with contact = \"hooke\""},
    ResinKey{"characteristic_velocity", velocity, bounds::positive,
             "that youngs_modulus_linear was fitted with"},
    ResinKey{"poisson_ratio", fraction, bounds::poisson_ratio, ""},
    ResinKey{"restitution_measured", fraction, bounds::restitution, "loading-unloading of a bead"},
    ResinKey{"restitution", fraction, bounds::restitution, "used in bead simulations"},
    ResinKey{"restitution_max", fraction, bounds::restitution, "of viscous restitution"},
    ResinKey{"critical_stokes", fraction, bounds::positive, "of viscous restitution"},
    ResinKey{"friction", fraction, bounds::not_negative, "bead on bead"},
    ResinKey{"wall_friction", fraction, bounds::not_negative, "bead on wall"},
    ResinKey{"rolling_friction", fraction, bounds::not_negative, ""},
    ResinKey{"bed_modulus", pressure, bounds::positive, "wall-support model: modulus of the bed"},
    ResinKey{"hydrodynamic_diameter", length, bounds::positive, "wall-support model"},
    ResinKey{"bed_wall_friction", fraction, bounds::not_negative, "wall-support model"},
    ResinKey{"bed_poisson_ratio", fraction, bounds::poisson_ratio, "wall-support model"},
    ResinKey{"bed_density_difference", density, bounds::positive,
             "wall-support model: bed less liquid"},
    ResinKey{"bed_calibrated_compression", fraction, bounds::between_0_and_1,
             "wall-support model: largest compression it was fitted to"},
    ResinKey{"settled_porosity", fraction, bounds::between_0_and_1, "settled by gravity"},
    ResinKey{"max_velocity", velocity, bounds::positive, "recommended upper limit"},
    ResinKey{"max_pressure", pressure, bounds::positive, "recommended upper limit"},
    ResinKey{"compression_factor", fraction, bounds::at_least_1, "settled / packed volume"},
};

constexpr std::array<std::string_view, 5> modulus_keys = {
    "instantaneous", "relaxed", "shear_instantaneous", "shear_relaxed", "fitted"};

resin::Property property(Section& section,
                         std::string_view value_key,
                         std::string_view name,
                         Dimension dimension,
                         const Bounds& bounds) {
  resin::Property p;
  p.key = name;
  p.si = section.quantity(value_key, dimension, bounds);
  p.text = section.last_text();
  if (dimension != Dimension::fraction) {
    p.si_unit = info(dimension).si_unit;
    p.suffix = info(dimension).suffix;
  }
  return p;
}

void add_spread(Section& section, std::string_view key, Dimension dimension, resin::Property& p) {
  p.spread = section.optional_quantity(key, dimension, bounds::not_negative);
  if (p.spread) p.spread_text = section.last_text();
}

resin::Property read_property(Section section, const ResinKey& key) {
  section.mention({"value", "spread", "source", "where", "note"});
  auto p = property(section, "value", key.key, key.dimension, key.bounds);
  add_spread(section, "spread", key.dimension, p);
  p.source = section.word("source");
  p.where = section.optional_word("where").value_or("");
  p.note = section.optional_word("note").value_or("");
  section.finish();
  return p;
}

resin::ModulusMeasurement read_modulus(Section section) {
  section.mention(
      {"method", "compression", "speed", "characteristic_velocity", "source", "where", "note"});
  for (const auto key : modulus_keys) {
    section.mention(key);
    section.mention(std::string(key) + "_spread");
  }
  resin::ModulusMeasurement m;
  m.method = section.word("method");
  const auto add = [&](std::string_view key, Dimension dimension) {
    if (!section.has(key)) return;
    m.values.push_back(property(section, key, key, dimension, bounds::positive));
  };
  add("compression", length);
  add("speed", velocity);
  add("characteristic_velocity", velocity);
  for (const auto key : modulus_keys) {
    const auto spread = std::string(key) + "_spread";
    if (section.has(spread) && !section.has(key)) {
      section.fail(spread, fmt::format("stands alone; give {} too", key));
    }
    add(key, pressure);
    if (section.has(key)) add_spread(section, spread, pressure, m.values.back());
  }
  m.source = section.word("source");
  m.where = section.optional_word("where").value_or("");
  m.note = section.optional_word("note").value_or("");
  section.finish();
  return m;
}

resin::Resin read_resin_entry(Section section) {
  section.mention({"name", "aliases", "matrix", "manufacturer", "note", "moduli"});
  for (const auto& key : keys) section.mention(key.key);
  resin::Resin r;
  r.name = section.word("name");
  r.aliases = section.words("aliases");
  r.matrix = section.optional_word("matrix").value_or("");
  r.manufacturer = section.optional_word("manufacturer").value_or("");
  r.note = section.optional_word("note").value_or("");
  for (const auto& key : keys) {
    if (section.has(key.key)) r.properties.push_back(read_property(section.table(key.key), key));
  }
  for (auto& modulus : section.tables("moduli")) r.moduli.push_back(read_modulus(modulus));
  section.finish();
  return r;
}

void check_sources(const resin::Library& library, const std::filesystem::path& file) {
  const auto check = [&](const resin::Resin& resin, const std::string& source) {
    if (std::ranges::find(library.sources, source, &resin::Source::name) != library.sources.end()) {
      return;
    }
    throw ConfigError(
        fmt::format("{}: resin \"{}\" names the source \"{}\", but there is no "
                    "[source.{}]",
                    file.string(), resin.name, source, source));
  };
  for (const auto& resin : library.resins) {
    for (const auto& p : resin.properties) check(resin, p.source);
    for (const auto& m : resin.moduli) check(resin, m.source);
  }
}

resin::Library read_library_text(std::string_view text,
                                 const std::filesystem::path& file,
                                 const UnitSystem& units) {
  const auto table = parse_toml(text, file);
  Reading reading{units, file, {}};
  Section top(reading, table, "", "");
  resin::Library library;
  auto sources = top.table("source");
  for (const auto& name : sources.keys()) {
    auto source = sources.table(name);
    library.sources.push_back({name, source.word("citation")});
    source.finish();
  }
  for (auto& section : top.tables("resin")) {
    auto entry = read_resin_entry(section);
    for (const auto& name : entry.aliases) {
      if (library.find(name) != nullptr) section.fail("aliases", "names another resin too");
    }
    if (library.find(entry.name) != nullptr) section.fail("name", "is there twice");
    library.resins.push_back(std::move(entry));
  }
  top.finish();
  check_sources(library, file);
  return library;
}

}  // namespace

std::span<const ResinKey> resin_keys() { return keys; }

resin::Library builtin_library(const UnitSystem& units) {
  return read_library_text(builtin_library_text, "resins/library.toml", units);
}

resin::Library read_library(const std::filesystem::path& file, const UnitSystem& units) {
  return read_library_text(read_text_file(file), file, units);
}

}  // namespace packbed::setup
