// SPDX-License-Identifier: BSD-3-Clause
// P2: 2000 frictionless spheres of one size, grown in a periodic box and brought to the edge of
// rigidity from above. Reference: O'Hern, Silbert, Liu and Nagel, Phys. Rev. E 68 (2003) 011306.
#include <cmath>

#include <fmt/format.h>

#include "tests/support/sphere_box.hpp"
#include "validation/support/validation.hpp"

namespace packbed::validation {
namespace {

constexpr int count = 2000;
constexpr int hooke_seeds = 4;
constexpr int hertz_seeds = 2;
constexpr double most_excess = 0.02;    // of solid fraction over the edge, where a path turns back
constexpr double least_excess = 4e-6;   // and where it ends
constexpr double share_at_rest = 1e-7;  // unbalanced / contact force

/// Pressure grows as excess^exponent.
double exponent(bool hertz) { return hertz ? 1.5 : 1.0; }

dem::ContactModel model(bool hertz) {
  dem::ContactModel m{.contact = test::hooke(0.5, false), .rolling = dem::NoRolling{}};
  if (hertz) m.contact = dem::HertzMindlin{.restitution = 0.5};
  return m;
}

/// Random places, then slow growth until the packing is well above the edge.
test::SphereBox compressed(bool hertz, std::uint64_t seed) {
  constexpr int least_contacts = 4;  // a sphere without friction needs d + 1
  constexpr double first_guess = 0.64;
  test::SphereBox box(model(hertz), count, 0.3, seed, least_contacts);
  box.relax(1e-2, 20000, 1e-6);
  while (box.solid_fraction() < first_guess + most_excess) {
    box.set_solid_fraction(box.solid_fraction() + (box.solid_fraction() < 0.58 ? 0.01 : 0.003));
    box.relax(1e-2, 20000, 1e-6);
  }
  return box;
}

/// Solid fraction where p^(1/exponent), a straight line through two states, is 0.
double edge(const std::vector<double>& a, const std::vector<double>& b, bool hertz) {
  const double power = 1.0 / exponent(hertz);
  const double pa = std::pow(a[1], power);
  const double pb = std::pow(b[1], power);
  return b[0] - pb * (a[0] - b[0]) / (pa - pb);
}

/// Shrinks towards the edge, the excess halved from state to state.
Table path(bool hertz, std::uint64_t seed) {
  auto box = compressed(hertz, seed);
  Table t{.columns = {"solid_fraction", "pressure", "coordination", "carrying", "unbalanced"},
          .rows = {}};
  double next = box.solid_fraction();
  while (true) {
    box.set_solid_fraction(next);
    const bool jammed = box.relax(share_at_rest, 400000);
    if (!jammed) {  // too far: half the way back
      if (t.rows.empty()) break;
      next = 0.5 * (next + t.rows.back()[0]);
      continue;
    }
    const auto f = box.figures();
    t.rows.push_back({f.solid_fraction, f.pressure, f.coordination, static_cast<double>(f.carrying),
                      f.unbalanced});
    const auto n = t.rows.size();
    if (n < 2) {
      next -= 0.25 * most_excess;
      continue;
    }
    const double excess = next - edge(t.rows[n - 2], t.rows[n - 1], hertz);
    fmt::print(stderr, "{} p {:.4e} z {:.4f} excess {:.3e}\n", next, f.pressure, f.coordination,
               excess);
    if (excess < least_excess) break;
    next -= 0.5 * excess;
  }
  return t;
}

struct Fits {
  double edge, exponent, z_edge, z_slope;
};

Fits fits_of(const Table& t, bool hertz) {
  const auto& rows = t.rows;
  const double phi_c = edge(rows[rows.size() - 2], rows.back(), hertz);
  std::vector<double> log_excess;
  std::vector<double> log_p;
  std::vector<double> root;
  std::vector<double> z;
  for (const auto& row : rows) {
    const double excess = row[0] - phi_c;
    if (excess > 1e-2 || excess < 1e-5) continue;
    log_excess.push_back(std::log(excess));
    log_p.push_back(std::log(row[1]));
    root.push_back(std::sqrt(excess));
    z.push_back(row[2]);
  }
  const auto p = fit_line(log_excess, log_p);
  const auto dz = fit_line(root, z);
  return {.edge = phi_c, .exponent = p.slope, .z_edge = dz.offset, .z_slope = dz.slope};
}

std::string piece_name(bool hertz, int seed) {
  return fmt::format("{}-{}", hertz ? "hertz" : "hooke", seed);
}

std::vector<Check> judge_law(const Results& results, bool hertz) {
  std::vector<double> edges;
  std::vector<double> exponents;
  std::vector<double> z;
  std::vector<double> slopes;
  for (int seed = 1; seed <= (hertz ? hertz_seeds : hooke_seeds); ++seed) {
    const auto f = fits_of(results.at(piece_name(hertz, seed)), hertz);
    edges.push_back(f.edge);
    exponents.push_back(f.exponent);
    z.push_back(f.z_edge);
    slopes.push_back(f.z_slope);
  }
  const std::string law = hertz ? "Hertz" : "Hooke";
  const double power = exponent(hertz);
  return {
      {law + ": solid fraction at the edge", mean(edges), 0.636, 0.643, "0.639 to 0.64 +- 0.003"},
      {law + ": coordination at the edge, no rattlers", mean(z), 5.9, 6.1, "isostatic: 6 +- 0.1"},
      {law + ": exponent of the pressure", mean(exponents), power - 0.05, power + 0.05,
       "O'Hern 2003 +- 0.05"},
      {law + ": excess coordination / sqrt(excess fraction)", mean(slopes), 7.4, 8.4,
       "O'Hern 2003: 7.9 +- 0.5"}};
}

}  // namespace
}  // namespace packbed::validation

int main(int argc, char** argv) {
  using namespace packbed::validation;  // NOLINT
  Validation v;
  for (int seed = 1; seed <= hooke_seeds; ++seed) {
    v.pieces.push_back({piece_name(false, seed),
                        [seed] { return path(false, static_cast<std::uint64_t>(seed)); }});
  }
  for (int seed = 1; seed <= hertz_seeds; ++seed) {
    v.pieces.push_back(
        {piece_name(true, seed), [seed] { return path(true, static_cast<std::uint64_t>(seed)); }});
  }
  v.judge = [](const Results& results) {
    auto checks = judge_law(results, false);
    for (const auto& c : judge_law(results, true)) checks.push_back(c);
    return checks;
  };
  return validation_main(argc, argv, v);
}
