// SPDX-License-Identifier: BSD-3-Clause
// P2: 2000 frictionless spheres of one size in a periodic box, at the edge of rigidity. They start
// at random places with the diameter of a solid fraction of 0.66 and are pushed apart to rest, then
// shrunk to no pressure: the ensemble of O'Hern, Silbert, Liu and Nagel, Phys. Rev. E 68 (2003)
// 011306. "grown": from small to large diameters instead.
#include <cmath>

#include <fmt/format.h>

#include "validation/support/edge.hpp"

namespace packbed::validation {
namespace {

constexpr int count = 2000;
constexpr double start = 0.66;     // solid fraction, well above the edge
constexpr int least_contacts = 4;  // a sphere without friction needs d + 1

struct Law {
  const char* name;
  bool hertz;
  bool grown;
  int seeds;
};
constexpr Law laws[] = {
    {"hooke", false, false, 4}, {"hertz", true, false, 3}, {"grown", false, true, 2}};

double exponent(const Law& law) { return law.hertz ? 1.5 : 1.0; }

dem::ContactModel model(const Law& law) {
  dem::ContactModel m{.contact = test::hooke(0.5, false), .rolling = dem::NoRolling{}};
  if (law.hertz) m.contact = dem::HertzMindlin{.restitution = 0.5};
  return m;
}

test::SphereBox compressed(const Law& law, std::uint64_t seed) {
  if (!law.grown) return {model(law), count, start, seed, least_contacts};
  test::SphereBox box(model(law), count, 0.3, seed, least_contacts);
  box.relax(1e-2, 20000, 1e-4);
  while (box.solid_fraction() < start) {
    box.set_solid_fraction(box.solid_fraction() + (box.solid_fraction() < 0.58 ? 0.01 : 0.003));
    box.relax(1e-2, 20000, 1e-4);
  }
  return box;
}

Table path(const Law& law, std::uint64_t seed) {
  auto box = compressed(law, seed);
  return path_to_edge(box, {.exponent = exponent(law), .at_rest = 1e-7, .least_excess = 4e-6});
}

std::string piece_name(const Law& law, int seed) { return fmt::format("{}-{}", law.name, seed); }

std::vector<Check> judge_law(const Results& results, const Law& law) {
  std::vector<double> fractions;
  std::vector<double> exponents;
  std::vector<double> z;
  std::vector<double> slopes;
  for (int seed = 1; seed <= law.seeds; ++seed) {
    const auto f = edge_figures(results.at(piece_name(law, seed)), exponent(law), 1e-5, 1e-2);
    fractions.push_back(f.solid_fraction);
    exponents.push_back(f.exponent);
    z.push_back(f.coordination);
    slopes.push_back(f.coordination_slope);
  }
  const std::string name = law.name;
  const double power = exponent(law);
  return {
      {name + ": solid fraction at the edge", mean(fractions), 0.636, 0.643,
       "0.639 to 0.64, +- 0.003"},
      {name + ": coordination at the edge, no rattlers", mean(z), 5.9, 6.1, "isostatic, 6 +- 0.1"},
      {name + ": exponent of the pressure", mean(exponents), power - 0.05, power + 0.05,
       "O'Hern 2003, +- 0.05"},
      {name + ": excess coordination / sqrt(excess fraction)", mean(slopes), 7.4, 8.4,
       "O'Hern 2003, 7.9 +- 0.5"}};
}

}  // namespace
}  // namespace packbed::validation

int main(int argc, char** argv) {
  using namespace packbed::validation;  // NOLINT
  Validation v;
  for (const auto& law : laws) {
    for (int seed = 1; seed <= law.seeds; ++seed) {
      v.pieces.push_back({piece_name(law, seed),
                          [law, seed] { return path(law, static_cast<std::uint64_t>(seed)); }});
    }
  }
  v.judge = [](const Results& results) {
    std::vector<Check> checks;
    for (const auto& law : laws) {
      for (const auto& c : judge_law(results, law)) checks.push_back(c);
    }
    return checks;
  };
  return validation_main(argc, argv, v);
}
