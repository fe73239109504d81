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

/// What the scheme makes of Brinkman's layer between plates of n cells: the velocity of the cell next to the wall over
/// that far away. `cells`: (h / layer)^2; `wall`: void fraction at the wall over that of the bed. In the bed
/// v = u_far - u has v(j-1) - (2 + cells) v(j) + v(j+1) = 0, at the wall v(1) - v(2) + cells v(1) = 2 wall (u_far - v(1)).
double at_the_wall(int n, double cells, double wall) {
  const double b = 1.0 + 0.5 * cells;
  const double r = b - std::sqrt(b * b - 1.0);
  const double v1 = 1.0 + std::pow(r, n - 1);
  const double v2 = r + std::pow(r, n - 2);
  return 1.0 - 2.0 * wall * v1 / ((1.0 + cells + 2.0 * wall) * v1 - v2);
}

// Thesis table B.3; docs/theory/liquid.md, section 6. The shear of a wall of 1 beside a bed of 0.4 is 2.5 times as strong per velocity of the cell.
TEST(Plates, WallVoidFractionOneSlowsTheCellAtTheWall) {
  constexpr int n = 64;
  constexpr double h = 0.4e-3;
  constexpr double eps = 0.4;
  struct Ratio {
    double cells;      ///< h over the layer
    double same, one;  ///< velocity of the cell at the wall over that far away, in wide beds
  };
  // The last one is a bed of beads of 87 um: 180 mu (1 - eps)^2 / (eps d^2) = 2.14e7 kg/(m3 s).
  for (const auto& ratio :
       {Ratio{0.3, 0.1483, 0.0651}, Ratio{1.0, 0.4472, 0.2445}, Ratio{3.0, 0.8321, 0.6646},
        Ratio{10.0, 0.9806, 0.9528}, Ratio{92.5, 0.99977, 0.99942}}) {
    const double width = h / ratio.cells;
    const double exchange = eps * mu / (width * width);
    const Filling filling{.eps = eps, .exchange = exchange, .force = exchange * mean};
    const auto u = [&](const Wall& wall) {
      return -plates(n, n * h, filling, wall).u()[0].z / mean;
    };

    const double same = u({});
    const double one = u({.velocity = {}, .void_fraction = 1.0});

    EXPECT_NEAR(same, at_the_wall(n, ratio.cells * ratio.cells, 1.0), 1e-8) << ratio.cells;
    EXPECT_NEAR(one, at_the_wall(n, ratio.cells * ratio.cells, 1.0 / eps), 1e-8) << ratio.cells;
    EXPECT_NEAR(same, ratio.same, 1e-3 * ratio.same) << ratio.cells;
    EXPECT_NEAR(one, ratio.one, 1e-3 * ratio.one) << ratio.cells;
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
