// SPDX-License-Identifier: BSD-3-Clause
#include "io/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::io {
namespace {

// Sizes in px.
constexpr double plot_width = 400.0;
constexpr double plot_height = 290.0;
constexpr double left = 78.0;
constexpr double top = 40.0;
constexpr double bottom = 58.0;
constexpr double legend_gap = 14.0;
constexpr double legend_mark = 26.0;
constexpr double line_height = 18.0;
constexpr double letter = 6.6;  // mean width at 12 px

// Okabe and Ito's colors, told apart by color-blind readers; without yellow, too light on white.
constexpr std::array<std::string_view, 7> palette = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                     "#56B4E9", "#E69F00", "#000000"};

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else
      out += c;
  }
  return out;
}

// A linear or logarithmic map of one axis to px.
struct Scale {
  bool logarithmic;
  double low, high;      // in data, or their logarithms
  double start, length;  // in px; the length is negative upward

  [[nodiscard]] double at(double value) const {
    const double v = logarithmic ? std::log10(value) : value;
    return start + (v - low) / (high - low) * length;
  }
  [[nodiscard]] bool shows(double value) const {
    if (!std::isfinite(value) || (logarithmic && value <= 0.0)) return false;
    const double v = logarithmic ? std::log10(value) : value;
    const double slack = 1e-9 * (high - low);
    return v >= low - slack && v <= high + slack;
  }
};

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void take(double v, bool logarithmic) {
    if (!std::isfinite(v) || (logarithmic && v <= 0.0)) return;
    low = std::min(low, v);
    high = std::max(high, v);
  }
};

Range data_range(const PlotPanel& panel, bool of_x) {
  const auto& axis = of_x ? panel.x : panel.y;
  Range range;
  for (const auto& s : panel.series) {
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      const double error = of_x || s.y_error.empty() ? 0.0 : s.y_error[i];
      range.take((of_x ? s.x[i] : s.y[i]) - error, axis.logarithmic);
      range.take((of_x ? s.x[i] : s.y[i]) + error, axis.logarithmic);
    }
  }
  if (axis.range) range = {axis.range->first, axis.range->second};
  if (!(range.low <= range.high)) {
    throw ValueError(fmt::format("the plot \"{}\" has no point to draw", panel.title));
  }
  return range;
}

// Points with error bars on the frame would be cut.
bool has_error_bars(const PlotPanel& panel) {
  return std::ranges::any_of(panel.series, [](const auto& s) { return !s.y_error.empty(); });
}

// A linear axis that nearly reaches 0 begins there; y gets some air, and x where it needs it.
Scale make_scale(const PlotPanel& panel, bool of_x, double start, double length) {
  const auto& axis = of_x ? panel.x : panel.y;
  auto [low, high] = data_range(panel, of_x);
  if (axis.logarithmic) {
    low = std::log10(low);
    high = std::log10(high);
  }
  if (high - low < 1e-12 * std::max(std::abs(low), std::abs(high)) || high == low) {
    const double half = high == 0.0 ? 1.0 : 0.1 * std::abs(high);
    low -= half;
    high += half;
  }
  if (!axis.range) {
    const bool from_zero = !axis.logarithmic && low >= 0.0 && low < 0.35 * high;
    const double share = axis.logarithmic ? 0.04 : 0.06;
    const double air = !of_x || has_error_bars(panel) ? share * (high - low) : 0.0;
    high += air;
    low = from_zero ? 0.0 : low - air;
  }
  return {axis.logarithmic, low, high, start, length};
}

std::vector<double> log_ticks(const Scale& s) {
  std::vector<double> ticks;
  const bool few = s.high - s.low < 3.2;
  const int last = static_cast<int>(std::floor(s.high));
  for (int e = static_cast<int>(std::floor(s.low)); e <= last; ++e) {
    for (const double m : {1.0, 2.0, 5.0}) {
      const double value = m * std::pow(10.0, e);
      if ((m == 1.0 || few) && s.shows(value)) ticks.push_back(value);
    }
  }
  return ticks;
}

std::string tick_text(double value, double step) {
  if (std::abs(value) < 1e-9 * step) return "0";
  const double size = std::max(std::abs(value), step);
  if (size >= 1e5 || size < 1e-3) return fmt::format("{:.3g}", value);
  const int digits = std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 9);
  return fmt::format("{:.{}f}", value, digits);
}

std::string text_at(double x, double y, std::string_view anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     escaped(text));
}

std::string axes(const PlotPanel& panel, const Scale& x, const Scale& y) {
  const auto ticks = [](const Scale& s, int wanted) {
    return s.logarithmic ? log_ticks(s) : linear_ticks(s.low, s.high, wanted);
  };
  const auto label = [](const Scale& s, const std::vector<double>& all, std::size_t i) {
    const double step = s.logarithmic || all.size() < 2 ? all[i] : all[1] - all[0];
    return tick_text(all[i], step);
  };
  std::string text;
  const auto xs = ticks(x, 6);
  for (std::size_t i = 0; i < xs.size(); ++i) {
    const double at = x.at(xs[i]);
    text += fmt::format("<path class=\"grid\" d=\"M{0:.1f} {1:.1f}V{2:.1f}\"/>\n", at, y.start,
                        y.start + y.length);
    text += text_at(at, y.start + 17.0, "middle", label(x, xs, i));
  }
  const auto ys = ticks(y, 6);
  for (std::size_t i = 0; i < ys.size(); ++i) {
    const double at = y.at(ys[i]);
    text += fmt::format("<path class=\"grid\" d=\"M{0:.1f} {1:.1f}H{2:.1f}\"/>\n", x.start, at,
                        x.start + x.length);
    text += text_at(x.start - 7.0, at + 4.0, "end", label(y, ys, i));
  }
  text += fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
      "fill=\"none\" stroke=\"#333\"/>\n",
      x.start, y.start + y.length, x.length, -y.length);
  text += text_at(x.start + 0.5 * x.length, y.start + 40.0, "middle", panel.x.label);
  const double middle = y.start + 0.5 * y.length;
  text += fmt::format(
      "<text transform=\"translate({:.1f} {:.1f}) rotate(-90)\" "
      "text-anchor=\"middle\">{}</text>\n",
      x.start - 58.0, middle, escaped(panel.y.label));
  text += fmt::format("<text class=\"title\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x.start,
                      y.start + y.length - 14.0, escaped(panel.title));
  return text;
}

