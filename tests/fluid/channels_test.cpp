// SPDX-License-Identifier: BSD-3-Clause
// F2, F8: developed flow between plates, in a pipe, and in a bed between plates; thesis table B.3: walls of void
// fraction 1.
#include <numbers>

#include <gtest/gtest.h>

#include "fluid/figures.hpp"
#include "tests/support/fluid.hpp"

namespace packbed::fluid {
namespace {

using namespace test;  // NOLINT

constexpr double mu = 1e-3;
constexpr double mean = 1e-3;  // m/s

FluidOptions options() {
  FluidOptions o{.rho_f = 1000.0, .mu_f = mu, .gravity = {}};
  o.crank_nicolson = 0.0;
  o.pressure_tolerance = 1e-10;
  o.momentum_tolerance = 1e-10;
  return o;
}

struct Filling {
  double eps = 1.0;
  double exchange = 0.0;
  double force = 0.0;  ///< downwards [N/m3]
};

/// At rest between plates at x = 0 and x = width, periodic in z.
Fluid plates(int n, double width, const Filling& filling, const Wall& wall = {}) {
  const BoxCase box{
      {width, width, width}, {n, 1, 2}, {Boundary::wall, Boundary::wall, Boundary::periodic}};
  auto o = options();
  o.boundaries.x_low = o.boundaries.x_high = wall;
  auto fluid = make_fluid(o, box.mesh());
  Bed bed;
  bed.eps.assign(fluid.domain().own(), filling.eps);
  bed.exchange.assign(fluid.domain().own(), filling.exchange);
  bed.force.assign(fluid.domain().own(), {0, 0, -filling.force});
  fluid.start(bed, std::vector<Vec3>(fluid.domain().own()), 0.0);
  EXPECT_TRUE(run_to_rest(fluid, 1e3, bed, 1e-9, 50));
  return fluid;
}

TEST(Plates, HaveTheProfileOfPoiseuille) {
  const double width = 1e-3;
  const auto exact = [&](const Vec3& x) {
    return Vec3{0, 0, -6.0 * mean * x.x * (width - x.x) / (width * width)};
  };
  std::vector<double> h;
  std::vector<double> e;
  for (const int n : {8, 16, 32, 64}) {
    const auto fluid = plates(n, width, {.force = 12.0 * mu * mean / (width * width)});
    h.push_back(1.0 / n);
    e.push_back(velocity_error(fluid, exact) / mean);
    // The walls carry what drives the liquid.
    EXPECT_NEAR(wall_shear(fluid).z, -12.0 * mu * mean * width, 1e-7 * 12.0 * mu * mean * width);
  }

  EXPECT_NEAR(fitted_order(h, e), 2.0, 0.05);
  EXPECT_LT(e[2], 2e-3);
}

// Form A with eps inside the divergence: eps mu u'' = exchange (u - u_far), uniform eps. 0.777 d is the layer of
// Koch and Hill's bed at a solid fraction of 0.05.
constexpr double layer = 0.777e-3;
constexpr double gap = 8e-3;
constexpr double bed_eps = 0.95;
constexpr double bed_exchange = bed_eps * mu / (layer * layer);

TEST(Plates, HaveTheLayerOfBrinkmanInABed) {
  const auto exact = [&](const Vec3& x) {
    return Vec3{
        0, 0, -mean * (1.0 - std::cosh((x.x - 0.5 * gap) / layer) / std::cosh(0.5 * gap / layer))};
  };
  std::vector<double> h;
  std::vector<double> e;
  for (const int n : {32, 64, 128, 256}) {
    const auto fluid =
        plates(n, gap, {.eps = bed_eps, .exchange = bed_exchange, .force = bed_exchange * mean});
    h.push_back(1.0 / n);
    e.push_back(velocity_error(fluid, exact) / mean);
  }

  EXPECT_NEAR(fitted_order(h, e), 2.0, 0.1);
}

TEST(Plates, WallVoidFractionOneSlowsTheCellAtTheWall) {
  // One cell of width h at each wall: (eps_w mu 2/h + exchange h) u = exchange h u_far, and with both walls twice.
  const double width = 2e-3;
  const double exchange = 1e4;
  const double eps = 0.4;
  const double far = 1e-3;
  for (const double eps_wall : {0.4, 1.0}) {
    const auto fluid = plates(1, width, {.eps = eps, .exchange = exchange, .force = exchange * far},
                              {.void_fraction = eps_wall});

    const double shear = 2.0 * eps_wall * mu / (0.5 * width);
    EXPECT_NEAR(fluid.u()[0].z, -far * exchange * width / (shear + exchange * width), 1e-9 * far);
  }
}

TEST(Pipe, HasTheProfileOfPoiseuille) {
  const double radius = 0.5e-3;
  const mesh::ColumnMesh mesh(mesh::Cylinder{.inner_diameter = 2 * radius, .height = 6 * radius},
                              {.core = 8, .ring = 4, .layers = 12});
  auto o = options();
  o.pressure_tolerance = o.momentum_tolerance = 1e-7;
  o.boundaries.inlet = Inlet{FlowProgram::steady(mean)};
  auto fluid = make_fluid(o, mesh);

  for (int k = 0; k < 60; ++k) fluid.step(1e-2, {});

  // Developed in the lower third. 256 cells in the cross-section; orders: ./packbed validate liquid.
  double worst = 0.0;
  for (std::size_t c = 0; c < fluid.domain().own(); ++c) {
    const auto& x = fluid.domain().part.center[c];
    if (x.z > 2 * radius) continue;
    const double exact = -2.0 * mean * (1.0 - (x.x * x.x + x.y * x.y) / (radius * radius));
    worst = std::max(worst, std::abs(fluid.u()[c].z - exact));
  }
  EXPECT_LT(worst, 0.02 * mean);
  for (const double flux : level_fluxes(fluid)) {
    EXPECT_NEAR(flux, -mean * std::numbers::pi * radius * radius, 1e-6 * 1e-9);
  }
}

}  // namespace
}  // namespace packbed::fluid
