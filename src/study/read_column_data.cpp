// SPDX-License-Identifier: BSD-3-Clause
#include "study/read_column_data.hpp"

#include <fmt/format.h>

#include "core/csv.hpp"
#include "core/error.hpp"
#include "setup/data_columns.hpp"

namespace packbed::study {
namespace {

constexpr auto example = "diameter [mm],velocity [cm/h],pressure_gradient [bar/m],compression";

bool has_gradient(const CsvTable& table, const std::string& name) {
  for (const auto& header : table.header()) {
    if (split_column_name(header).name == name || header == name + "_Pa_m") return true;
  }
  return false;
}

void need_positive(const CsvTable& table, std::size_t row, const char* name, double value) {
  if (!(value > 0.0))
    throw ConfigError(fmt::format("{}: {} must be positive", table.place(row), name));
}

}  // namespace

ColumnData read_column_data(const std::filesystem::path& file,
                            const UnitSystem& units,
                            const ColumnDataDefaults& defaults) {
  const CsvTable table(file);
  const setup::DataColumns columns(table, units, example);
  const auto diameter = columns.values("diameter", Dimension::length);
  const auto velocity = columns.values("velocity", Dimension::velocity);
  const bool gradients = has_gradient(table, "pressure_gradient");
  const bool compressions = columns.has_text("compression");
  // With neither of both this refuses, and shows the header that is wanted.
  const auto gradient = gradients || !compressions ? columns.pressure_gradients("pressure_gradient")
                                                   : std::vector<double>{};
  const auto compression =
      compressions ? columns.values("compression", Dimension::fraction) : std::vector<double>{};
  const bool gradient_errors = has_gradient(table, "pressure_gradient_error");
  const bool compression_errors = columns.has_text("compression_error");
  const auto gradient_error = gradient_errors
                                  ? columns.pressure_gradients("pressure_gradient_error")
                                  : std::vector<double>{};
  const auto compression_error = compression_errors
                                     ? columns.values("compression_error", Dimension::fraction)
                                     : std::vector<double>{};
  const bool heights = columns.has("height", Dimension::length);
  if (!heights && !defaults.height) {
    throw ConfigError(fmt::format(
        "{}: the settled height is not known; give --height, or a column \"height [mm]\"",
        table.header_place()));
  }
  const auto height = heights ? columns.values("height", Dimension::length) : std::vector<double>{};
  ColumnData data;
  data.has_errors = (!gradients || gradient_errors) && (!compressions || compression_errors);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    ColumnDatum d{.diameter = diameter[row],
                  .velocity = velocity[row],
                  .height = heights ? height[row] : *defaults.height};
    need_positive(table, row, "diameter", d.diameter);
    need_positive(table, row, "velocity", d.velocity);
    need_positive(table, row, "height", d.height);
    if (gradients) {
      d.gradient = gradient[row];
      d.gradient_error =
          gradient_errors ? gradient_error[row] : defaults.gradient_share * gradient[row];
      need_positive(table, row, "pressure_gradient", *d.gradient);
      need_positive(table, row, "pressure_gradient_error", d.gradient_error);
    }
    if (compressions) {
      d.compression = compression[row];
      d.compression_error = compression_errors ? compression_error[row]
                                               : defaults.compression_share * compression[row];
      need_positive(table, row, "compression", *d.compression);
      need_positive(table, row, "compression_error", d.compression_error);
    }
    data.rows.push_back(d);
  }
  return data;
}

}  // namespace packbed::study
