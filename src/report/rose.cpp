// SPDX-License-Identifier: BSD-3-Clause
#include "report/rose.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "report/html.hpp"

namespace packbed::report {
namespace {

constexpr double reach = 130.0;  ///< of the largest circle, in units of the picture
constexpr double margin = 22.0;  ///< around it, for words

/// Two or three circles at round values.
struct Rings {
  double step = 1.0;
  int count = 1;
  [[nodiscard]] double scale() const { return reach / (step * count); }
};

Rings rings(double largest) {
  const double decade = std::pow(10.0, std::floor(std::log10(largest)));
  for (const double factor : {0.1, 0.2, 0.25, 0.5, 1.0, 2.0, 2.5, 5.0}) {
    const double step = factor * decade;
    const int count = static_cast<int>(std::ceil(largest / step - 1e-9));
    if (count <= 4) return {step, count};
  }
  return {10.0 * decade, 1};
}

double largest_of(const Rose& rose) {
  double largest = 0.0;
  for (const auto& c : rose.curves) {
    for (const double y : c.y) {
      if (std::isfinite(y)) largest = std::max(largest, y);
    }
  }
  return largest;
}

/// Once around, from the right upwards.
std::string outline(const Curve& curve, double scale) {
  std::string points;
  const auto size = curve.x.size();
  for (int quadrant = 0; quadrant < 4; ++quadrant) {
    for (std::size_t k = 0; k < size; ++k) {
      const auto i = quadrant % 2 == 0 ? k : size - 1 - k;
      if (!std::isfinite(curve.y[i])) continue;
      const double angle = curve.x[i] * std::numbers::pi / 180.0;
      const double across = quadrant == 0 || quadrant == 3 ? 1.0 : -1.0;
      const double up = quadrant < 2 ? 1.0 : -1.0;
      points += fmt::format("{:.1f},{:.1f} ", across * scale * curve.y[i] * std::cos(angle),
                            -up * scale * curve.y[i] * std::sin(angle));
    }
  }
  return points;
}

std::string grid(const Rings& r) {
  std::string svg;
  for (int k = 1; k <= r.count; ++k) {
    const double radius = reach * k / r.count;
    svg += fmt::format(
        "<circle r=\"{0:.1f}\" class=\"ring\"/><text x=\"3\" y=\"{1:.1f}\">{2:.3g}</text>\n",
        radius, -radius + 12.0, r.step * k);
  }
  svg += fmt::format(
      "<path class=\"ring\" d=\"M-{0},0H{0}M0,-{0}V{0}\"/>\n"
      "<text y=\"{1}\" text-anchor=\"middle\">axial</text>\n"
      "<text x=\"{2}\" y=\"-4\" text-anchor=\"end\">lateral</text>\n",
      reach, -reach - 6.0, reach + margin);
  return svg;
}

}  // namespace

std::string rose_figure(const Rose& rose) {
  const double largest = largest_of(rose);
  if (!(largest > 0.0)) return {};
  const auto r = rings(largest);
  std::string lines;
  std::string legend;
  for (const auto& c : rose.curves) {
    const auto color = fmt::format("var(--c{})", c.color % 8);
    lines +=
        fmt::format("<polygon points=\"{}\" style=\"stroke:{}\"/>\n", outline(c, r.scale()), color);
    legend += fmt::format("<li><i style=\"background:{}\"></i>{}</li>", color, escaped(c.label));
  }
  const double half = reach + margin;
  return fmt::format(
      "<figure><figcaption>{}</figcaption>\n<svg class=\"rose\" viewBox=\"{:.0f} {:.0f} {:.0f} "
      "{:.0f}\" "
      "role=\"img\" aria-label=\"{}\">\n{}{}</svg>\n<ul class=\"rose-legend\">{}</ul>\n"
      "<p class=\"fine\">Distance from the center: {}</p></figure>\n",
      escaped(rose.title), -half, -half, 2.0 * half, 2.0 * half, escaped(rose.title), grid(r),
      lines, legend, escaped(rose.radius));
}

}  // namespace packbed::report
