// SPDX-License-Identifier: BSD-3-Clause
#include "setup/read_sizes.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/csv.hpp"
#include "core/error.hpp"

namespace packbed::setup {
namespace {

/// A column of lengths by name, with the unit of its header.
struct LengthColumn {
  int column;
  std::string unit;
};

int find_named(const CsvTable& table, std::string_view name, std::string& unit) {
  for (std::size_t i = 0; i < table.header().size(); ++i) {
    const auto column = split_column_name(table.header()[i]);
    if (column.name != name) continue;
    unit = column.unit;
    return static_cast<int>(i);
  }
  return -1;
}

LengthColumn length_column(const CsvTable& table,
                           std::string_view name,
                           std::string_view whole_header) {
  std::string unit;
  const int column = find_named(table, name, unit);
  if (column < 0) {
    throw ConfigError(fmt::format("{}: column \"{}\" is missing; the header must be \"{}\"",
                                  table.header_place(), name, whole_header));
  }
  if (unit.empty()) {
    throw ConfigError(fmt::format("{}: column \"{}\" has no unit; the header must be \"{}\"",
                                  table.header_place(), name, whole_header));
  }
  return {column, unit};
}

double length(const CsvTable& table,
              std::size_t row,
              const LengthColumn& column,
              const UnitSystem& units) {
  const double number = table.number(row, column.column);
  try {
    return units.to_si(fmt::format("{} {}", number, column.unit), Dimension::length);
  } catch (const ValueError& error) {
    throw ConfigError(fmt::format("{}: unit [{}] is refused: {}", table.header_place(), column.unit,
                                  error.what()));
  }
}

resin::SizeDistribution read_histogram(const std::filesystem::path& file,
                                       const UnitSystem& units,
                                       resin::Weighting weighting) {
  const CsvTable table(file);
  constexpr auto header = "lower [um],upper [um],share";
  const auto lower = length_column(table, "lower", header);
  const auto upper = length_column(table, "upper", header);
  std::string unit;
  const int share = find_named(table, "share", unit);
  if (share < 0) {
    throw ConfigError(fmt::format("{}: column \"share\" is missing; the header must be \"{}\"",
                                  table.header_place(), header));
  }
  std::vector<resin::Bin> bins;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    bins.push_back({length(table, row, lower, units), length(table, row, upper, units),
                    table.number(row, share)});
  }
  try {
    return resin::Histogram::from(bins, weighting);
  } catch (const ValueError& error) {
    throw ConfigError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

resin::SizeDistribution read_measured(const std::filesystem::path& file, const UnitSystem& units) {
  const CsvTable table(file);
  const auto column = length_column(table, "diameter", "diameter [um]");
  std::vector<double> diameters;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    diameters.push_back(length(table, row, column, units));
    if (!(diameters.back() > 0.0)) {
      throw ConfigError(fmt::format("{}: diameter = {} must be positive", table.place(row),
                                    table.text(row, column.column)));
    }
  }
  return resin::Measured::from(diameters);
}

/// The library's value for a key of the sizes, if it has one.
std::optional<Fallback> from_library(const resin::Resin* resin, std::string_view key) {
  const auto* p = resin == nullptr ? nullptr : resin->find(key);
  if (p == nullptr) return std::nullopt;
  return Fallback{p->text, library_origin(*p)};
}

double read_length(Section& section,
                   const resin::Resin* resin,
                   std::string_view key,
                   std::string_view library_key) {
  const auto fallback = from_library(resin, library_key);
  if (!section.has(key) && !fallback && resin != nullptr) {
    section.fail_missing(
        key, fmt::format("is missing: the library does not have it for \"{}\"; give it, or your "
                         "own sizes (distribution = \"measured\" or \"histogram\" with csv)",
                         resin->name));
  }
  return section.quantity(key, Dimension::length, bounds::positive, fallback);
}

resin::SizeDistribution read_normal(Section& section, const resin::Resin* resin) {
  section.mention({"mean", "standard_deviation", "minimum", "maximum"});
  const double mean = read_length(section, resin, "mean", "diameter_mean");
  const double sd =
      read_length(section, resin, "standard_deviation", "diameter_standard_deviation");
  const double minimum = read_length(section, resin, "minimum", "diameter_min");
  const double maximum = read_length(section, resin, "maximum", "diameter_max");
  return resin::TruncatedNormal::from(mean, sd, minimum, maximum);
}

resin::SizeDistribution read_lognormal(Section& section) {
  constexpr Bounds above_1{.low = 1.0, .refusal = "must be above 1"};
  section.mention({"median", "geometric_standard_deviation", "minimum", "maximum"});
  const double median = section.quantity("median", Dimension::length, bounds::positive);
  const double spread =
      section.quantity("geometric_standard_deviation", Dimension::fraction, above_1);
  // A simulation needs a largest bead: three deviations hold 99.7 % of the beads.
  const auto cut = [&](double power) {
    return Fallback{fmt::format("{} m", median * std::pow(spread, power)),
                    fmt::format("default: median times geometric_standard_deviation^{}", power)};
  };
  const double minimum =
      section.quantity("minimum", Dimension::length, bounds::positive, cut(-3.0));
  const double maximum = section.quantity("maximum", Dimension::length, bounds::positive, cut(3.0));
  return resin::Lognormal::from(median, spread, minimum, maximum);
}

std::filesystem::path read_file_key(Section& section) {
  const auto file = section.optional_file("csv");
  if (!file) section.fail_missing("csv", "is missing; give the name of a CSV file");
  return *file;
}

}  // namespace

std::string library_origin(const resin::Property& property) {
  return fmt::format("library: {}{}{}", property.source, property.where.empty() ? "" : ", ",
                     property.where);
}

resin::SizeDistribution read_sizes(Section section,
                                   const UnitSystem& units,
                                   const resin::Resin* resin) {
  const auto kind = section.choice("distribution",
                                   {"normal", "lognormal", "histogram", "measured", "monodisperse"},
                                   Fallback{"normal"});
  resin::SizeDistribution sizes = resin::Monodisperse{0.0};
  try {
    switch (kind) {
      case 0:
        sizes = read_normal(section, resin);
        break;
      case 1:
        sizes = read_lognormal(section);
        break;
      case 2: {
        const auto weighting =
            static_cast<resin::Weighting>(section.choice("share_of", {"number", "volume"}));
        sizes = read_histogram(read_file_key(section), units, weighting);
        break;
      }
      case 3:
        sizes = read_measured(read_file_key(section), units);
        break;
      default:
        sizes =
            resin::Monodisperse{section.quantity("diameter", Dimension::length, bounds::positive)};
    }
  } catch (const ValueError& error) {
    section.fail_here(error.what());
  }
  section.finish();
  return sizes;
}

}  // namespace packbed::setup
