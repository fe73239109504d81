// SPDX-License-Identifier: BSD-3-Clause
// I4: 1000 undamped, frictionless beads S in a periodic box keep their energy over 0.01 s, a million
// steps of 10 ns and some 250 collisions of each. Leapfrog is of second order and symplectic: no
// secular drift, and an amplitude that falls with the square of the step.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/random.hpp"
#include "tests/support/beads.hpp"
#include "validation/support/validation.hpp"

namespace packbed::validation {
namespace {

constexpr double duration = 1e-2;  // [s]
constexpr int looks = 1000;

struct Setting {
  const char* law;
  int step_ns;
};
constexpr Setting settings[] = {{"hooke", 20}, {"hooke", 10}, {"hooke", 5},
                                {"hertz", 20}, {"hertz", 10}, {"hertz", 5}};

std::vector<dem::BeadStart> cloud() {
  std::vector<dem::BeadStart> beads;
  const double pitch = 1.2 * test::diameter_s;
  for (int k = 0; k < 1000; ++k) {
    const auto u = [&](int n) {  // [-0.5, 0.5) m/s
      return uniform(5, Stream::bead_position, static_cast<std::uint64_t>(3 * k + n)) - 0.5;
    };
    const Vec3 x{(k % 10 + 0.5) * pitch, (k / 10 % 10 + 0.5) * pitch, (k / 100 + 0.5) * pitch};
    beads.push_back(test::bead(k, x, {u(0), u(1), u(2)}));
  }
  return beads;
}

/// Energy over that at the start, less 1.
Table energies(const Setting& setting) {
  dem::ContactLaw law = test::hooke(1.0);
  if (std::string(setting.law) == "hertz") law = dem::HertzMindlin{.restitution = 1.0};
  auto o = test::options(law, 1e-9 * setting.step_ns);
  const double side = 12.0 * test::diameter_s;
  o.domain = {.low = {}, .size = {side, side, side}, .periodic = {true, true, true}};
  dem::Dem dem(o, cloud(), {});
  const auto energy = [&] {
    const auto s = dem.snapshot();
    return s.kinetic_energy + s.elastic_energy;
  };
  const double start = energy();
  Table t{.columns = {"time_s", "energy_error"}, .rows = {{0.0, 0.0}}};
  const std::int64_t every = std::llround(duration / looks / o.step);
  for (int look = 0; look < looks; ++look) {
    dem.run(every);
    t.rows.push_back({dem.time(), energy() / start - 1.0});
  }
  return t;
}

std::string piece_name(const Setting& s) { return fmt::format("{}-{}ns", s.law, s.step_ns); }

/// Root mean square change from look to look: many collisions each, so that it hardly scatters.
double amplitude(const std::vector<double>& error) {
  double squares = 0.0;
  for (std::size_t k = 1; k < error.size(); ++k) squares += std::pow(error[k] - error[k - 1], 2);
  return std::sqrt(squares / static_cast<double>(error.size() - 1));
}

std::vector<Check> judge(const Results& results) {
  std::vector<Check> checks;
  for (const std::string law : {"hooke", "hertz"}) {
    const auto& million = results.at(law + "-10ns");
    const auto error = million.column("energy_error");
    double largest = 0.0;
    for (const double e : error) largest = std::max(largest, std::abs(e));
    const double drift = fit_line(million.column("time_s"), error).slope * duration;
    checks.push_back(
        {law + ": largest energy error of 1e6 steps", largest, 0.0, 1e-5, "verification case I4"});
    checks.push_back(
        {law + ": drift over 1e6 steps, fitted line", drift, -1e-5, 1e-5, "verification case I4"});
    const double coarse = amplitude(results.at(law + "-20ns").column("energy_error"));
    const double fine = amplitude(results.at(law + "-5ns").column("energy_error"));
    checks.push_back({law + ": power of the step in the amplitude", 0.5 * std::log2(coarse / fine),
                      1.8, 2.2, "leapfrog: 2"});
  }
  return checks;
}

}  // namespace
}  // namespace packbed::validation

int main(int argc, char** argv) {
  using namespace packbed::validation;  // NOLINT
  Validation v;
  for (const auto& s : settings) v.pieces.push_back({piece_name(s), [s] { return energies(s); }});
  v.judge = judge;
  return validation_main(argc, argv, v);
}
