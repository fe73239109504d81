// SPDX-License-Identifier: BSD-3-Clause
#include "report/plot.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"

namespace packbed::report {
namespace {

using Json = nlohmann::ordered_json;

bool can_be_drawn(double value, const Axis& axis) {
  return std::isfinite(value) && (!axis.logarithmic || value > 0.0);
}

/// Six digits: a pixel is a thousandth of a plot, and the page stays small.
Json number(double value, const Axis& axis) {
  if (!can_be_drawn(value, axis)) return nullptr;
  return to_number(fmt::format("{:.6g}", value)).value_or(value);
}

Json numbers(const std::vector<double>& values, const Axis& axis) {
  auto list = Json::array();
  for (const double v : values) list.push_back(number(v, axis));
  return list;
}

std::string_view name(Draw draw) {
  switch (draw) {
    case Draw::line:
      return "line";
    case Draw::dashed:
      return "dashed";
    case Draw::dotted:
      return "dotted";
    case Draw::points:
      return "points";
    case Draw::line_with_points:
      return "line points";
    case Draw::dashed_with_points:
      return "dashed points";
  }
  return "line";
}

Json to_json(const Axis& axis) {
  return {{"label", axis.label}, {"log", axis.logarithmic}, {"whole", axis.whole_numbers}};
}

}  // namespace

void Plot::add(Curve curve) {
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (!can_be_drawn(curve.x[i], x) || !can_be_drawn(curve.y[i], y)) continue;
    curves.push_back(std::move(curve));
    return;
  }
}

void PlotGroup::add(Plot plot) {
  if (!plot.curves.empty()) plots.push_back(std::move(plot));
}

Json to_json(const Plot& plot) {
  Json json{{"title", plot.title}, {"x", to_json(plot.x)}, {"y", to_json(plot.y)}};
  const auto& first = plot.curves.front().x;
  const bool share_x =
      std::ranges::all_of(plot.curves, [&](const Curve& c) { return c.x == first; });
  if (share_x) json["shared_x"] = numbers(first, plot.x);
  auto curves = Json::array();
  for (const auto& c : plot.curves) {
    Json curve{{"label", c.label}, {"draw", name(c.draw)}, {"color", c.color}};
    if (c.shade) curve["shade"] = number(*c.shade, {});
    if (!share_x) curve["x"] = numbers(c.x, plot.x);
    curve["y"] = numbers(c.y, plot.y);
    curves.push_back(std::move(curve));
  }
  json["curves"] = std::move(curves);
  return json;
}

}  // namespace packbed::report
