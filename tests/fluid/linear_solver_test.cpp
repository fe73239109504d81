// SPDX-License-Identifier: BSD-3-Clause
// A preconditioner depends on its matrix alone: a run that is resumed makes the same one as the first run did.
#include "fluid/linear_solver.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "fluid/border.hpp"
#include "fluid/pressure.hpp"
#include "mesh/cell_counts.hpp"

namespace packbed::fluid {
namespace {

std::vector<double> noise(std::size_t n, std::uint64_t seed) {
  std::vector<double> values(n);
  for (std::size_t k = 0; k < n; ++k) values[k] = 0.5 + uniform(seed, Stream::bead_size, k);
  return values;
}

TEST(LinearSolver, MakesTheSamePreconditionerWhateverItMadeBefore) {
  const mesh::Slice slice{.inner_diameter = 4e-3, .depth = 0.7e-3, .height = 12e-3};
  const mesh::ColumnMesh mesh(slice, mesh::cell_counts(slice, {}));
  const mesh::CellPartition partition(mesh.cell_count(), 1);
  const Domain domain(mesh, partition, Ranks::alone());
  const auto border = fluid::border(Boundaries{}, domain);
  const auto rhs = noise(domain.own(), 1);
  const auto solved = [&](LinearSolver& solver, std::uint64_t seed) {
    const auto conductance = noise(domain.faces(), seed);
    solver.set_matrix(pressure_matrix(domain, border, conductance));
    solver.build_preconditioner();
    std::vector<double> x(domain.own(), 0.0);
    solver.solve(rhs, x, 1e-6, 200, "a test");
    return x;
  };
  LinearSolver fresh(domain, Method::multigrid, false);
  LinearSolver used(domain, Method::multigrid, false);
  for (std::uint64_t seed = 2; seed < 6; ++seed) solved(used, seed);
  EXPECT_EQ(solved(fresh, 7), solved(used, 7));
}

}  // namespace
}  // namespace packbed::fluid
