// SPDX-License-Identifier: BSD-3-Clause
// What the figures of a bed cost on one core: a column of 9.6 mm with grains of 0.15 to 0.43 mm at random
// places, 31 mm high per 100 000 grains. items_per_second counts beads.
#include <benchmark/benchmark.h>

#include "analysis/bed_height.hpp"
#include "analysis/overlap.hpp"
#include "analysis/profile.hpp"
#include "analysis/sections.hpp"
#include "analysis/void_sizes.hpp"
#include "core/random.hpp"

namespace {

using namespace packbed;
using namespace packbed::analysis;

constexpr double diameter = 9.6e-3;
const auto alone = Ranks::alone();

double height(std::int64_t count) { return 31e-3 * static_cast<double>(count) / 1e5; }

const std::vector<Bead>& column(std::int64_t count) {
  static std::vector<Bead> beads;
  if (static_cast<std::int64_t>(beads.size()) == count) return beads;
  beads.clear();
  for (std::uint64_t next = 0; static_cast<std::int64_t>(beads.size()) < count; next += 4) {
    const auto u = [&](std::uint64_t k) { return uniform(1, Stream::bead_position, next + k); };
    const Vec3 x{diameter * (u(0) - 0.5), diameter * (u(1) - 0.5), height(count) * u(2)};
    if (std::hypot(x.x, x.y) > 0.5 * diameter) continue;
    beads.push_back({x, 75e-6 + 140e-6 * u(3), static_cast<std::int64_t>(beads.size())});
  }
  return beads;
}

void per_bead(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void z_profile(benchmark::State& state) {
  const auto& beads = column(state.range(0));
  const mesh::Cylinder shape{diameter, height(state.range(0))};
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        bed_profile(beads, shape, Axis::z, {0.1e-3, {0.0, shape.height}}, alone));
  }
  per_bead(state);
  state.counters["bins_per_bead"] = 0.29 / 0.1 + 1.0;  // mean diameter / width + 1
}

void ring_profile(benchmark::State& state) {
  const auto& beads = column(state.range(0));
  const mesh::Cylinder shape{diameter, height(state.range(0))};
  const double width = 0.5 * diameter / static_cast<double>(state.range(1));
  for (auto _ : state) {
    benchmark::DoNotOptimize(wall_profile(beads, shape, {width, middle_half(shape.height)}, alone));
  }
  per_bead(state);
}

void figures(benchmark::State& state) {
  const auto& beads = column(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(bed_figures(beads, 7.2e-5, alone));
  per_bead(state);
}

void section_rows(benchmark::State& state) {
  const auto& beads = column(state.range(0));
  const auto reference = section_reference(beads, height(state.range(0)), {}, alone);
  for (auto _ : state) {
    benchmark::DoNotOptimize(sections(reference, beads, height(state.range(0)), 7.2e-5, alone));
  }
  per_bead(state);
}

void sphere_in_cylinder(benchmark::State& state) {
  double s = 4.65e-3;
  for (auto _ : state) {
    s = s < 4.9e-3 ? s + 1e-9 : 4.65e-3;
    benchmark::DoNotOptimize(volume_in_cylinder(0.15e-3, s, 4.8e-3));
  }
}

// items_per_second counts points.
void voids(benchmark::State& state) {
  const auto& beads = column(state.range(0));
  const mesh::Cylinder shape{diameter, height(state.range(0))};
  const VoidOptions options{.z = middle_half(shape.height), .points = 100000};
  for (auto _ : state) benchmark::DoNotOptimize(void_sizes(beads, shape, options).d50);
  state.SetItemsProcessed(state.iterations() * options.points);
}

BENCHMARK(z_profile)->Arg(16000)->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(ring_profile)
    ->Args({16000, 10})
    ->Args({1000000, 10})
    ->Args({1000000, 100})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(figures)->Arg(16000)->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(section_rows)->Arg(16000)->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(voids)->Arg(16000)->Arg(200000)->Unit(benchmark::kMillisecond);
BENCHMARK(sphere_in_cylinder);

}  // namespace

BENCHMARK_MAIN();
