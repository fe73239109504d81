// SPDX-License-Identifier: BSD-3-Clause
// Pieces of the solver by themselves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "fluid/flow_program.hpp"
#include "fluid/gradient.hpp"
#include "fluid/interpolation.hpp"
#include "fluid/linear_solver.hpp"
#include "fluid/time_scheme.hpp"
#include "tests/support/fluid.hpp"
#include "tests/support/message_of.hpp"

namespace packbed::fluid {
namespace {

using namespace test;  // NOLINT
using ::testing::HasSubstr;

TEST(FlowProgram, HasStepsAndRamps) {
  const auto program = FlowProgram::through({{1.0, 0.0}, {2.0, 4.0}, {3.0, 4.0}, {3.0, 1.0}});
  for (const auto& [t, v] :
       {std::pair{0.0, 0.0}, {1.5, 2.0}, {2.5, 4.0}, {2.999999, 4.0}, {3.0, 1.0}, {9.0, 1.0}}) {
    EXPECT_DOUBLE_EQ(program.at(t), v) << t;
  }
  EXPECT_EQ(FlowProgram().at(1.0), 0.0);
}

TEST(FlowProgram, RefusesDisorder) {
  EXPECT_THAT(message_of([] {
                FlowProgram::through({{1.0, 0.0}, {0.5, 1.0}});
              }),
              HasSubstr("point 2 of the flow program is at 0.5 s, before the one at 1 s"));
  EXPECT_THAT(message_of([] {
                FlowProgram::through({{1, 0}, {1, 1}, {1, 2}});
              }),
              HasSubstr("a step needs two"));
}

TEST(DragWeight, GivesTheExponential) {
  for (const double z : {1e-6, 1e-3, 0.049, 0.051, 1.0, 30.0}) {
    const double w = drag_weight(z, 0.5);
    EXPECT_NEAR((1.0 - (1.0 - w) * z) / (1.0 + w * z), std::exp(-z), 1e-12) << z;
  }
  EXPECT_EQ(drag_weight(1.0, 1.0), 1.0);
  EXPECT_NEAR(drag_weight(1e9, 0.5), 1.0, 1e-8);
}

TEST(LimitedValue, IsCentralWhereSmoothAndUpwindAtExtremes) {
  EXPECT_DOUBLE_EQ(limited_value(1.0, 2.0, 1.0, 0.5), 1.5);   // linear: r = 1
  EXPECT_DOUBLE_EQ(limited_value(1.0, 2.0, 0.0, 0.5), 1.0);   // r = -1: an extreme at C
  EXPECT_DOUBLE_EQ(limited_value(1.0, 2.0, 10.0, 0.5), 2.0);  // r = 19: downwind at most
  EXPECT_DOUBLE_EQ(limited_value(1.0, 1.0, 0.3, 0.5), 1.0);
}

/// Velocities of cells from fluxes of a linear field, and its gradient, on the five blocks.
TEST(Reconstruct, IsExactForLinearFields) {
  const mesh::ColumnMesh mesh(mesh::Cylinder{.inner_diameter = 2.0, .height = 2.0},
                              {.core = 4, .ring = 3, .layers = 4});
  Domain domain(mesh, mesh::CellPartition(mesh.cell_count(), 1), Ranks::alone());
  const Tensor slope{{1, 2, -1}, {0.5, -3, 2}, {1, 1, 2}};
  const auto value = [&](const Vec3& x) { return Vec3{1, -2, 3} + slope * x; };
  std::vector<Vec3> u;
  std::vector<Vec3> at_border;
  std::vector<double> q;
  for (const auto& x : domain.part.center) u.push_back(value(x));
  for (std::size_t f = 0; f < domain.faces(); ++f) {
    const auto v = value(domain.part.face_center[f]);
    q.push_back(dot(v, domain.geometry.normal[f]));
    if (f >= domain.inner()) at_border.push_back(v);
  }

  const auto grad = gradient(domain, u, at_border);
  const auto back = reconstruct(domain, q, grad);
  const auto pattern = unseen(domain, q, u, grad);

  for (std::size_t c = 0; c < u.size(); ++c) {
    EXPECT_LT(norm(grad[c].y - slope.y), 1e-12);
    EXPECT_LT(norm(back[c] - u[c]), 1e-12);
  }
  for (const double p : pattern) EXPECT_NEAR(p, 0.0, 1e-12);
}

/// Poisson's equation on a box, 0 at the lower end.
struct Poisson {
  Domain domain;
  FaceMatrix matrix;
  std::vector<double> b, x;
};
Poisson poisson() {
  const BoxCase box{{1, 1, 1}, {6, 6, 6}};
  const auto mesh = box.mesh();
  Poisson p{Domain(mesh, mesh::CellPartition(mesh.cell_count(), 1), Ranks::alone()), {}, {}, {}};
  p.matrix.diagonal.assign(216, 0.0);
  p.matrix.upper.assign(p.domain.inner(), -1.0);
  for (std::size_t f = 0; f < p.domain.inner(); ++f) {
    p.matrix.diagonal[p.domain.owner(f)] += 1.0;
    p.matrix.diagonal[p.domain.neighbor(f)] += 1.0;
  }
  for (std::size_t c = 0; c < 36; ++c) p.matrix.diagonal[c] += 2.0;
  for (int c = 0; c < 216; ++c) p.b.push_back(std::sin(c));
  p.x.assign(216, 0.0);
  return p;
}

TEST(LinearSolver, ReportsTheTrueResidual) {
  for (const auto method : {Method::multigrid, Method::diagonal}) {
    auto p = poisson();
    LinearSolver solver(p.domain, method, false);
    solver.set_matrix(p.matrix);

    const auto report = solver.solve(p.b, p.x, 1e-6, 500, "a test");

    double square = 0.0;
    for (const double r : residual(p.domain, p.matrix, p.x, p.b)) square += r * r;
    EXPECT_LE(report.last_residual, 1e-6);
    EXPECT_NEAR(std::sqrt(square), report.last_residual, 1e-3 * report.last_residual);
    EXPECT_EQ(report.rebuilt, 0);
  }
}

TEST(LinearSolver, StallsAreTriedAgainThenToldWithTheirHistory) {
  auto p = poisson();
  LinearSolver solver(p.domain, Method::multigrid, false);
  solver.set_matrix(p.matrix);
  // The preconditioner of this matrix does not serve one that is another altogether, within two iterations.
  solver.build_preconditioner();
  for (std::size_t f = 0; f < p.matrix.upper.size(); ++f) {
    const double more = f % 2 == 0 ? 1e4 : 0.0;
    p.matrix.upper[f] -= more;
    p.matrix.diagonal[p.domain.owner(f)] += more;
    p.matrix.diagonal[p.domain.neighbor(f)] += more;
  }
  solver.set_matrix(p.matrix);
  auto x = p.x;
  EXPECT_GT(solver.solve(p.b, x, 1e-7, 12, "a test").rebuilt, 0);

  const auto told = message_of([&] { solver.solve(p.b, p.x, 1e-12, 1, "the pressure"); });
  EXPECT_THAT(told, HasSubstr("the solve for the pressure does not reach a residual of 1.000e-12"));
  EXPECT_THAT(told, HasSubstr("preconditioner kept: 1 iterations from "));
  EXPECT_THAT(told, HasSubstr("; preconditioner made anew: "));
  EXPECT_THAT(told, HasSubstr("; plain: "));
}

}  // namespace
}  // namespace packbed::fluid
