// SPDX-License-Identifier: BSD-3-Clause
// Beds of the thesis and of the literature, settled from a cloud as `packbed run` does it: porosity, rest,
// independence of the background damping, porosities asked for, wall porosity (P5), P10.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "analysis/bed_height.hpp"
#include "analysis/profile.hpp"
#include "continuum/wall_porosity.hpp"
#include "validation/support/settled_bed.hpp"
#include "validation/support/validation.hpp"

namespace packbed::validation {
namespace {

constexpr const char* liquid = "[liquid]\n";

std::string slice_case(const std::string& settle, const std::string& numerics = "") {
  return fmt::format(
      "[column]\nshape = \"slice\"\ninner_diameter = \"10 mm\"\nslice_depth = \"0.9 mm\"\n"
      "height = \"40 mm\"\n[resin]\nname = \"CM Sepharose 6FF\"\ncoarse_grain = 3\n{}"
      "[[protocol]]\nstep = \"settle\"\nbed_height = \"31 mm\"\n{}\n[numerics]\n{}\n",
      liquid, settle, numerics);
}

/// Cylinder of nearly equal grains of 0.3 mm, 16 diameters wide.
std::string equal_case() {
  return fmt::format(
      "[column]\nshape = \"cylinder\"\ninner_diameter = \"4.8 mm\"\nheight = \"12 mm\"\n"
      "[resin]\nname = \"CM Sepharose 6FF\"\n[resin.sizes]\ndistribution = \"normal\"\n"
      "mean = \"300 um\"\nstandard_deviation = \"6 um\"\nminimum = \"280 um\"\nmaximum = \"320 "
      "um\"\n{}"
      "[[protocol]]\nstep = \"settle\"\nbed_height = \"8 mm\"\n",
      liquid);
}

std::vector<double> figures_of(const Settled& bed) {
  const auto s = bed.dem.snapshot();
  const auto figures =
      analysis::bed_figures(analysis::own_beads(bed.dem.particles()),
                            mesh::cross_section(bed.c.column.shape), bed.dem.ranks());
  double fastest = 0.0;
  for (const auto& v : s.v) fastest = std::max(fastest, norm(v));
  return {static_cast<double>(bed.dem.bead_count()),
          figures.height,
          figures.middle_porosity,
          s.coordination_number,
          s.mean_unbalanced_force / s.mean_contact_force,
          fastest,
          budget_error(bed),
          static_cast<double>(bed.steps)};
}

const std::vector<std::string> figure_names = {
    "grains",     "height_m",    "porosity",     "coordination_number",
    "unbalanced", "fastest_m_s", "budget_error", "steps"};

Table figures_table(const std::string& text) {
  return {.columns = figure_names, .rows = {figures_of(settle(text))}};
}

/// Porosity over the distance from the wall in diameters, and figures in the first row.
Table wall_profile_table() {
  const auto bed = settle(equal_case());
  const auto figures = figures_of(bed);
  constexpr double d = 300e-6;
  const auto profile = analysis::wall_profile(
      analysis::own_beads(bed.dem.particles()), bed.c.column.shape,
      {.width = 0.02 * d, .z = analysis::middle_half(figures[1])}, bed.dem.ranks());
  Table t{.columns = {"distance_d", "porosity"}, .rows = {}};
  for (std::size_t k = 0; k < profile.size(); ++k) {
    t.rows.push_back({0.5 * (profile.edges[k] + profile.edges[k + 1]) / d, profile.porosity(k)});
  }
  return t;
}

double figure(const Results& results, const std::string& piece, const std::string& name) {
  return results.at(piece).column(name).front();
}

double porosity_at(const Table& profile, double distance) {
  const auto y = profile.column("distance_d");
  const auto eps = profile.column("porosity");
  std::size_t k = 0;
  while (k + 1 < y.size() && y[k + 1] < distance) ++k;
  const double share = std::clamp((distance - y[k]) / (y[k + 1] - y[k]), 0.0, 1.0);
  return eps[k] + share * (eps[k + 1] - eps[k]);
}

void judge_wall(const Results& results, std::vector<Check>& checks) {
  const auto& profile = results.at("wall-porosity");
  const auto y = profile.column("distance_d");
  const auto eps = profile.column("porosity");
  std::size_t lowest = 0;
  for (std::size_t k = 0; k < y.size() && y[k] < 1.0; ++k) {
    if (eps[k] < eps[lowest]) lowest = k;
  }
  checks.push_back({"wall porosity: first minimum, in diameters", y[lowest], 0.45, 0.55, "P5"});
  const continuum::BeyEigenberger reference{.column_diameter = 16.0, .bead_diameter = 1.0};
  for (const double at : {0.1, 0.25, 0.5, 1.0, 1.5, 2.0, 3.0}) {
    const double expected = reference(at);
    checks.push_back({fmt::format("wall porosity at {} d", at), porosity_at(profile, at),
                      expected - 0.05, expected + 0.05, "Bey and Eigenberger, P5"});
  }
}

// A quarter, half, once and twice the default.
constexpr std::array dampings = {"10 ms", "20 ms", "40 ms", "80 ms"};

std::string damping_piece(const char* damping) {
  return fmt::format("slice-damping-{}",
                     std::string(damping).substr(0, std::string(damping).find(' ')));
}

std::vector<Check> judge(const Results& results) {
  std::vector<Check> checks;
  const auto rests = [&](const std::string& piece) {
    checks.push_back({piece + ": unbalanced / contact force", figure(results, piece, "unbalanced"),
                      0.0, 1e-6, "rest"});
    checks.push_back(
        {piece + ": fastest grain [m/s]", figure(results, piece, "fastest_m_s"), 0.0, 1e-6, "P10"});
    checks.push_back({piece + ": height [mm]", 1e3 * figure(results, piece, "height_m"), 30.74,
                      31.26, "31 within one mean grain"});
  };
  double low = 1.0;
  double high = 0.0;
  for (const auto* damping : dampings) {
    const auto piece = damping_piece(damping);
    rests(piece);
    const double porosity = figure(results, piece, "porosity");
    low = std::min(low, porosity);
    high = std::max(high, porosity);
    checks.push_back({piece + ": porosity", porosity, 0.39, 0.415, "friction 0.1, rolling 0.35"});
  }
  checks.push_back({"slice: spread of porosity over the damping", high - low, 0.0, 0.002, "aim"});
  for (const double target : {0.38, 0.39}) {
    const auto piece = fmt::format("slice-porosity-{}", target);
    rests(piece);
    checks.push_back({piece + ": porosity", figure(results, piece, "porosity"), target - 0.001,
                      target + 0.001, "as asked for"});
  }
  judge_wall(results, checks);
  return checks;
}

}  // namespace
}  // namespace packbed::validation

int main(int argc, char** argv) {
  using namespace packbed::validation;  // NOLINT
  Validation v;
  for (const auto* damping : dampings) {
    v.pieces.push_back({damping_piece(damping), [damping] {
                          return figures_table(
                              slice_case("", fmt::format("background_damping = \"{}\"", damping)));
                        }});
  }
  for (const double target : {0.38, 0.39}) {
    v.pieces.push_back({fmt::format("slice-porosity-{}", target), [target] {
                          return figures_table(slice_case(fmt::format("porosity = {}", target)));
                        }});
  }
  v.pieces.push_back({"wall-porosity", wall_profile_table});
  v.judge = judge;
  return validation_main(argc, argv, v);
}
