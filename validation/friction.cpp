// SPDX-License-Identifier: BSD-3-Clause
// P3: 1000 spheres of one size and any friction in a periodic box, grown slowly from a solid fraction
// of 0.45, at rest under pressures that rise from 3e-5 k_n / d. With friction the number of contacts at
// no pressure falls from 2 d = 6 to d + 1 = 4 and the solid fraction from random close to random loose
// packing, 0.55, over several decades. Reference: Silbert, Soft Matter 6 (2010) 2918 (arXiv 1108.0012),
// abstract; it says too that the figures depend on the way to the packing.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "validation/support/edge.hpp"

namespace packbed::validation {
namespace {

constexpr int count = 1000;
constexpr double start = 0.45;  // solid fraction, loose at any friction
constexpr std::array frictions = {0.0, 0.01, 0.03, 0.1, 0.3, 1.0, 10.0};
constexpr std::array seeds = {1, 2};

constexpr double at_rest = 1e-5;  // unbalanced / contact force

void grow(test::SphereBox& box, double growth) {
  box.set_solid_fraction(box.solid_fraction() * (1.0 + growth));
  box.run(200);
}

/// Grown fast until pressure stays for a while, then shrunk to none: near the edge, and loose. A bed
/// that is grown has pressure before it holds any: looked at while it creeps on it passes for jammed.
void come_near(test::SphereBox& box) {
  constexpr double growth = 3e-4;   // of the solid fraction in 200 time steps
  constexpr double pressed = 5e-4;  // mean overlap / diameter
  box.relax(1e-2, 20000, 1e-4);
  do grow(box, growth);
  while (box.strain() < pressed || !box.relax(1e-3, 40000, 0.5 * pressed));
  box.set_solid_fraction(box.solid_fraction() * (1.0 - 6.0 * pressed));
  box.relax(at_rest, 20000);
}

/// States at rest under a pressure that rises from state to state by `ratio`. A packing with friction
/// that is shrunk slips and loses all pressure at once, so the edge is approached from the loose side:
/// what gives way is grown on until it holds.
Table path(double friction, std::uint64_t seed) {
  constexpr double least = 3e-5;  // mean overlap / diameter
  constexpr double most = 1.2e-3;
  constexpr double ratio = 1.5;
  const int least_contacts = friction > 0.0 ? 2 : 4;  // friction can hold a bead between two others
  const dem::ContactModel model{
      .contact = test::hooke(0.5, false), .rolling = dem::NoRolling{}, .friction = friction};
  test::SphereBox box(model, count, start, seed, least_contacts);
  come_near(box);
  Table t{.columns = {"solid_fraction", "pressure", "coordination", "carrying", "unbalanced"},
          .rows = {}};
  for (double strain = least; strain < most;) {
    grow(box, strain);  // overlaps grow by a third of that
    if (box.strain() < strain || !box.relax(at_rest, 200000, 0.5 * strain)) continue;
    const auto f = box.figures();
    fmt::print(stderr, "phi {:.8f} p {:.4e} z {:.4f} carrying {} unbalanced {:.1e}\n",
               f.solid_fraction, f.pressure, f.coordination, f.carrying, f.unbalanced);
    t.rows.push_back({f.solid_fraction, f.pressure, f.coordination, static_cast<double>(f.carrying),
                      f.unbalanced});
    strain = ratio * box.strain();
  }
  std::ranges::reverse(t.rows);  // towards the edge, as edge_figures() has it
  return t;
}

std::string piece_name(double friction, int seed) { return fmt::format("mu{}-{}", friction, seed); }

/// Mean over the seeds; the coordination at the edge by a fit over the last excesses.
struct Edge {
  double solid_fraction, coordination;
};
Edge edge_at(const Results& results, double friction) {
  std::vector<double> fractions;
  std::vector<double> z;
  for (const int seed : seeds) {
    const auto f = edge_figures(results.at(piece_name(friction, seed)), 1.0, 0.0, 2e-3);
    fractions.push_back(f.solid_fraction);
    z.push_back(f.coordination);
  }
  return {mean(fractions), mean(z)};
}

std::vector<Check> judge(const Results& results) {
  std::vector<Edge> edges;
  for (const double mu : frictions) edges.push_back(edge_at(results, mu));
  const auto& none = edges.front();
  const auto& most = edges.back();
  std::vector<Check> checks = {
      {"mu = 0: coordination", none.coordination, 5.9, 6.1, "2 d, 6 +- 0.1"},
      {"mu = 10: coordination", most.coordination, 3.9, 4.1, "d + 1, 4 +- 0.1"},
      {"mu = 0: solid fraction", none.solid_fraction, 0.63, 0.65, "random close, 0.64 +- 0.01"},
      {"mu = 10: solid fraction", most.solid_fraction, 0.54, 0.56, "random loose, 0.55 +- 0.01"}};
  for (std::size_t k = 1; k < edges.size(); ++k) {
    const auto step = fmt::format("mu {} to {}: change of ", frictions[k - 1], frictions[k]);
    checks.push_back({step + "coordination", edges[k].coordination - edges[k - 1].coordination,
                      -2.1, 0.0, "falls"});
    checks.push_back({step + "solid fraction",
                      edges[k].solid_fraction - edges[k - 1].solid_fraction, -0.1, 0.0, "falls"});
  }
  return checks;
}

}  // namespace
}  // namespace packbed::validation

int main(int argc, char** argv) {
  using namespace packbed::validation;  // NOLINT
  Validation v;
  for (const double mu : frictions) {
    for (const int seed : seeds) {
      v.pieces.push_back({piece_name(mu, seed),
                          [mu, seed] { return path(mu, static_cast<std::uint64_t>(seed)); }});
    }
  }
  v.judge = judge;
  return validation_main(argc, argv, v);
}
