// SPDX-License-Identifier: BSD-3-Clause
// F7, D3, D4, D9: beds as given fields.
#include <gtest/gtest.h>

#include "fluid/figures.hpp"
#include "tests/support/fluid.hpp"

namespace packbed::fluid {
namespace {

using namespace test;  // NOLINT

constexpr double rho = 1000.0;
constexpr double mu = 1e-3;

// Kozeny and Carman: dp/dz = 180 mu (1 - eps)^2 u0 / (eps^3 d^2), and dp/dz = exchange u0 / eps^2 in form A.
double kozeny_carman(double eps, double d) {
  return 180.0 * mu * (1.0 - eps) * (1.0 - eps) / (eps * d * d);
}

// Koch and Hill as in thesis eqs 4.6 to 4.9, for solid fractions of 0.4 and more; u interstitial.
double koch_hill(double eps, double d, double u) {
  const double solid = 1.0 - eps;
  const double re = rho * eps * std::abs(u) * d / mu;
  const double f0 = 10.0 * solid / (eps * eps * eps);
  const double f3 = 0.0673 + 0.212 * solid + 0.0232 / std::pow(eps, 5);
  return 18.0 * mu * eps * eps * solid / (d * d) * (f0 + 0.5 * f3 * re);
}

FluidOptions options(double u0, bool convects = true) {
  FluidOptions o{.rho_f = rho, .mu_f = mu, .gravity = {}};
  o.pressure_tolerance = 1e-12;
  o.momentum_tolerance = 1e-13;
  o.convection = convects ? Convection::limited : Convection::none;
  o.boundaries.inlet = Inlet{FlowProgram::steady(u0)};
  o.boundaries.x_low = o.boundaries.x_high = SlipWall{};
  o.boundaries.y_low = o.boundaries.y_high = o.boundaries.wall = SlipWall{};
  return o;
}

mesh::ColumnMesh box(std::int32_t layers = 20) {
  return BoxCase{{1e-3, 1e-3, 20e-3}, {2, 2, layers}}.mesh();
}
mesh::ColumnMesh cylinder(std::int32_t layers = 20) {
  return {mesh::Cylinder{.inner_diameter = 1e-3, .height = 20e-3},
          {.core = 2, .ring = 1, .layers = layers}};
}

Fluid column(const FluidOptions& o) { return make_fluid(o, box()); }

Bed bed_of(const Fluid& fluid, const std::function<double(double)>& eps_at, double d) {
  Bed bed;
  bed.eps = field(fluid, [&](const Vec3& x) { return eps_at(x.z); });
  for (const double eps : bed.eps) bed.exchange.push_back(eps < 1.0 ? kozeny_carman(eps, d) : 0.0);
  return bed;
}

void steps(Fluid& fluid, int count, double dt, const Bed& bed) {
  fluid.start(bed, std::vector<Vec3>(fluid.domain().own()), 0.0);
  for (int k = 0; k < count; ++k) fluid.step(dt, bed);
}

/// Largest deviation of the superficial velocity from u0 downwards, over u0.
double unevenness(const Fluid& fluid, double u0) {
  double worst = 0.0;
  for (std::size_t c = 0; c < fluid.domain().own(); ++c) {
    worst = std::max(worst, norm(fluid.eps()[c] * fluid.u()[c] + Vec3{0, 0, u0}) / std::abs(u0));
  }
  return worst;
}

TEST(Darcy, TwoLayersAddUpForAnyStep) {
  const double u0 = 1e-3;
  // Where cells lean the liquid finds its way in some steps, by the lag of what leans.
  for (const auto& [mesh, count] : {std::pair{box(), 3}, {cylinder(), 30}}) {
    for (const double dt : {1e-5, 1e-3, 1.0}) {
      auto fluid = make_fluid(options(u0, false), mesh);
      const auto bed = bed_of(
          fluid, [](double z) { return z > 10e-3 ? 0.4 : 0.3; }, 100e-6);

      steps(fluid, count, dt, bed);

      // 10 mm of 0.40 and 10 mm of 0.30: 1012.5 + 3266.6667 Pa.
      EXPECT_NEAR(pressure_drop(fluid), 1012.5 + 9800.0 / 3.0, 1e-6 * 4279.0) << dt;
      EXPECT_LT(unevenness(fluid, u0), 1e-8);  // what the first steps of 1e-5 s leave
    }
  }
}

/// 0.43 to 0.34 and to free liquid, both ways. Away from a jump by more than two cells the pressure is linear to
/// round-off; beside it inertia and viscosity of the liquid that changes its speed there count: rho u^2 / h, mu u / h^2.
void expect_no_oscillation(const mesh::ColumnMesh& mesh, double u0) {
  const double h = mesh.level(1);
  const double speed = std::abs(u0);
  const double at_jumps = rho * std::pow(speed / 0.34, 2) / h + mu * speed / (0.34 * h * h);
  auto fluid = make_fluid(options(u0), mesh);
  const auto eps_at = [](double z) { return z > 15e-3 ? 1.0 : z > 7.5e-3 ? 0.43 : 0.34; };
  const auto bed = bed_of(fluid, eps_at, 93e-6);

  steps(fluid, 400, 1e-3, bed);

  EXPECT_LT(unevenness(fluid, u0), 1e-9);
  for (std::size_t c = 0; c < fluid.domain().own(); ++c) {
    const double z = fluid.domain().part.center[c].z;
    const double slope = bed.exchange[c] * u0 / (bed.eps[c] * bed.eps[c]);
    const bool beside = std::abs(z - 7.5e-3) < 2 * h || std::abs(z - 15e-3) < 2 * h;
    EXPECT_NEAR(fluid.pressure_gradient()[c].z, slope, beside ? at_jumps : 1e-9 * 4e5) << z;
  }
}

TEST(Darcy, JumpsGiveNoOscillation) {
  const double u0 = 500.0 / 360000.0;
  for (const double sign : {1.0, -1.0}) {
    expect_no_oscillation(box(24), sign * u0);
    expect_no_oscillation(cylinder(24), sign * u0);
  }
}

TEST(Darcy, StepOfTheFlowIsFollowedAtOnce) {
  // tau = rho eps / exchange is 1e-6 s or less; a step of 1 ms must neither lag nor overshoot (D9).
  const double u0 = 1e-3;
  for (const double cn : {0.0, 0.3, 1.0}) {
    auto o = options(u0, false);
    o.crank_nicolson = cn;
    o.boundaries.inlet = Inlet{FlowProgram::through({{0.0, u0}, {0.01, u0}, {0.01, 2 * u0}})};
    auto fluid = column(o);
    const auto bed = bed_of(
        fluid, [](double z) { return z > 10e-3 ? 0.4 : 0.3; }, 10e-6);
    steps(fluid, 9, 1e-3, bed);
    EXPECT_NEAR(pressure_drop(fluid), 427916.67, 1.0);

    for (int k = 0; k < 5; ++k) {
      fluid.step(1e-3, bed);
      // Euler brings the liquid up to speed within the step, by rho u0 / dt (0.01 m / 0.4 + 0.01 m / 0.3) = 58.33
      // Pa; the fitted weight of the drag, as the exponential has it, before its end.
      const double inertia = k == 0 && cn == 0.0 ? 58.333333 : 0.0;
      EXPECT_NEAR(pressure_drop(fluid), 2 * 427916.67 + inertia, 0.1) << cn << ' ' << k;
    }
  }
}

TEST(Drag, BringsLiquidToTheBedWithoutOvershoot) {
  // Liquid at rest in a periodic box, beads at 1 mm/s: u -> u_s as exp(-t/tau), tau = 1e-6 s to 1 s.
  for (const double tau : {1e-6, 1e-3, 1.0}) {
    for (const double cn : {0.0, 0.3, 1.0}) {
      FluidOptions o{.rho_f = rho, .mu_f = mu, .gravity = {}};
      o.crank_nicolson = cn;
      o.momentum_tolerance = 1e-13;
      const BoxCase box{{1e-3, 1e-3, 1e-3},
                        {2, 2, 2},
                        {Boundary::periodic, Boundary::periodic, Boundary::periodic}};
      auto fluid = make_fluid(o, box.mesh());
      Bed bed;
      bed.eps.assign(8, 0.4);
      bed.exchange.assign(8, 0.4 * rho / tau);
      bed.u_solid.assign(8, {1e-3, 0, 0});
      fluid.start(bed, std::vector<Vec3>(8), 0.0);
      double before = 0.0;

      for (int k = 1; k <= 20; ++k) {
        fluid.step(1e-3, bed);
        const double u = fluid.u()[0].x;
        EXPECT_GE(u, before - 1e-15);
        EXPECT_LE(u, 1e-3 * (1 + 1e-12));
        // Fitted weights of pure Crank-Nicolson give the exponential itself.
        if (cn == 1.0) {
          EXPECT_NEAR(u, -1e-3 * std::expm1(-k * 1e-3 / tau), 1e-12);
        }
        before = u;
      }
    }
  }
}

struct BedCase {
  const char* name;
  double eps, d, u0_cm_h, kozeny, koch;
};

TEST(FixedBed, HasTheDropOfKozenyCarmanAndOfKochHill) {
  // D3, D4 of the list of verification cases: Pa/m; 0: not given there.
  for (const auto& b : {BedCase{"S", 0.38, 0.0, 100, 46383.45, 46398.94},
                        BedCase{"93 um", 0.36, 93e-6, 500, 2.537620e5, 0},
                        BedCase{"93 um", 0.36, 93e-6, 2763, 1.402289e6, 1.417027e6}}) {
    // Bead S has the diameter at which Kozeny and Carman give the first figure.
    const double u0 = b.u0_cm_h / 360000.0;
    const double d = b.d > 0 ? b.d
                             : std::sqrt(180.0 * mu * u0 * (1 - b.eps) * (1 - b.eps) /
                                         (b.eps * b.eps * b.eps * b.kozeny));
    for (const bool kozeny : {true, false}) {
      const double exact = kozeny ? b.kozeny : b.koch;
      if (exact == 0) continue;
      auto fluid = column(options(u0));
      Bed bed;
      bed.eps.assign(fluid.domain().own(), b.eps);
      bed.exchange.assign(fluid.domain().own(),
                          kozeny ? kozeny_carman(b.eps, d) : koch_hill(b.eps, d, u0 / b.eps));

      steps(fluid, 5, 1e-2, bed);

      EXPECT_NEAR(pressure_drop(fluid) / 20e-3, exact, 1e-6 * exact) << b.name;
    }
  }
}

}  // namespace
}  // namespace packbed::fluid
