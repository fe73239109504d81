// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Polar plots, which uPlot does not draw: SVG within the page, in the colors of its other plots.

#include <string>
#include <vector>

#include "report/plot.hpp"

namespace packbed::report {

/// Curves over directions that have no front and back. Curve::x are angles to the horizontal, 0 to 90 degrees ascending;
/// they are mirrored into all four quadrants. Curve::y are the distances from the center.
struct Rose {
  std::string title;
  std::string radius;  ///< what the distance from the center is
  std::vector<Curve> curves = {};
};

/// A figure of the page, as HTML; empty without a curve that can be drawn.
std::string rose_figure(const Rose& rose);

}  // namespace packbed::report