std::string mark(PlotStyle style, double x, double y, std::string_view color) {
  if (style == PlotStyle::points) {
    return fmt::format(
        "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"2.8\" fill=\"{}\" fill-opacity=\"0.75\"/>\n", x, y,
        color);
  }
  return "";
}

std::string path_style(PlotStyle style, std::string_view color) {
  return fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{}", color,
                     style == PlotStyle::dashed ? " stroke-dasharray=\"6 4\"" : "");
}

std::string draw(const PlotSeries& s, const Scale& x, const Scale& y, std::string_view color) {
  std::string marks;
  std::string path;
  bool down = false;
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    if (!x.shows(s.x[i]) || !y.shows(s.y[i])) {
      down = false;
      continue;
    }
    const double px = x.at(s.x[i]);
    const double py = y.at(s.y[i]);
    if (!s.y_error.empty() && s.y_error[i] > 0.0 && y.shows(s.y[i] - s.y_error[i])) {
      marks += fmt::format(
          "<path stroke=\"{}\" fill=\"none\" d=\"M{:.2f} {:.2f}V{:.2f}\"/>\n", color, px,
          y.at(s.y[i] - s.y_error[i]),
          y.at(std::min(s.y[i] + s.y_error[i], y.logarithmic ? std::pow(10.0, y.high) : y.high)));
    }
    marks += mark(s.style, px, py, color);
    path += fmt::format("{}{:.2f} {:.2f}", down ? "L" : "M", px, py);
    down = true;
  }
  if (s.style == PlotStyle::points) return marks;
  return marks + fmt::format("<path {} d=\"{}\"/>\n", path_style(s.style, color), path);
}

std::string legend_entry(const PlotSeries& s, double x, double y, std::string_view color) {
  const double middle = y - 4.0;
  const auto sign = s.style == PlotStyle::points
                        ? mark(s.style, x + 11.0, middle, color)
                        : fmt::format("<path {} d=\"M{:.1f} {:.1f}h22\"/>\n",
                                      path_style(s.style, color), x, middle);
  return sign + text_at(x + legend_mark, y, "start", s.label);
}

double legend_width(const PlotPanel& panel) {
  std::size_t longest = 0;
  for (const auto& s : panel.series) longest = std::max(longest, s.label.size() + 4);
  for (const auto& note : panel.notes) longest = std::max(longest, note.size());
  return longest <= 4 ? 10.0 : legend_gap + letter * static_cast<double>(longest) + 10.0;
}

std::string draw_panel(const PlotPanel& panel, double x0, double y0) {
  const auto x = make_scale(panel, true, x0 + left, plot_width);
  const auto y = make_scale(panel, false, y0 + top + plot_height, -plot_height);
  std::string text = axes(panel, x, y);
  double legend = y0 + top + 12.0;
  const double legend_x = x.start + x.length + legend_gap;
  int next = 0;
  for (const auto& s : panel.series) {
    const auto place = static_cast<std::size_t>(s.color.value_or(next)) % palette.size();
    if (!s.color) ++next;
    text += draw(s, x, y, palette[place]);
    if (s.label.empty()) continue;
    text += legend_entry(s, legend_x, legend, palette[place]);
    legend += line_height;
  }
  for (const auto& note : panel.notes) {
    text += text_at(legend_x, legend, "start", note);
    legend += line_height;
  }
  return text;
}

}  // namespace

std::vector<double> linear_ticks(double low, double high, int wanted) {
  const double rough = (high - low) / wanted;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10.0 * power;
  for (const double m : {1.0, 2.0, 5.0}) {
    if (m * power >= rough * 0.75) {
      step = m * power;
      break;
    }
  }
  std::vector<double> ticks;
  const double slack = 1e-9 * (high - low);
  const double first = std::ceil((low - slack) / step);
  const int count = static_cast<int>(std::floor((high + slack) / step) - first) + 1;
  for (int i = 0; i < count; ++i) ticks.push_back((first + i) * step);
  return ticks;
}

std::string plot_svg(const std::vector<PlotPanel>& panels, int columns) {
  std::vector<double> widths(static_cast<std::size_t>(columns), 0.0);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    auto& width = widths[i % static_cast<std::size_t>(columns)];
    width = std::max(width, left + plot_width + legend_width(panels[i]));
  }
  constexpr double height = top + plot_height + bottom;
  std::string body;
  double total_width = 0.0;
  for (const double w : widths) total_width += w;
  double x = 0.0;
  double y = 0.0;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const auto column = i % static_cast<std::size_t>(columns);
    if (column == 0) {
      x = 0.0;
      if (i > 0) y += height;
    }
    body += draw_panel(panels[i], x, y);
    x += widths[column];
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"Helvetica, Arial, DejaVu Sans, sans-serif\" "
      "font-size=\"12\" fill=\"#222\">\n"
      "<style>.grid{{stroke:#ddd;fill:none}}.title{{font-size:14px;font-weight:bold}}</style>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{2}</svg>\n",
      total_width, y + height, body);
}

}  // namespace packbed::io
