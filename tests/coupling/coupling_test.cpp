// SPDX-License-Identifier: BSD-3-Clause
#include "coupling/coupling.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/random.hpp"
#include "tests/support/beads.hpp"

namespace packbed::coupling {
namespace {

using namespace test;  // NOLINT

double u(std::uint64_t n) { return uniform(11, Stream::bead_position, n); }

/// A column and beads of 0.2 to 0.3 mm in it that move, none touching another.
struct Set {
  mesh::ColumnShape shape;
  mesh::ColumnMesh mesh;
  dem::Dem dem;

  Set(const mesh::ColumnShape& s, const dem::Domain& domain, int count, double pitch)
      : shape(s), mesh(s, mesh::cell_counts(s, {})), dem(make(domain, count, pitch)) {
    dem.set_in_liquid(true);
  }

  dem::Dem make(const dem::Domain& domain, int count, double pitch) {
    std::vector<dem::BeadStart> beads;
    const auto low = mesh.locator().low();
    const auto high = mesh.locator().high();
    for (int k = 0, id = 0; id < count; ++k) {
      const int nx = static_cast<int>((high.x - low.x) / pitch);
      const int ny = static_cast<int>((high.y - low.y) / pitch);
      const Vec3 x{low.x + (k % nx + 0.5) * pitch, low.y + (k / nx % ny + 0.5) * pitch,
                   (k / nx / ny + 0.5) * pitch};
      if (x.z > mesh.top()) break;
      if (!mesh.cell_at(x)) continue;
      const auto n = 4 * static_cast<std::uint64_t>(id);
      beads.push_back(
          bead(id++, x, 1e-3 * Vec3{u(n), u(n + 1), -u(n + 2)}, (0.2 + 0.1 * u(n + 3)) * 1e-3));
    }
    auto o = options(hooke(0.5), 1e-5);
    o.domain = domain;
    return {o, beads, {}};
  }

