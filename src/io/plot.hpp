// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Line plots as one self-contained SVG text: no script, no request, readable in any browser.

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace packbed::io {

enum class PlotStyle { line, dashed, points };

struct PlotSeries {
  std::string label;  ///< in the legend; empty: not there
  std::vector<double> x;
  std::vector<double> y;
  PlotStyle style = PlotStyle::line;
  std::vector<double> y_error = {};  ///< half length of error bars; empty: none
  std::optional<int> color = {};     ///< place in the palette; by default one after the other
};

struct PlotAxis {
  std::string label;  ///< with its unit: "time [s]"
  bool logarithmic = false;
  std::optional<std::pair<double, double>> range = {};  ///< by default that of the data
};

/// One set of axes. Points that are not finite, or not positive on a logarithmic axis, break the line.
struct PlotPanel {
  std::string title;
  PlotAxis x;
  PlotAxis y;
  std::vector<PlotSeries> series;
  std::vector<std::string> notes = {};  ///< lines below the legend
};

/// Panels side by side, `columns` in a row. Throws ValueError if a panel has nothing to draw.
std::string plot_svg(const std::vector<PlotPanel>& panels, int columns = 2);

/// Ticks of an axis from low to high: multiples of 1, 2 or 5 times a power of ten, about `wanted` of them.
std::vector<double> linear_ticks(double low, double high, int wanted);

}  // namespace packbed::io
