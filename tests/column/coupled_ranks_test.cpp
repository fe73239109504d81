// SPDX-License-Identifier: BSD-3-Clause
// A bed in a flow on several ranks against one alone. Run under mpiexec.
#include <cmath>
#include <cstdio>
#include <memory>

#include "column/coupled_bed.hpp"
#include "column/liquid_profiles.hpp"
#include "tests/support/liquid_of.hpp"
#include "tests/support/settling.hpp"

namespace packbed::column {
namespace {

using namespace test;  // NOLINT

constexpr mesh::Slice slice{.inner_diameter = 2e-3, .depth = 0.7e-3, .height = 5e-3};

/// 200 grains that fall through liquid flowing down: beads change their ranks on the way.
struct Column {
  dem::Dem dem;
  CoupledBed bed;

  Column(const std::shared_ptr<mesh::ColumnMesh>& mesh, const Ranks& ranks)
      : dem(make(mesh, ranks)), bed(*mesh, slice, options(), ranks) {
    dem.set_inertia_scale(100.0);
    dem.set_step(1e-5);
    bed.start(dem);
    bed.set_flow(fluid::FlowProgram::steady(500.0 * 0.01 / 3600.0));
  }

  static dem::Dem make(const std::shared_ptr<mesh::ColumnMesh>& mesh, const Ranks& ranks) {
    auto s = cloud_of(200, 0.1);
    auto o = s.dem.options();
    o.mesh = mesh;
    return {o, s.dem.state(), dem::Dem::Lists::anew, ranks};
  }

  static CoupledOptions options() {
    CoupledOptions o;
    o.coupling.widths = {.reach = 0.75e-3, .reach_z = 0.75e-3};
    return o;
  }
};

/// Profiles of equal fields are equal to the last bit.
bool has_equal_profiles(const Ranks& ranks) {
  const auto profiles = [](const mesh::ColumnShape& shape, const Ranks& of) {
    const auto fluid = liquid_of(
        shape, [](const Vec3& x) { return 0.4 + 30.0 * x.x + 20.0 * x.z; },
        [](const Vec3& x) { return 1.0 - 3e4 * x.x * x.y + x.z; }, of);
    auto bins = layer_profile(fluid);
    const auto across = cross_profile(fluid, shape, {0.2e-3, 0.9e-3});
    bins.insert(bins.end(), across.begin(), across.end());
    return bins;
  };
  bool equal = true;
  for (const mesh::ColumnShape& shape :
       {mesh::ColumnShape(slice), mesh::ColumnShape(mesh::Cylinder{2e-3, 2e-3})}) {
    equal = equal && profiles(shape, ranks) == profiles(shape, Ranks::alone());
  }
  return equal;
}

int check() {
  const auto mesh = std::make_shared<mesh::ColumnMesh>(slice, mesh::cell_counts(slice, {}));
  const auto ranks = Ranks::all();
  Column shared(mesh, ranks);
  Column alone(mesh, Ranks::alone());
  double worst = 0.0;
  for (int k = 0; k < 20; ++k) {
    shared.bed.advance(shared.dem, 100);
    alone.bed.advance(alone.dem, 100);
    const double a = shared.bed.figures().pressure_drop;
    const double b = alone.bed.figures().pressure_drop;
    worst = std::max(worst, std::abs(a - b) / std::abs(b));
  }
  const auto s = shared.dem.snapshot();
  const auto t = alone.dem.snapshot();
  for (std::size_t i = 0; i < s.x.size(); ++i)
    worst = std::max(worst, norm(s.x[i] - t.x[i]) / 1e-3);
  if (ranks.is_first()) {
    std::printf("%d ranks, %lld new shares: largest difference %.2g\n", ranks.size(),
                static_cast<long long>(shared.dem.repartitions()), worst);
  }
  if (!has_equal_profiles(ranks)) return 1;
  if (ranks.size() > 1 && shared.dem.repartitions() == 0) return 1;  // nothing was shared anew
  return worst < 1e-7 ? 0 : 1;  // tolerances of the solver, 1e-8, over 20 exchanges
}

}  // namespace
}  // namespace packbed::column

int main() {
  const packbed::MpiSession session;
  return packbed::column::check();
}
