// SPDX-License-Identifier: BSD-3-Clause
// Cases K4 to K6 of beads and liquid together: still water, the interval, fixed beds.
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "column/coupled_bed.hpp"
#include "core/random.hpp"
#include "tests/support/settling.hpp"

namespace packbed::column {
namespace {

using namespace test;  // NOLINT

constexpr double cm_h = 0.01 / 3600.0;

/// Beads of a box that is periodic across, on a cubic lattice, each displaced by up to a tenth of its spacing.
struct Lattice {
  mesh::Box box;
  dem::Dem dem;
};

Lattice lattice(int across, int layers, double spacing, double diameter, double room, bool fixed) {
  const double side = across * spacing;
  using enum mesh::Boundary;
  const mesh::Box box{.size = {side, side, layers * spacing + 2.0 * room},
                      .boundaries = {periodic, periodic, wall}};
  std::vector<dem::BeadStart> beads;
  for (int k = 0; k < across * across * layers; ++k) {
    const auto n = 3 * static_cast<std::uint64_t>(k);
    const auto shift = [&](std::uint64_t m) {
      return 0.2 * (uniform(3, Stream::bead_position, n + m) - 0.5);
    };
    auto b = bead(
        k,
        {(k % across + 0.5 + shift(0)) * spacing, (k / across % across + 0.5 + shift(1)) * spacing,
         room + (k / across / across + 0.5 + shift(2)) * spacing},
        {}, diameter);
    b.properties.fixed = fixed;
    b.properties.weight = mass_of(diameter, density_s - 998.2) * 9.81;
    beads.push_back(b);
  }
  auto o = options(hooke(0.5), 1e-7);
  o.overlap_limit = 0.9;
  o.domain = {.low = {0, 0, 0}, .size = {side, side, box.size[2]}, .periodic = {true, true, false}};
  return {box, dem::Dem(o, beads, {floor_at(0.0)})};
}

CoupledBed liquid_of(const mesh::Box& box, double cell, double reach) {
  const mesh::ColumnMesh mesh(box, mesh::cell_counts(box, {.cell = cell}));
  CoupledOptions o;
  o.fluid.boundaries.x_low = o.fluid.boundaries.x_high = fluid::Empty{};
  o.fluid.boundaries.y_low = o.fluid.boundaries.y_high = fluid::Empty{};
  o.coupling.widths = {.reach = reach, .reach_z = reach};
  return {mesh, box, o, Ranks::alone()};
}

// K4: in still water a bead feels nothing besides its buoyancy, which is in its weight, once.
TEST(CouplingCases, StillWaterPullsAtNoBead) {
  auto set = lattice(4, 8, 0.26e-3, 0.25e-3, 0.5e-3, true);
  auto bed = liquid_of(set.box, 0.25e-3, 0.5e-3);
  bed.start(set.dem);
  bed.set_flow(fluid::FlowProgram::steady(0.0));
  for (int k = 0; k < 5; ++k) bed.advance(set.dem, 100);
  const auto s = set.dem.snapshot();
  for (std::size_t i = 0; i < s.beads.size(); ++i) {
    const double buoyancy = mass_of(s.beads[i].diameter, 998.2) * 9.81;
    EXPECT_LT(norm(s.drag[i]), 1e-6 * buoyancy);
    EXPECT_NEAR(s.beads[i].weight, s.beads[i].mass * 9.81 - buoyancy, 1e-9 * buoyancy);
  }
  EXPECT_NEAR(bed.figures().pressure_drop, 0.0, 1e-9);
}

// K6: fixed beds, void fraction 0.38, 0.30, 0.22 (beads overlap): the law at the mean void fraction.
TEST(CouplingCases, FixedBedsHaveThePressureDropOfTheLaw) {
  for (const double eps : {0.38, 0.30, 0.22}) {
    const double spacing = 0.25e-3;
    const double d = spacing * std::cbrt(6.0 * (1.0 - eps) / std::numbers::pi);
    auto set = lattice(6, 14, spacing, d, 0.5e-3, true);
    auto bed = liquid_of(set.box, 0.25e-3, 3.0 * spacing);
    bed.start(set.dem);
    bed.set_flow(fluid::FlowProgram::steady(200 * cm_h));
    for (int k = 0; k < 10; ++k) bed.advance(set.dem, 500);
    const auto& mesh = bed.fluid().domain().mesh;
    const auto cells = static_cast<std::size_t>(mesh.cells_per_layer());
    const auto p = [&](std::size_t layer) {
      double sum = 0.0;
      for (std::size_t c = 0; c < cells; ++c) {
        sum += bed.fluid().dynamic_pressure()[layer * cells + c];
      }
      return sum / static_cast<double>(cells);
    };
    const auto low = static_cast<std::size_t>(mesh.layers()) / 2 - 2;
    const auto height =
        mesh.level(static_cast<std::int32_t>(low) + 4) - mesh.level(static_cast<std::int32_t>(low));
    const double re = 998.2 * d * 200 * cm_h / 1e-3;
    const double law =
        18e-3 * (1.0 - eps) * coupling::KochHill{}(1.0 - eps, re) * 200 * cm_h / (eps * d * d);
    EXPECT_NEAR((p(low + 4) - p(low)) / height / law, 1.0, 0.03) << eps;
  }
}

constexpr mesh::Slice slice{.inner_diameter = 2e-3, .depth = 0.7e-3, .height = 5e-3};

/// Mean height of the grains of a settled bed at the end of a ramp to 600 cm/h in 40 ms [m].
double height_after_ramp(const dem::DemState& state,
                         const dem::DemOptions& options,
                         double interval) {
  dem::Dem dem(options, state, dem::Dem::Lists::as_saved);
  dem.set_background_damping(0.0);
  dem.set_inertia_scale(25.0);
  const mesh::ColumnMesh mesh(slice, mesh::cell_counts(slice, {}));
  CoupledOptions o;
  o.coupling.widths = {.reach = 0.75e-3, .reach_z = 0.75e-3};
  CoupledBed bed(mesh, slice, o, Ranks::alone());
  bed.start(dem);
  const double time = 0.04;
  bed.set_flow(fluid::FlowProgram::through({{0.0, 0.0}, {time, 600 * cm_h}}));
  const double step = 5.0 * options.step;
  const auto count = static_cast<std::int64_t>(std::ceil(interval / step));
  dem.set_step(interval / static_cast<double>(count));
  for (int k = 0; k < std::lround(time / interval); ++k) bed.advance(dem, count);
  double sum = 0.0;
  const auto& p = dem.particles();
  for (std::size_t i = 0; i < p.size(); ++i) sum += p.motion[i].x.z;
  return sum / static_cast<double>(p.size());
}

// K5: with the interval the answer converges, in first order or better.
TEST(CouplingCases, ShorterIntervalsConverge) {
  auto s = cloud_of(300, 0.1);
  Settle settle(s.options, s.start);
  while (settle.advance(s.dem)) {}
  const auto state = s.dem.state();
  const auto options = s.dem.options();
  const double exact = height_after_ramp(state, options, 0.25e-3);
  std::array<double, 3> error{};
  for (std::size_t k = 0; k < error.size(); ++k) {
    error[k] = std::abs(height_after_ramp(state, options, 8e-3 / std::pow(2.0, k)) - exact);
  }
  EXPECT_GT(std::log2(error[0] / error[2]) / 2.0, 0.9)
      << error[0] << " " << error[1] << " " << error[2];
}

}  // namespace
}  // namespace packbed::column
