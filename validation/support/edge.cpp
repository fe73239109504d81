// SPDX-License-Identifier: BSD-3-Clause
#include "validation/support/edge.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::validation {
namespace {

/// Solid fraction where the line through the last two states meets no pressure.
double edge_of(const Table& t, double exponent) {
  const auto phi = t.column("solid_fraction");
  const auto p = t.column("pressure");
  const auto n = phi.size();
  const double b = std::pow(p[n - 1], 1.0 / exponent);
  const double a = std::pow(p[n - 2], 1.0 / exponent);
  return phi[n - 1] - b * (phi[n - 2] - phi[n - 1]) / (a - b);
}

}  // namespace

Table path_to_edge(test::SphereBox& box, const EdgePath& path) {
  constexpr std::int64_t most_steps = 400000;
  constexpr double most_change = 0.005;
  constexpr int most_states = 100;
  Table t{.columns = {"solid_fraction", "pressure", "coordination", "carrying", "unbalanced"},
          .rows = {}};
  double next = box.solid_fraction();
  for (int state = 0; state < most_states; ++state) {
    box.set_solid_fraction(next);
    const bool relaxed = box.relax(path.at_rest, most_steps);
    const auto f = box.figures();
    const bool at_rest = relaxed && f.carrying > 0;
    fmt::print(stderr, "phi {:.8f} p {:.4e} z {:.4f} carrying {} unbalanced {:.1e}{}\n",
               f.solid_fraction, f.pressure, f.coordination, f.carrying, f.unbalanced,
               at_rest ? "" : " loose");
    if (!at_rest) {  // too far, or loose: half the way back
      if (t.rows.empty()) throw DivergenceError("the packing does not come to rest under pressure");
      const double holds = t.rows.back()[0];
      if (t.rows.size() > 1 && holds - next < path.least_excess) break;
      next = 0.5 * (next + holds);
      continue;
    }
    t.rows.push_back({f.solid_fraction, f.pressure, f.coordination, static_cast<double>(f.carrying),
                      f.unbalanced});
    if (t.rows.size() < 2) {
      next -= std::min(0.4 * path.step * std::pow(f.pressure, 1.0 / path.exponent), most_change);
      continue;
    }
    const double excess = next - edge_of(t, path.exponent);
    if (excess < path.least_excess) break;
    next -= std::min(path.step * excess, most_change);
  }
  return t;
}

EdgeFigures edge_figures(const Table& path, double exponent, double low, double high) {
  const double edge = edge_of(path, exponent);
  const auto phi = path.column("solid_fraction");
  const auto p = path.column("pressure");
  const auto z = path.column("coordination");
  std::vector<double> log_excess;
  std::vector<double> log_p;
  std::vector<double> root;
  std::vector<double> contacts;
  for (std::size_t k = 0; k < phi.size(); ++k) {
    const double excess = phi[k] - edge;
    if (excess < low || excess > high) continue;
    log_excess.push_back(std::log(excess));
    log_p.push_back(std::log(p[k]));
    root.push_back(std::sqrt(excess));
    contacts.push_back(z[k]);
  }
  const auto dz = fit_line(root, contacts);
  return {.solid_fraction = edge,
          .exponent = fit_line(log_excess, log_p).slope,
          .coordination = dz.offset,
          .coordination_slope = dz.slope};
}

}  // namespace packbed::validation