  Coupling coupling(const CouplingOptions& o) {
    const mesh::CellPartition one(mesh.cell_count(), 1);
    return {mesh, shape, one, o, Ranks::alone()};
  }
};

CouplingOptions options_of(double reach, DragLaw law = KochHill{}) {
  return {.drag = law, .coarse_grain = 3.0, .widths = {.reach = reach, .reach_z = reach}};
}

// K1: beads and liquid give each other the same, drag and the share of the pressure gradient, to round-off.
void expect_equal_and_opposite(Set set, bool is_empty_y) {
  auto coupling = set.coupling(options_of(0.4e-3));
  std::vector<Vec3> velocity;
  std::vector<Vec3> grad_p;
  for (std::int64_t c = 0; c < set.mesh.cell_count(); ++c) {
    const auto n = 100000 + 6 * static_cast<std::uint64_t>(c);
    velocity.push_back(5e-3 * Vec3{u(n), is_empty_y ? 0.0 : u(n + 1), -u(n + 2)});
    grad_p.push_back(1e5 * Vec3{u(n + 3), is_empty_y ? 0.0 : u(n + 4), u(n + 5)});
  }
  coupling.set_velocity(velocity);
  set.dem.run(50);
  const auto bed = coupling.bed(set.dem, set.mesh, 50 * 1e-5);
  std::vector<Vec3> before;
  for (const auto& mark : set.dem.coupled_at()) before.push_back(mark.x);
  coupling.pull({velocity, grad_p}, set.dem);

  Vec3 on_liquid;
  double solid = 0.0;
  double size = 0.0;
  for (std::int64_t c = 0; c < set.mesh.cell_count(); ++c) {
    const auto k = static_cast<std::size_t>(c);
    const double v = set.mesh.volume(c);
    on_liquid +=
        v * (-bed.exchange[k] * (velocity[k] - bed.u_solid[k]) + (1.0 - bed.eps[k]) * grad_p[k]);
    solid += v * (1.0 - bed.eps[k]);
    size += v * bed.exchange[k] * norm(velocity[k] - bed.u_solid[k]);
  }
  Vec3 on_beads;
  double volume = 0.0;
  const auto& p = set.dem.particles();
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3 mean = (1.0 / (50 * 1e-5)) * (p.motion[i].x - before[i]);
    on_beads += set.dem.drag()[i].rate * (set.dem.drag()[i].target - mean);
    volume += mass_of(p.properties[i].diameter, 1.0);
    EXPECT_EQ(set.dem.coupled_at()[i].x, p.motion[i].x);
  }
  EXPECT_NEAR(solid, volume, 1e-12 * volume);  // V1
  EXPECT_NEAR(on_beads.x, -on_liquid.x, 1e-12 * size);
  EXPECT_NEAR(on_beads.z, -on_liquid.z, 1e-12 * size);
  if (!is_empty_y) {
    EXPECT_NEAR(on_beads.y, -on_liquid.y, 1e-12 * size);
  }
}

TEST(Coupling, GivesBeadsWhatItTakesFromTheLiquidInACylinder) {
  const mesh::Cylinder column{.inner_diameter = 3e-3, .height = 4e-3};
  expect_equal_and_opposite({column, {}, 600, 0.31e-3}, false);
}

TEST(Coupling, GivesBeadsWhatItTakesFromTheLiquidInASlice) {
  const mesh::Slice column{.inner_diameter = 4e-3, .depth = 0.93e-3, .height = 4e-3};
  expect_equal_and_opposite({column, {}, 400, 0.31e-3}, true);
}

// V1, K1 with merged overlaps: what two beads have in common counts once, and what they squeeze out comes into
// the liquid.
TEST(Coupling, CountsOverlapsOnceWhereTheyAreMerged) {
  const mesh::Slice column{.inner_diameter = 4e-3, .depth = 0.93e-3, .height = 4e-3};
  Set set(column, {}, 400, 0.26e-3);
  auto o = options_of(0.4e-3);
  o.overlap = OverlapRule::merged;
  auto coupling = set.coupling(o);
  const auto cells = static_cast<std::size_t>(set.mesh.cell_count());
  const std::vector<Vec3> velocity(cells, {0.0, 0.0, -5e-3});
  const std::vector<Vec3> grad_p(cells, {0.0, 0.0, 1e5});
  const auto sum = [](const std::vector<double>& a) {
    double s = 0.0;
    for (const double x : a) s += x;
    return s;
  };
  coupling.set_velocity(velocity);
  EXPECT_TRUE(coupling.bed(set.dem, set.mesh, 0.0).source.empty());
  coupling.pull({velocity, grad_p}, set.dem);
  const double before = sum(set.dem.lens_volumes());
  ASSERT_GT(before, 0.0);
  set.dem.scale_diameters(1.01);  // squeezes them
  const double after = sum(set.dem.lens_volumes());

  const double dt = 1e-3;
  const auto bed = coupling.bed(set.dem, set.mesh, dt);
  coupling.pull({velocity, grad_p}, set.dem);

  double solid = 0.0;
  double squeezed_out = 0.0;
  double on_liquid = 0.0;
  for (std::size_t c = 0; c < cells; ++c) {
    const double v = set.mesh.volume(static_cast<std::int64_t>(c));
    solid += v * (1.0 - bed.eps[c]);
    squeezed_out += v * dt * bed.source[c];
    on_liquid += v * (-bed.exchange[c] * (velocity[c].z - bed.u_solid[c].z) +
                      (1.0 - bed.eps[c]) * grad_p[c].z);
  }
  double volume = 0.0;
  double on_beads = 0.0;
  const auto& p = set.dem.particles();
  for (std::size_t i = 0; i < p.size(); ++i) {
    volume += mass_of(p.properties[i].diameter, 1.0);
    on_beads += set.dem.drag()[i].rate * set.dem.drag()[i].target.z;  // beads did not move
  }
  EXPECT_NEAR(solid, volume - after, 1e-12 * volume);
  EXPECT_NEAR(squeezed_out, after - before, 1e-12 * after);
  EXPECT_NEAR(on_beads, -on_liquid, 1e-11 * std::abs(on_beads));
}

/// Equal beads of 0.25 mm on a lattice in a periodic box of 3 mm, `n` along a side.
Set suspension(int n) {
  using enum mesh::Boundary;
  const mesh::Box box{.size = {3e-3, 3e-3, 3e-3}, .boundaries = {periodic, periodic, periodic}};
  Set set(box, {.low = {0, 0, 0}, .size = {3e-3, 3e-3, 3e-3}, .periodic = {true, true, true}}, 0,
          1e-3);
  std::vector<dem::BeadStart> beads;
  for (int k = 0; k < n * n * n; ++k) {
    const Vec3 x{(k % n + 0.5) * 3e-3 / n, (k / n % n + 0.5) * 3e-3 / n,
                 (k / n / n + 0.5) * 3e-3 / n};
    auto start = bead(k, x, {}, 0.25e-3);
    start.properties.weight = mass_of(0.25e-3, 140.0) * 9.81;
    beads.push_back(start);
  }
  set.dem = dem::Dem(set.dem.options(), beads, {});
  set.dem.set_in_liquid(true);
  return set;
}

// D6: a suspension in a closed box settles at v_0 / F_0, whatever the interval. The liquid, without inertia:
// eps u = -(1 - eps) v, grad p = -B (u - v) / eps.
TEST(Coupling, LetsASuspensionSettleAtTheHinderedSpeed) {
  auto set = suspension(9);
  auto coupling = set.coupling(options_of(1.2e-3));
  const double interval = 2e-3;
  set.dem.set_step(interval / 20);
  double speed = 0.0;
  double phi = 0.0;
  BedFields bed = coupling.bed(set.dem, set.mesh, 0.0);
  for (int k = 0; k < 200; ++k) {
    std::vector<Vec3> velocity;
    std::vector<Vec3> grad_p;
    for (std::size_t c = 0; c < bed.eps.size(); ++c) {
      velocity.push_back(-((1.0 - bed.eps[c]) / bed.eps[c]) * bed.u_solid[c]);
      grad_p.push_back(-(bed.exchange[c] / bed.eps[c]) * (velocity[c] - bed.u_solid[c]));
    }
    coupling.pull({velocity, grad_p}, set.dem);
    set.dem.run(20);
    bed = coupling.bed(set.dem, set.mesh, interval);
    speed = -bed.u_solid[0].z;
    phi = 1.0 - bed.eps[0];
  }
  EXPECT_NEAR(phi, 729 * mass_of(0.25e-3, 1.0) / 27e-9, 2e-3 * phi);
  const double weight = mass_of(0.25e-3, 140.0) * 9.81;
  const double d = 0.25e-3 / 3.0;  // of the beads that a grain stands for
  const double stokes = weight / (27.0 * 3.0 * std::numbers::pi * 1e-3 * d);
  EXPECT_NEAR(speed, stokes / KochHill::f0(phi), 1e-3 * speed);
}

// D10: a law that sees no void fraction below 0.40 gives 0.844 of the right drag at 0.36.
TEST(Coupling, GivesTooLittleDragWithTheClampOfTheThesis) {
  auto set = suspension(11);
  auto free = options_of(1.2e-3);
  auto clamped = free;
  const double phi = 1331 * mass_of(0.25e-3, 1.0) / 27e-9;
  clamped.min_void_fraction = 1.0 - phi + 0.04;
  const auto right = set.coupling(free).bed(set.dem, set.mesh, 0.0);
  const auto less = set.coupling(clamped).bed(set.dem, set.mesh, 0.0);
  const double eps = 1.0 - phi;
  const auto f = [](double e) { return e * KochHill{}(1.0 - e, 0.0); };
  EXPECT_NEAR(less.exchange[0] / right.exchange[0], f(eps + 0.04) / f(eps), 1e-2);
  EXPECT_NEAR(0.4 * KochHill{}(0.6, 0.0) / (0.36 * KochHill{}(0.64, 0.0)), 0.844, 5e-4);
}

TEST(Coupling, StopsWhereBeadsFillACell) {
  const mesh::Slice column{.inner_diameter = 4e-3, .depth = 0.9e-3, .height = 4e-3};
  Set set(column, {}, 0, 1e-3);
  std::vector<dem::BeadStart> beads;
  for (int k = 0; k < 60; ++k) beads.push_back(bead(k, {0.02e-3 * k, 0, 2e-3}, {}, 0.3e-3));
  auto o = set.dem.options();
  o.overlap_limit = 10.0;
  set.dem = dem::Dem(o, beads, {});
  set.dem.set_in_liquid(true);
  auto coupling = set.coupling(options_of(0.2e-3));
  EXPECT_THROW(coupling.bed(set.dem, set.mesh, 0.0), DivergenceError);
}

}  // namespace
}  // namespace packbed::coupling
