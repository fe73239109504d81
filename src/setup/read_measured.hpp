// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/quantity.hpp"

namespace packbed::setup {

/// What a lab measured of a bed in flow, one point per row. Columns that the table does not have are empty.
struct MeasuredFlow {
  std::vector<double> superficial_velocity;  ///< [m/s]
  std::vector<double> pressure_drop;         ///< without the hydrostatic part [Pa]
  std::vector<double> pressure_gradient;     ///< per present bed height [Pa/m]
  std::vector<double> compression;           ///< (H0 - H) / H0
  std::vector<double> bed_height;            ///< [m]
  bool operator==(const MeasuredFlow&) const = default;
};

/// Reads a table with the columns "superficial velocity [cm/h]" and at least one of "pressure drop [bar]",
/// "pressure drop per height [bar/m]", "compression [-]", "bed height [mm]", in any units.
/// Throws ConfigError "FILE:LINE: ..." for an unknown column or unit, a value that is no number or cannot be,
/// or where there is nothing to show; DataError if the file cannot be read.
MeasuredFlow read_measured(const std::filesystem::path& file, const UnitSystem& units);

/// The same points as a table in SI that read_measured reads.
std::string to_csv(const MeasuredFlow& measured);

}  // namespace packbed::setup
