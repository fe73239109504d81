// SPDX-License-Identifier: BSD-3-Clause
// Time per step of the liquid in a box of 10 x 10 x 70 mm; under mpiexec shared by its ranks.
//
//   fluid_steps [NX NY NZ [STEPS [PRESSURE_TOLERANCE [BED]]]]     21 28 60, 40, 1e-6, no bed
//
// The flow of compare_openfoam.sh: from rest, 1 mm/s from the top, steps of 1 ms, Crank-Nicolson 0.3, MUSCL,
// two correctors. With BED = 1 the lower half is a bed of 0.38 with drag. Medians are over the second half of the steps.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>

#include <fmt/format.h>

#include "core/ranks.hpp"
#include "fluid/fluid.hpp"

namespace {

using namespace packbed;  // NOLINT
using fluid::Bed;
using fluid::Fluid;

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const auto n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
double wall_time() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Bed bed_of(const Fluid& liquid, bool filled) {
  Bed bed;
  if (!filled) return bed;
  for (std::size_t c = 0; c < liquid.domain().own(); ++c) {
    const bool inside = liquid.domain().part.center[c].z < 35e-3;
    bed.eps.push_back(inside ? 0.38 : 1.0);
    // Kozeny and Carman, beads of 93 um.
    bed.exchange.push_back(inside ? 180.0 * 1e-3 * 0.62 * 0.62 / (0.38 * 93e-6 * 93e-6) : 0.0);
  }
  return bed;
}

}  // namespace

int main(int argc, char** argv) {
  const MpiSession session;
  const auto ranks = Ranks::all();
  const auto number = [&](int k, double otherwise) {
    return argc > k ? std::atof(argv[k]) : otherwise;
  };
  const mesh::CellCounts counts{.x = static_cast<std::int32_t>(number(1, 21)),
                                .y = static_cast<std::int32_t>(number(2, 28)),
                                .layers = static_cast<std::int32_t>(number(3, 60))};
  const int steps = static_cast<int>(number(4, 40));
  using enum mesh::Boundary;
  const mesh::ColumnMesh mesh(
      mesh::Box{.size = {0.01, 0.01, 0.07}, .boundaries = {wall, wall, wall}}, counts);
  fluid::FluidOptions options{.rho_f = 1000.0};
  options.boundaries.y_low = options.boundaries.y_high = fluid::Wall{};
  options.boundaries.inlet = fluid::Inlet{fluid::FlowProgram::steady(1e-3)};
  options.pressure_tolerance = number(5, 1e-6);
  options.momentum_tolerance = 1e-5;
  Fluid liquid(options, mesh, mesh::CellPartition(mesh.cell_count(), ranks.size()), ranks);
  const auto bed = bed_of(liquid, number(6, 0) > 0);
  liquid.start(bed, std::vector<Vec3>(liquid.domain().own(), Vec3{0, 0, -1e-3}), 0.0);
  std::vector<double> elapsed;
  std::vector<double> cpu;
  std::vector<double> iterations;
  fluid::StepReport report;
  for (int k = 0; k < steps; ++k) {
    static_cast<void>(ranks.max(0.0));  // all start together
    const double w = wall_time();
    const double c = processor_time();
    report = liquid.step(1e-3, bed);
    elapsed.push_back(ranks.max(wall_time() - w));
    cpu.push_back(ranks.max(processor_time() - c));
    double sum = 0.0;
    for (const auto& p : report.pressure) sum += p.iterations;
    iterations.push_back(sum);
  }
  if (!ranks.is_first()) return 0;
  const auto half = static_cast<std::ptrdiff_t>(steps / 2);
  const auto late = [&](const std::vector<double>& v) {
    return median({v.begin() + half, v.end()});
  };
  fmt::print(
      "{} cells {} ranks: {:.4f} s per step by wall time, {:.4f} by processor time (first step "
      "{:.3f}); pressure "
      "iterations per step: first {:.0f}, median {:.1f}; momentum {}; continuity error {:.2e}; "
      "Courant {:.3g}\n",
      mesh.cell_count(), ranks.size(), late(elapsed), late(cpu), elapsed.front(),
      iterations.front(), late(iterations), report.momentum.iterations, report.continuity_error,
      report.courant);
  return 0;
}
