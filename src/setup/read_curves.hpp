// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "continuum/bead/curve.hpp"
#include "core/quantity.hpp"

namespace packbed::setup {

/// Curves of beads from a CSV file with the columns `time`, `displacement`, `force` and their units, and where it
/// holds several curves `curve` (any text) and `radius`. `radius` [m] serves for curves without that column.
/// Throws ConfigError, naming the line: a missing or wrong unit or column, times out of order, no radius.
std::vector<continuum::BeadCurve> read_curves(const std::filesystem::path& file,
                                              const UnitSystem& units,
                                              std::optional<double> radius);

}  // namespace packbed::setup
