// SPDX-License-Identifier: BSD-3-Clause
// Particle-steps per second of bead mechanics on one core: whole steps, and the stages of a step and
// of a renewal. items_per_second counts beads. docs/performance.md says how to run it.
#include <map>
#include <memory>
#include <numeric>

#include <benchmark/benchmark.h>

#include "benchmarks/beds.hpp"
#include "dem/neighbors.hpp"

namespace {

using namespace packbed;

struct Case {
  std::string bed;
  double step;          // [s]; 2e-6 s is above the stable step: the bed boils
  std::int64_t settle;  // steps that build up the springs
  std::int64_t steps;   // that one iteration times
};

const benchmarks::Bed& bed_of(const std::string& name) {
  static std::map<std::string, benchmarks::Bed> beds;
  if (!beds.contains(name)) beds[name] = benchmarks::packed_bed(name);
  return beds[name];
}

dem::Dem& ready(const Case& c) {
  static std::map<std::pair<std::string, double>, std::unique_ptr<dem::Dem>> dems;
  auto& dem = dems[{c.bed, c.step}];
  if (!dem) {
    dem = std::make_unique<dem::Dem>(benchmarks::make_dem(bed_of(c.bed), c.step));
    dem->run(c.settle);
  }
  return *dem;
}

void count_beads(benchmark::State& state, const dem::Dem& dem, std::int64_t steps = 1) {
  const auto beads = static_cast<std::int64_t>(dem.particles().size());
  state.SetItemsProcessed(state.iterations() * steps * beads);
}

void whole_steps(benchmark::State& state, const Case& c) {
  auto& dem = ready(c);
  const auto renewals = dem.renewals();
  for (auto _ : state) dem.run(c.steps);
  count_beads(state, dem, c.steps);
  const auto beads = static_cast<double>(dem.particles().size());
  const auto steps = static_cast<double>(state.iterations() * c.steps);
  state.counters["listed"] = static_cast<double>(dem.contacts().size()) / beads;
  state.counters["touching"] = 0.5 * dem.snapshot().coordination_number;
  state.counters["renewals_per_1000"] =
      1e3 * static_cast<double>(dem.renewals() - renewals) / steps;
}

const dem::ContactModel model{
    .contact = dem::Hooke{.characteristic_velocity = 0.1, .restitution = 0.5},
    .rolling = dem::ElasticPlastic{0.35},
    .friction = 0.1};

void contact_forces(benchmark::State& state, const Case& c, const dem::ContactModel& laws) {
  const auto& dem = ready(c);
  auto contacts = dem.contacts();
  auto particles = dem.particles();
  for (auto _ : state) dem::add_contact_forces(laws, contacts, particles, c.step);
  count_beads(state, dem);
}

void wall_forces(benchmark::State& state, const Case& c) {
  auto& dem = ready(c);
  auto contacts = dem.wall_contacts()[0];
  auto particles = dem.particles();
  for (auto _ : state) {
    dem::add_wall_forces(model, dem.walls()[0], contacts, particles, c.step);
  }
  count_beads(state, dem);
}

constexpr double skin = 20e-6;   // [m]
constexpr double cell = 428e-6;  // [m]

void order_beads(benchmark::State& state, const Case& c) {
  const auto& dem = ready(c);
  const auto domain = benchmarks::domain_of(bed_of(c.bed));
  for (auto _ : state) {
    benchmark::DoNotOptimize(dem::key_order(dem.particles(), domain, cell));
  }
  count_beads(state, dem);
}

void search_pairs(benchmark::State& state, const Case& c) {
  const auto& dem = ready(c);
  const auto domain = benchmarks::domain_of(bed_of(c.bed));
  std::size_t pairs = 0;
  for (auto _ : state) pairs = dem::find_pairs(dem.particles(), domain, skin).size();
  count_beads(state, dem);
  state.counters["pairs"] = static_cast<double>(pairs);
}

void add(const std::string& name, auto function, auto... arguments) {
  benchmark::RegisterBenchmark(name.c_str(), function, arguments...)
      ->Unit(benchmark::kMillisecond)
      ->MinTime(0.3);
}

void add_all() {
  const Case b2k{"b2k", 1e-6, 6000, 400};
  const Case boiling{"b18k", 2e-6, 1000, 500};
  const std::vector<Case> cases = {b2k,
                                   {"b18k", 1e-6, 6000, 100},
                                   {"s18k", 1e-6, 6000, 100},
                                   {"equal20k", 1e-6, 1000, 100},
                                   {"wide20k", 5e-7, 1000, 100},
                                   {"b223k", 1e-6, 1000, 20},
                                   {"b1m", 1e-6, 500, 10}};
  for (const auto& c : cases) add("step/" + c.bed, whole_steps, c);
  add("step_boiling/b18k", whole_steps, boiling);
  for (const auto& c : cases) {
    add("contacts/" + c.bed, contact_forces, c, model);
    add("walls/" + c.bed, wall_forces, c);
    add("order/" + c.bed, order_beads, c);
    add("pairs/" + c.bed, search_pairs, c);
  }
  const std::map<std::string, dem::ContactLaw> contact_laws = {
      {"hooke", model.contact},
      {"hertz", dem::HertzMindlin{.restitution = 0.5}},
      {"viscous", dem::ViscousHooke{.characteristic_velocity = 0.1,
                                    .restitution_max = 0.9,
                                    .critical_stokes = 10.0,
                                    .viscosity = 1e-3}}};
  const std::map<std::string, dem::RollingLaw> rolling_laws = {{"none", dem::NoRolling{}},
                                                               {"cdt", dem::ConstantTorque{0.35}},
                                                               {"epsd", dem::ElasticPlastic{0.35}}};
  for (const auto& [contact_name, contact] : contact_laws) {
    for (const auto& [rolling_name, rolling] : rolling_laws) {
      add("laws/" + contact_name + "+" + rolling_name, contact_forces, b2k,
          dem::ContactModel{.contact = contact, .rolling = rolling, .friction = 0.1});
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  add_all();
  benchmark::RunSpecifiedBenchmarks();
}
