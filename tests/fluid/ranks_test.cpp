// SPDX-License-Identifier: BSD-3-Clause
// The same liquid on any number of ranks, to the tolerance of the solver; the same bits from run to run and after a
// restart on the same ranks. Run under mpiexec; every rank also runs the column alone.
#include <cstdio>
#include <cstring>

#include "tests/support/fluid.hpp"

namespace packbed::fluid {
namespace {

using namespace test;  // NOLINT

mesh::ColumnMesh column() {
  return {mesh::Cylinder{.inner_diameter = 4e-3, .height = 6e-3},
          {.core = 6, .ring = 3, .layers = 12}};
}

FluidOptions options_of_column() {
  FluidOptions o;
  o.pressure_tolerance = 1e-12;
  o.momentum_tolerance = 1e-12;
  o.boundaries.inlet = Inlet{FlowProgram::through({{0.0, 0.0}, {0.02, 2e-3}})};
  return o;
}

/// A bed below z = 3 mm, denser where x > 0, whose beads move down.
Bed bed_of(const Fluid& fluid) {
  Bed bed;
  for (std::size_t c = 0; c < fluid.domain().own(); ++c) {
    const auto& x = fluid.domain().part.center[c];
    const bool inside = x.z < 3e-3;
    const double eps = inside ? 0.40 + 20.0 * x.x : 1.0;
    bed.eps.push_back(eps);
    bed.exchange.push_back(inside ? 1e7 * (1 - eps) : 0.0);
    bed.u_solid.push_back({0, 0, inside ? -1e-4 : 0.0});
    bed.source.push_back(inside ? 1e-3 : 0.0);
  }
  return bed;
}

constexpr double dt = 1e-3;

void advance(Fluid& fluid, int first, int last) {
  for (int k = first; k < last; ++k) fluid.step(dt, bed_of(fluid), 6e-3 - 1e-5 * (k + 1));
}

bool fail(const Ranks& ranks, const char* what, double value) {
  if (ranks.is_first()) std::fprintf(stderr, "%s: %g\n", what, value);
  return false;
}

/// Largest difference over the largest value, of all ranks.
double difference(const Fluid& shared, const Fluid& alone, const Ranks& ranks) {
  const auto first = static_cast<std::size_t>(shared.domain().part.cell.front());
  std::array<double, 4> m{};
  for (std::size_t c = 0; c < shared.domain().own(); ++c) {
    m[0] = std::max(m[0], norm(shared.u()[c] - alone.u()[first + c]));
    m[1] = std::max(m[1], norm(alone.u()[first + c]));
    m[2] = std::max(m[2],
                    std::abs(shared.dynamic_pressure()[c] - alone.dynamic_pressure()[first + c]));
    m[3] = std::max(m[3], std::abs(alone.dynamic_pressure()[first + c]));
  }
  ranks.max(m);
  return std::max(m[0] / m[1], m[2] / m[3]);
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

bool same_bits(const Fluid& a, const Fluid& b, const Ranks& ranks) {
  const bool same = same_bits(a.u(), b.u()) &&
                    same_bits(a.dynamic_pressure(), b.dynamic_pressure()) &&
                    same_bits(a.q(), b.q()) && same_bits(a.border_pressure(), b.border_pressure());
  return ranks.max(same ? 0.0 : 1.0) == 0.0;
}

/// What all ranks saved.
FluidState joined(const FluidState& own, const Ranks& ranks) {
  FluidState all = own;
  const auto n = static_cast<std::size_t>(ranks.size());
  all.cells.clear();
  all.faces.clear();
  for (const auto& part : ranks.exchange(std::vector(n, own.cells))) {
    all.cells.insert(all.cells.end(), part.begin(), part.end());
  }
  for (const auto& part : ranks.exchange(std::vector(n, own.faces))) {
    all.faces.insert(all.faces.end(), part.begin(), part.end());
  }
  return all;
}

bool passes(const Ranks& ranks) {
  const auto mesh = column();
  const auto options = options_of_column();
  const mesh::CellPartition equal(mesh.cell_count(), ranks.size());
  Fluid shared(options, mesh, equal, ranks);
  Fluid again(options, mesh, equal, ranks);
  auto alone = make_fluid(options, mesh);
  for (auto* fluid : {&shared, &again, &alone}) advance(*fluid, 0, 12);
  if (!same_bits(shared, again, ranks)) return fail(ranks, "two runs differ", 0);
  // 1e-9: residuals are below 1e-12 of what passes the cells, and a bed sums a few hundred of them.
  const double first = difference(shared, alone, ranks);
  if (!(first < 1e-9)) return fail(ranks, "differs from one rank by", first);

  const auto saved = joined(shared.save(), ranks);
  Fluid resumed(options, mesh, equal, ranks);
  resumed.load(saved);
  advance(shared, 12, 20);
  advance(resumed, 12, 20);
  if (!same_bits(shared, resumed, ranks)) return fail(ranks, "a restart changed bits", 0);

  auto other = equal;
  std::vector<std::int64_t> weights;
  for (std::int64_t c = 0; c < mesh.cell_count(); ++c)
    weights.push_back(c < mesh.cell_count() / 2 ? 3 : 1);
  other.cut(weights);
  again.repartition(equal, other);
  advance(again, 12, 20);
  advance(alone, 12, 20);
  const double second = difference(again, alone, ranks);
  if (!(second < 1e-9)) return fail(ranks, "after a new partition differs by", second);
  if (ranks.is_first()) std::printf("differences from one rank %.2e, %.2e\n", first, second);
  return true;
}

}  // namespace
}  // namespace packbed::fluid

int main() {
  const packbed::MpiSession session;
  return packbed::fluid::passes(packbed::Ranks::all()) ? 0 : 1;
}
