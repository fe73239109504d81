// SPDX-License-Identifier: BSD-3-Clause
// F6: gravity is balanced by the pressure to the last bit, whatever the bed and however the mesh is stretched.
#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/fluid.hpp"

namespace packbed::fluid {
namespace {

using namespace test;  // NOLINT

constexpr double height = 5e-3;
constexpr double outlet_pressure = 101325.0;

struct Column {
  const char* name;
  mesh::ColumnMesh mesh;
};

std::vector<Column> columns() {
  return {{"box", BoxCase{{2e-3, 1e-3, height}, {5, 3, 10}}.mesh()},
          {"cylinder", mesh::ColumnMesh(mesh::Cylinder{.inner_diameter = 2e-3, .height = height},
                                        {.core = 4, .ring = 2, .layers = 10})}};
}

FluidOptions options(double crank_nicolson) {
  FluidOptions o;
  o.crank_nicolson = crank_nicolson;
  o.boundaries.inlet = Inlet{};
  o.boundaries.outlet = Outlet{outlet_pressure};
  return o;
}

/// Void fractions of 0.05 to 1 and exchange coefficients of 1 to 1e12 kg/(m3 s), without any order.
Bed noise(const Fluid& fluid) {
  Bed bed;
  for (const auto cell : fluid.domain().part.cell) {
    const auto k = static_cast<std::uint64_t>(cell);
    bed.eps.push_back(0.05 + 0.95 * uniform(1, Stream::bead_size, k));
    bed.exchange.push_back(std::pow(10.0, 12.0 * uniform(2, Stream::bead_size, k)));
  }
  return bed;
}

/// Largest velocity in a cell [m/s].
double fastest(const Fluid& fluid) {
  double largest = 0.0;
  for (const auto& u : fluid.u()) largest = std::max(largest, norm(u));
  return largest;
}

void expect_hydrostatic(const Fluid& fluid, const char* name) {
  for (std::size_t c = 0; c < fluid.domain().own(); ++c) {
    const double z = fluid.domain().part.center[c].z;
    EXPECT_NEAR(fluid.pressure(c), outlet_pressure - 998.2 * 9.81 * z, 1e-9) << name;
  }
}

TEST(StillLiquid, StaysStillForAnyBedOnAnyStretchedMesh) {
  for (const auto& column : columns()) {
    for (const double stretch : {1.0, 0.37, 1.83}) {
      for (const double crank_nicolson : {0.0, 0.3, 1.0}) {
        auto mesh = column.mesh;
        mesh.set_top(stretch * height);
        auto fluid = make_fluid(options(crank_nicolson), mesh);
        const auto bed = noise(fluid);
        fluid.start(bed, std::vector<Vec3>(fluid.domain().own()), 0.0);

        for (int k = 0; k < 5; ++k) fluid.step(1e-3, bed);

        EXPECT_EQ(fastest(fluid), 0.0) << column.name << ' ' << stretch << ' ' << crank_nicolson;
        expect_hydrostatic(fluid, column.name);
      }
    }
  }
}

// The mesh passes through the liquid: what the top sweeps goes in there. Then any bed on the mesh so stretched.
TEST(StillLiquid, StaysStillWhileTheMeshMovesThroughIt) {
  constexpr double dt = 1e-3;
  constexpr double eps = 0.4;
  const auto top = [](int k) { return height - 0.2e-3 * k - 0.1e-3 * std::sin(0.7 * k); };
  std::vector<FlowProgram::Point> program = {{0.0, 0.0}, {0.5 * dt, eps * (top(1) - top(0)) / dt}};
  for (int k = 1; k <= 10; ++k) program.push_back({k * dt, eps * (top(k) - top(k - 1)) / dt});
  for (const auto& column : columns()) {
    auto o = options(0.3);
    o.boundaries.inlet = Inlet{FlowProgram::through(program)};
    auto fluid = make_fluid(o, column.mesh);
    auto bed = noise(fluid);
    std::fill(bed.eps.begin(), bed.eps.end(), eps);
    fluid.start(bed, std::vector<Vec3>(fluid.domain().own()), 0.0);

    for (int k = 1; k <= 10; ++k) fluid.step(dt, bed, top(k));

    // Rounding of what the faces sweep, which the top does at 0.3 m/s.
    EXPECT_LT(fastest(fluid), 1e-15) << column.name;
    fluid.set_inlet({});
    bed = noise(fluid);
    fluid.start(bed, std::vector<Vec3>(fluid.domain().own()), fluid.time());
    for (int k = 0; k < 5; ++k) fluid.step(dt, bed);
    EXPECT_EQ(fastest(fluid), 0.0) << column.name;
    expect_hydrostatic(fluid, column.name);
  }
}

}  // namespace
}  // namespace packbed::fluid
