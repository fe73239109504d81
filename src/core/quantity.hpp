// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Quantities with units, as users write them ("90 um", "2763 cm/h"), turned into SI doubles.
/// Units are those of UDUNITS-2 and a few of the field ("cP"); docs/manual/units.md lists them.

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace packbed {

/// What a quantity measures. Each has one SI unit.
enum class Dimension {
  length,
  time,
  velocity,
  volume_flow,
  pressure,
  viscosity,
  density,
  temperature,
  force,
  frequency,
  inverse_length,
  fraction,
};

/// How a dimension is named and written in messages and files.
struct DimensionInfo {
  Dimension dimension;
  std::string_view name;     ///< "length"
  std::string_view si_unit;  ///< "m", as UDUNITS reads it; "1" for a fraction
  std::string_view suffix;   ///< "m", "kg_m3": the end of a column or JSON key
  std::string_view example;  ///< "90 um"
};

const DimensionInfo& info(Dimension dimension);
std::span<const DimensionInfo> all_dimensions();

/// A number with its unit as the user wrote them, not yet looked at by the unit system.
struct NumberWithUnit {
  double number;
  std::string digits;  ///< the number as it was written
  std::string unit;    ///< may be empty
};

/// Splits "90 um" into 90 and "um". Throws ValueError for anything else:
/// no number, decimal comma, a second number in the unit, not finite.
NumberWithUnit split_quantity(std::string_view text);

/// Converts quantities to SI. Reads the unit database once; keep one and pass it on.
/// Throws DataError if the database of UDUNITS-2 (package libudunits2-data) is not installed.
class UnitSystem {
 public:
  UnitSystem();
  ~UnitSystem();
  UnitSystem(const UnitSystem&) = delete;
  UnitSystem& operator=(const UnitSystem&) = delete;
  UnitSystem(UnitSystem&&) = delete;
  UnitSystem& operator=(UnitSystem&&) = delete;

  /// `text` in SI. Rounded once where the unit is a power of ten, a whole multiple or a whole
  /// fraction of the SI unit, so "86.9 um" is the double nearest to 8.69e-5. Throws ValueError: an unknown
  /// unit, a missing unit, a unit of another dimension (the message names it).
  [[nodiscard]] double to_si(std::string_view text, Dimension dimension) const;

  /// The dimension that the unit has, for a key that takes two (a velocity or a volume flow).
  /// Falls back to `otherwise` if the unit has neither it nor any other known dimension.
  [[nodiscard]] Dimension dimension_of(std::string_view text, Dimension otherwise) const;

 private:
  class Database;
  std::unique_ptr<Database> database_;
};

}  // namespace packbed
