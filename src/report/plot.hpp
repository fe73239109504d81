// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Plots as data: what the page draws, in lab units. How they look is decided by web/page.js.

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace packbed::report {

// Numbers inside are SI; these turn them into lab units.
inline constexpr double per_mm = 1e3;
inline constexpr double per_um = 1e6;
inline constexpr double per_cm_h = 3.6e5;
inline constexpr double per_bar = 1e-5;
inline constexpr double per_milli_pa_s = 1e3;

/// A color of the palette that stands back.
inline constexpr int gray = -1;

enum class Draw { line, dashed, dotted, points, line_with_points, dashed_with_points };

struct Curve {
  std::string label;
  std::vector<double> x;  ///< in ascending order
  std::vector<double> y;  ///< NaN: no point there
  Draw draw = Draw::line;
  int color = 0;                  ///< place in the palette
  std::optional<double> shade{};  ///< 0 to 1 on a scale of colors, in place of `color`
};

struct Axis {
  std::string label;  ///< with its unit: "time [s]"
  bool logarithmic = false;
  bool whole_numbers = false;
};

struct Plot {
  std::string title;
  Axis x;
  Axis y;
  std::vector<Curve> curves;
  std::string note = {};  ///< a line below it

  /// Adds a curve if it has a point that can be drawn.
  void add(Curve curve);
};

/// Plots under one heading.
struct PlotGroup {
  std::string id;  ///< for links within the page
  std::string title;
  std::string text;  ///< what they show
  std::vector<Plot> plots = {};

  /// Adds a plot if it has a curve.
  void add(Plot plot);
};

/// The data of a plot for page.js. Numbers have six digits, what is not finite is null.
nlohmann::ordered_json to_json(const Plot& plot);

}  // namespace packbed::report
