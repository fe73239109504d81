// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Quantities given as options of a command ("--radius 30um"), with messages like those of case files.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/quantity.hpp"
#include "setup/section.hpp"

namespace packbed::app {

/// An option and what the user wrote; empty if it was not given.
struct Option {
  std::string_view name;  ///< "--radius"
  const std::string& text;
};

/// In SI. Throws ConfigError "--radius = "30 kg" is refused: ...", or "--radius is missing; ...".
double quantity(const UnitSystem& units,
                const Option& option,
                Dimension dimension,
                const setup::Bounds& bounds);

std::optional<double> optional_quantity(const UnitSystem& units,
                                        const Option& option,
                                        Dimension dimension,
                                        const setup::Bounds& bounds);

/// The value, or `fallback` in SI if the option was not given.
double quantity_or(const UnitSystem& units,
                   const Option& option,
                   Dimension dimension,
                   const setup::Bounds& bounds,
                   double fallback);

/// `count` values from `low` to `high`, both included; evenly, or with even ratios.
std::vector<double> spread(double low, double high, int count, bool even_ratios = false);

/// A table of results: a header of names with SI units ("force_N") and rows of numbers that read back to
/// the same doubles. Does nothing if no file is named.
void write_csv(const std::string& file,
               const std::vector<std::string>& header,
               const std::vector<std::vector<double>>& columns);

/// Writes a plot. Does nothing if no file is named.
void write_plot(const std::string& file, const std::string& svg);

}  // namespace packbed::app
