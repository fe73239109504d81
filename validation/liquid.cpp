// SPDX-License-Identifier: BSD-3-Clause
// F2, F4: orders of the liquid on the five-block cylinder, over three halvings.
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "tests/support/fluid.hpp"
#include "tests/support/manufactured.hpp"
#include "validation/support/validation.hpp"

namespace packbed::validation {
namespace {

using namespace test;  // NOLINT

/// Cells along a side of the middle block.
constexpr std::array<int, 4> sizes = {4, 8, 16, 32};

Table manufactured(int n) {
  const mesh::ColumnMesh mesh(mesh::Cylinder{.inner_diameter = 1e-3, .height = 1e-3},
                              {.core = n, .ring = n / 2, .layers = 2 * n});
  // Steps fall with the square of the spacing: what is seen is the order in space.
  const auto e = manufactured_errors(manufactured_cylinder(0.5e-3), mesh, 1e-3, n * n / 16);
  return {.columns = {"spacing", "velocity", "pressure"}, .rows = {{1.0 / n, e.u, e.p}}};
}

/// Axial velocity of developed flow in the lower third of a pipe of three diameters.
Table pipe(int n) {
  const double radius = 0.5e-3;
  const double mean_velocity = 1e-3;
  const mesh::ColumnMesh mesh(mesh::Cylinder{.inner_diameter = 2 * radius, .height = 6 * radius},
                              {.core = n, .ring = n / 2, .layers = 12});
  fluid::FluidOptions o{.rho_f = 1000.0, .mu_f = 1e-3, .gravity = {}};
  o.crank_nicolson = 0.0;
  o.pressure_tolerance = 1e-7;
  o.momentum_tolerance = 1e-7;
  o.boundaries.inlet = fluid::Inlet{fluid::FlowProgram::steady(mean_velocity)};
  auto liquid = make_fluid(o, mesh);
  // 0.25 s is R^2 / nu; shorter steps on finer meshes, as the pressure follows viscosity from step to step.
  const int steps = 25 * n;
  for (int k = 0; k < steps; ++k) liquid.step(0.5 / steps, {});
  double sum = 0.0;
  double volume = 0.0;
  for (std::size_t c = 0; c < liquid.domain().own(); ++c) {
    const auto& x = liquid.domain().part.center[c];
    if (x.z > 2 * radius) continue;
    const double exact = -2.0 * mean_velocity * (1.0 - (x.x * x.x + x.y * x.y) / (radius * radius));
    const double v = liquid.domain().part.volume[c];
    sum += v * (liquid.u()[c].z - exact) * (liquid.u()[c].z - exact);
    volume += v;
  }
  return {.columns = {"spacing", "velocity"},
          .rows = {{1.0 / n, std::sqrt(sum / volume) / mean_velocity}}};
}

double order(const Results& results, const std::string& name, const std::string& column) {
  std::vector<double> spacing;
  std::vector<double> error;
  for (const int n : sizes) {
    const auto& table = results.at(fmt::format("{}-{}", name, n));
    spacing.push_back(table.column("spacing").front());
    error.push_back(table.column(column).front());
  }
  return fitted_order(spacing, error);
}

std::vector<Check> judge(const Results& results) {
  return {{"F4, order of the velocity, cylinder", order(results, "manufactured", "velocity"), 1.9,
           2.1, "order 2 +- 0.1"},
          {"F4, order of the pressure, cylinder", order(results, "manufactured", "pressure"), 1.5,
           2.5, "at least 1.5"},
          {"F2, order of the velocity, pipe", order(results, "pipe", "velocity"), 1.8, 2.3,
           "order 2 +- 0.2"},
          {"F2, error of the velocity, pipe, 32 cells in the middle",
           results.at("pipe-32").column("velocity").front(), 0.0, 1e-3, "1e-3"}};
}

}  // namespace
}  // namespace packbed::validation

int main(int argc, char** argv) {
  using namespace packbed::validation;  // NOLINT
  Validation validation;
  for (const int n : sizes) {
    validation.pieces.push_back(
        {fmt::format("manufactured-{}", n), [n] { return manufactured(n); }});
    validation.pieces.push_back({fmt::format("pipe-{}", n), [n] { return pipe(n); }});
  }
  validation.judge = judge;
  return validation_main(argc, argv, validation);
}
