// SPDX-License-Identifier: BSD-3-Clause
#include "app/fit_print.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"

namespace packbed::app {
namespace {

using Json = nlohmann::ordered_json;
using study::CurveFit;

struct Unit {
  std::string_view suffix, shown;
  double factor;
};
// Longest suffixes first.
constexpr std::array units = {
    Unit{"_N_m", "N/m", 1.0},  Unit{"_kg_m3", "kg/m3", 1.0}, Unit{"_Pa_s", "MPa s", 1e-6},
    Unit{"_m_s", "um/s", 1e6}, Unit{"_Pa", "MPa", 1e-6},     Unit{"_um", "um", 1.0},
    Unit{"_N", "uN", 1e6},     Unit{"_J", "pJ", 1e12},       Unit{"_s", "s", 1.0},
    Unit{"_m", "um", 1e6},
};

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// Mean and standard deviation of one figure over the curves.
struct OverCurves {
  std::string name;
  double mean = 0.0;
  double deviation = 0.0;
  std::size_t curves = 0;
};

std::vector<std::pair<std::string, double>> all_figures(const CurveFit& fit) {
  std::vector<std::pair<std::string, double>> all;
  for (const auto& e : fit.fit.estimates) all.emplace_back(e.name, e.value);
  for (const auto& e : fit.figures) all.emplace_back(e.name, e.value);
  for (const auto& [name, value] : fit.facts) all.emplace_back(name, value);
  return all;
}

std::vector<OverCurves> over_curves(const std::vector<CurveFit>& fits) {
  std::vector<OverCurves> result;
  for (const auto& [name, ignored] : all_figures(fits.front())) {
    std::vector<double> values;
    for (const auto& fit : fits) {
      for (const auto& [other, value] : all_figures(fit)) {
        if (other == name) values.push_back(value);
      }
    }
    OverCurves o{.name = name, .curves = values.size()};
    const auto n = static_cast<double>(values.size());
    for (const double v : values) o.mean += v / n;
    for (const double v : values) o.deviation += (v - o.mean) * (v - o.mean);
    o.deviation = n > 1.0 ? std::sqrt(o.deviation / (n - 1.0)) : 0.0;
    result.push_back(o);
  }
  return result;
}

}  // namespace

study::Intervals read_intervals(const std::string& text) {
  if (text == "linear") return study::Intervals::linear;
  if (text == "profile") return study::Intervals::profile;
  throw ConfigError(
      fmt::format("--intervals \"{}\" is not known; known are linear and profile", text));
}

Shown shown(const std::string& name) {
  for (const auto& u : units) {
    if (!name.ends_with(u.suffix)) continue;
    return {fmt::format("{} [{}]", name.substr(0, name.size() - u.suffix.size()), u.shown),
            u.factor};
  }
  return {name, 1.0};
}

Json estimate_json(const study::Estimate& e) {
  Json j{{"value", finite(e.value)},
         {"error", finite(e.error)},
         {"low", finite(e.low)},
         {"high", finite(e.high)}};
  if (e.at_bound) j["at_bound"] = true;
  return j;
}

Json correlation_json(const study::Fit& fit) {
  Json rows = Json::array();
  for (std::size_t a = 0; a < fit.size(); ++a) {
    Json row = Json::array();
    for (std::size_t b = 0; b < fit.size(); ++b)
      row.push_back(finite(fit.correlation[a * fit.size() + b]));
    rows.push_back(row);
  }
  return rows;
}

Json fit_json(const CurveFit& fit) {
  Json j{{"curve", fit.curve}};
  for (const auto& [name, value] : fit.facts) j[name] = value;
  if (fit.fit.estimates.empty()) return j;
  j["rows"] = fit.fit.rows;
  j["r2"] = fit.r2;
  j["bic"] = finite(fit.fit.bic());
  j["converged"] = fit.fit.converged;
  for (const auto& e : fit.fit.estimates) j["parameters"][e.name] = estimate_json(e);
  for (const auto& e : fit.figures) j["figures"][e.name] = estimate_json(e);
  j["correlation"] = correlation_json(fit.fit);
  return j;
}

Json over_curves_json(const std::vector<CurveFit>& fits) {
  Json j;
  for (const auto& o : over_curves(fits)) {
    j[o.name] = {{"mean", o.mean}, {"standard_deviation", o.deviation}, {"curves", o.curves}};
  }
  return j;
}

void print_estimate(const study::Estimate& e) {
  const auto s = shown(e.name);
  const auto number = [&](double v, const char* otherwise = "unknown") {
    return std::isfinite(v) ? fmt::format("{:.5g}", v * s.factor) : otherwise;
  };
  fmt::print("  {:<28} {:>12} +- {:<10} [{}, {}]{}\n", s.name, number(e.value), number(e.error),
             number(e.low, "open"), number(e.high, "open"), e.at_bound ? "  at a bound" : "");
}

void print_correlation(const study::Fit& fit) {
  if (fit.size() < 2) return;
  fmt::print("  correlation of {}\n",
             fmt::join(
                 [&] {
                   std::vector<std::string> names;
                   for (const auto& p : fit.parameters)
                     names.push_back(shown(p.name).name.substr(0, shown(p.name).name.find(" [")));
                   return names;
                 }(),
                 ", "));
  for (std::size_t a = 1; a < fit.size(); ++a) {
    fmt::print("   ");
    for (std::size_t b = 0; b < a; ++b) fmt::print(" {:6.3f}", fit.correlation[a * fit.size() + b]);
    fmt::print("\n");
  }
}

void print_fit(const CurveFit& fit) {
  fmt::print("{}\n", fit.curve);
  for (const auto& [name, value] : fit.facts) {
    const auto s = shown(name);
    fmt::print("  {:<28} {:>12.5g}\n", s.name, value * s.factor);
  }
  if (fit.fit.estimates.empty()) return;
  fmt::print("  {:<28} {:>12}\n  {:<28} {:>12.6f}\n", "rows", fit.fit.rows, "R2", fit.r2);
  fmt::print("  {:<28} {:>12} +- {:<10} [95 % interval]\n", "", "value", "error");
  for (const auto& e : fit.fit.estimates) print_estimate(e);
  for (const auto& e : fit.figures) print_estimate(e);
  print_correlation(fit.fit);
  if (!fit.fit.converged) fmt::print("  NOT CONVERGED after {} iterations\n", fit.fit.iterations);
}

void print_over_curves(const std::vector<CurveFit>& fits) {
  fmt::print("Over {} curves: mean +- standard deviation\n", fits.size());
  for (const auto& o : over_curves(fits)) {
    const auto s = shown(o.name);
    fmt::print("  {:<28} {:>12.5g} +- {:.5g}{}\n", s.name, o.mean * s.factor,
               o.deviation * s.factor,
               o.curves == fits.size() ? "" : fmt::format("  ({} curves)", o.curves));
  }
}

}  // namespace packbed::app
