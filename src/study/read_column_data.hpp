// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/quantity.hpp"
#include "study/wall_support_fit.hpp"

namespace packbed::study {

/// What holds where the file has no column of it.
struct ColumnDataDefaults {
  std::optional<double> height;     ///< settled [m]
  double gradient_share = 0.05;     ///< relative error of the pressure drop; thesis fig. 7.12
  double compression_share = 0.15;  ///< of the compression; thesis fig. 7.14
};

/// Measurements from a CSV file: `diameter`, `velocity`, `pressure_gradient` and/or `compression`, and where there
/// are `height`, `pressure_gradient_error`, `compression_error`. Throws ConfigError naming the line.
struct ColumnData {
  std::vector<ColumnDatum> rows;
  bool has_errors = false;  ///< errors came with the data
};
ColumnData read_column_data(const std::filesystem::path& file,
                            const UnitSystem& units,
                            const ColumnDataDefaults& defaults);

}  // namespace packbed::study
