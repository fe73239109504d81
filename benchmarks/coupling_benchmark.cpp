// SPDX-License-Identifier: BSD-3-Clause
// What an exchange of beads and liquid costs on one core: grains of 0.12 to 0.30 mm at random places, as many per volume
// as a bed of coarse grain 3 has, averaged over 0.79 mm. items_per_second counts grains.
#include <benchmark/benchmark.h>

#include "core/random.hpp"
#include "coupling/coupling.hpp"

namespace {

using namespace packbed;

constexpr double height = 31e-3;
constexpr double grains_per_m3 = 5.74e10;
constexpr double interval = 5e-3;

struct Column {
  mesh::ColumnShape shape;
  dem::Domain domain;
  double cross_section;  ///< [m2]
};

const Column slice{mesh::Slice{.inner_diameter = 10e-3, .depth = 0.9e-3, .height = height},
                   {.size = {10e-3, 0.9e-3, height}, .periodic = {false, true, false}},
                   10e-3 * 0.9e-3};
const Column cylinder{mesh::Cylinder{.inner_diameter = 10e-3, .height = height}, {}, 78.5e-6};

double u(std::uint64_t n) { return uniform(1, Stream::bead_position, n); }

dem::Dem grains_in(const Column& column, const mesh::ColumnMesh& mesh) {
  const auto count = static_cast<std::int64_t>(grains_per_m3 * column.cross_section * height);
  const auto low = mesh.locator().low();
  const auto high = mesh.locator().high();
  std::vector<dem::BeadStart> beads;
  for (std::uint64_t n = 0; static_cast<std::int64_t>(beads.size()) < count; n += 4) {
    const Vec3 x{low.x + u(n) * (high.x - low.x), low.y + u(n + 1) * (high.y - low.y),
                 u(n + 2) * height};
    if (!mesh.cell_at(x)) continue;
    dem::BeadStart bead;
    bead.properties.id = static_cast<std::int64_t>(beads.size());
    bead.properties.diameter = 120e-6 + 180e-6 * u(n + 3);
    bead.properties.mass = 1e-8;
    bead.properties.material = {.youngs_modulus = 30e6, .poisson_ratio = 0.2};
    bead.x = x;
    beads.push_back(bead);
  }
  dem::DemOptions options;
  options.domain = column.domain;
  options.step = 1e-6;
  options.overlap_limit = 10.0;  // they lie in each other
  dem::Dem dem(options, beads, {});
  dem.set_in_liquid(true);
  return dem;
}

struct Set {
  explicit Set(const Column& column)
      : mesh(column.shape, mesh::cell_counts(column.shape, {})),
        dem(grains_in(column, mesh)),
        coupling(mesh,
                 column.shape,
                 mesh::CellPartition(mesh.cell_count(), 1),
                 {.coarse_grain = 3.0, .widths = {.reach = 0.79e-3, .reach_z = 0.79e-3}},
                 Ranks::alone()),
        velocity(static_cast<std::size_t>(mesh.cell_count()), {0.0, 0.0, -0.02}),
        grad_p(velocity.size(), {0.0, 0.0, 3e6}) {}
  mesh::ColumnMesh mesh;
  dem::Dem dem;
  coupling::Coupling coupling;
  std::vector<Vec3> velocity;
  std::vector<Vec3> grad_p;
};

void bed(benchmark::State& state, const Column& column) {
  Set set(column);
  for (auto _ : state) benchmark::DoNotOptimize(set.coupling.bed(set.dem, set.mesh, interval));
  state.SetItemsProcessed(state.iterations() * set.dem.bead_count());
}

void pull(benchmark::State& state, const Column& column) {
  Set set(column);
  (void)set.coupling.bed(set.dem, set.mesh, interval);
  for (auto _ : state) set.coupling.pull({set.velocity, set.grad_p}, set.dem);
  state.SetItemsProcessed(state.iterations() * set.dem.bead_count());
}

BENCHMARK_CAPTURE(bed, slice, slice)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(bed, cylinder, cylinder)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pull, slice, slice)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pull, cylinder, cylinder)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
