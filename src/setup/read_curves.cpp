// SPDX-License-Identifier: BSD-3-Clause
#include "setup/read_curves.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.hpp"
#include "setup/data_columns.hpp"

namespace packbed::setup {
namespace {

using continuum::BeadCurve;

BeadCurve& curve_named(std::vector<BeadCurve>& curves, const std::string& name) {
  const auto found = std::ranges::find(curves, name, &BeadCurve::name);
  if (found != curves.end()) return *found;
  curves.emplace_back();
  curves.back().name = name;
  return curves.back();
}

}  // namespace

std::vector<BeadCurve> read_curves(const std::filesystem::path& file,
                                   const UnitSystem& units,
                                   std::optional<double> radius) {
  const CsvTable table(file);
  const DataColumns columns(table, units, "time [s],displacement [um],force [uN]");
  const auto time = columns.values("time", Dimension::time);
  const auto approach = columns.values("displacement", Dimension::length);
  const auto force = columns.values("force", Dimension::force);
  const bool own_radius = columns.has("radius", Dimension::length);
  const auto radii =
      own_radius ? columns.values("radius", Dimension::length) : std::vector<double>{};
  if (!own_radius && !radius) {
    throw ConfigError(fmt::format(
        "{}: the radius of the bead is not known; give --radius, or a column \"radius [um]\"",
        table.header_place()));
  }
  const auto names = columns.has_text("curve")
                         ? columns.texts("curve")
                         : std::vector<std::string>(table.rows(), file.stem().string());
  std::vector<BeadCurve> curves;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    auto& curve = curve_named(curves, names[row]);
    if (!curve.time.empty() && time[row] < curve.time.back()) {
      throw ConfigError(
          fmt::format("{}: the time {} s comes after {} s; rows must be in the order of time",
                      table.place(row), time[row], curve.time.back()));
    }
    curve.radius = own_radius ? radii[row] : *radius;
    if (!(curve.radius > 0.0)) {
      throw ConfigError(fmt::format("{}: the radius must be positive", table.place(row)));
    }
    curve.time.push_back(time[row]);
    curve.approach.push_back(approach[row]);
    curve.force.push_back(force[row]);
  }
  return curves;
}

}  // namespace packbed::setup
