// SPDX-License-Identifier: BSD-3-Clause
// F5, F9 to F11: what every step must keep; restart; refusals.
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "fluid/figures.hpp"
#include "tests/support/fluid.hpp"
#include "tests/support/message_of.hpp"

namespace packbed::fluid {
namespace {

using namespace test;  // NOLINT
using ::testing::HasSubstr;

constexpr double mu = 1e-3;

/// A slice with a bed below, denser on one side.
Fluid slice(FluidOptions o) {
  o.boundaries.x_low = o.boundaries.x_high = Wall{.void_fraction = 1.0};
  const mesh::ColumnMesh mesh(mesh::Slice{.inner_diameter = 5e-3, .depth = 0.6e-3, .height = 8e-3},
                              {.x = 8, .y = 1, .layers = 12});
  return make_fluid(o, mesh);
}

Bed bed_of(const Fluid& fluid, double sink = 0.0) {
  Bed bed;
  for (std::size_t c = 0; c < fluid.domain().own(); ++c) {
    const auto& x = fluid.domain().part.center[c];
    const bool inside = x.z < 4e-3;
    const double eps = inside ? 0.38 + 10.0 * x.x + sink : 1.0;
    bed.eps.push_back(eps);
    bed.exchange.push_back(inside ? 180.0 * mu * (1 - eps) * (1 - eps) / (eps * 1e-8) : 0.0);
    bed.u_solid.push_back({0, 0, inside ? -1e-3 : 0.0});
  }
  return bed;
}

/// Integrating form A: dp = -rho u du where eps u is constant. The discrete sum over the jump is exactly that with
/// central interpolation.
void expect_bernoulli(const mesh::ColumnMesh& mesh) {
  const double u0 = 0.1;
  FluidOptions o{.rho_f = 1000.0, .mu_f = 1e-12, .gravity = {}};
  o.convection = Convection::central;
  o.crank_nicolson = 0.0;
  o.boundaries.inlet = Inlet{FlowProgram::steady(u0)};
  o.boundaries.wall = o.boundaries.x_low = o.boundaries.x_high = SlipWall{};
  o.pressure_tolerance = 1e-12;
  auto fluid = make_fluid(o, mesh);
  Bed bed;
  bed.eps = field(fluid, [](const Vec3& x) { return x.z > 10e-3 ? 0.8 : 0.4; });

  for (int k = 0; k < 300; ++k) fluid.step(1e-2, bed);

  for (std::size_t c = 0; c < fluid.domain().own(); ++c) {
    EXPECT_NEAR(bed.eps[c] * fluid.u()[c].z, -u0, 1e-10 * u0);
  }
  const double exact = 0.5 * 1000.0 * (u0 * u0 / 0.16 - u0 * u0 / 0.64);
  EXPECT_NEAR(pressure_drop(fluid), exact, 1e-6 * exact);
}

TEST(Bernoulli, HoldsAcrossAStepOfTheVoidFraction) {
  expect_bernoulli(BoxCase{{1e-3, 1e-3, 20e-3}, {1, 1, 20}}.mesh());
  expect_bernoulli({mesh::Cylinder{.inner_diameter = 1e-3, .height = 20e-3},
                    {.core = 2, .ring = 1, .layers = 20}});
}

TEST(Step, PassesTheSameVolumeThroughEveryPlane) {
  // F9: moving beads change eps from step to step; what the liquid gains or loses below a plane passes it.
  const double u0 = 2e-3;
  FluidOptions o;
  o.pressure_tolerance = 1e-12;
  o.boundaries.inlet = Inlet{FlowProgram::steady(u0)};
  auto fluid = slice(o);
  fluid.start(bed_of(fluid), std::vector<Vec3>(fluid.domain().own()), 0.0);
  const double area = 5e-3 * 0.6e-3;
  for (int k = 1; k <= 5; ++k) {
    const auto before = fluid.eps();

    const auto report = fluid.step(1e-3, bed_of(fluid, -1e-3 * k));

    EXPECT_LT(report.continuity_error, 1e-11);
    const auto flux = level_fluxes(fluid);
    double through = -u0 * area;
    for (std::size_t level = flux.size(); level-- > 0;) {
      EXPECT_NEAR(flux[level], through, 1e-9 * u0 * area);
      for (std::size_t c = 8 * (level - 1); level > 0 && c < 8 * level; ++c) {
        through += (fluid.eps()[c] - before[c]) * fluid.domain().part.volume[c] / 1e-3;
      }
    }
  }
}

/// F10: from rest to -u0 downwards, then reversed: the drop at the end, for steps of these Courant numbers.
void expect_same_drop(const mesh::ColumnMesh& mesh,
                      double u0,
                      std::initializer_list<double> numbers) {
  std::vector<double> drops;
  for (const double courant : numbers) {
    FluidOptions o;
    o.pressure_tolerance = 1e-10;
    o.momentum_tolerance = 1e-10;
    o.boundaries.inlet = Inlet{FlowProgram::through({{0.0, -u0}, {0.1, -u0}, {0.1, u0}})};
    auto fluid = make_fluid(o, mesh);
    const auto bed = bed_of(fluid);
    fluid.start(bed, std::vector<Vec3>(fluid.domain().own()), 0.0);
    const double dt = courant * 8e-3 / 12 / (std::abs(u0) / 0.38);
    const int steps = static_cast<int>(6.0 / dt) + 20;
    for (int k = 0; k < steps; ++k) fluid.step(dt, bed);
    drops.push_back(pressure_drop(fluid));
  }
  for (const double drop : drops) EXPECT_NEAR(drop, drops[0], 1e-5 * std::abs(drops[0]));
  EXPECT_GT(drops[0] * u0, 0.0);
}

TEST(Step, SteadyFlowDoesNotDependOnTheStep) {
  const auto plane = slice({}).domain().mesh;
  const mesh::ColumnMesh round(mesh::Cylinder{.inner_diameter = 5e-3, .height = 8e-3},
                               {.core = 4, .ring = 2, .layers = 12});
  for (const double u0 : {2e-3, -2e-3}) {
    expect_same_drop(plane, u0, {0.1, 1.0, 5.0});
    expect_same_drop(round, u0, {1.0, 5.0});
  }
}

TEST(Step, ReportsTheResidualThatItsFluxesHave) {
  // F11: what PETSc says is what the fluxes lack, worked out from the fluxes alone.
  FluidOptions o;
  o.pressure_tolerance = 1e-5;
  o.boundaries.inlet = Inlet{FlowProgram::steady(2e-3)};
  auto fluid = slice(o);
  for (int k = 0; k < 5; ++k) {
    const auto report = fluid.step(1e-3, bed_of(fluid, -1e-3 * k));
    ASSERT_EQ(report.pressure.size(), 2U);
    ASSERT_EQ(report.residual.size(), 2U);
    for (std::size_t n = 0; n < 2; ++n) {
      const double said = report.pressure[n].last_residual;
      EXPECT_GT(said, 0.0);
      // 1e-4: rounding of pressures, 1e3 Pa, times conductances.
      EXPECT_NEAR(report.residual[n], said, 1e-4 * said);
    }
  }
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TEST(Restart, GoesOnWithTheSameBits) {
  FluidOptions o;
  o.boundaries.inlet = Inlet{FlowProgram::through({{0.0, 0.0}, {0.02, 5e-3}})};
  auto unbroken = slice(o);
  const auto advance = [](Fluid& fluid, int first, int last) {
    for (int k = first; k < last; ++k) fluid.step(1e-3, bed_of(fluid, -1e-4 * k), 8e-3 - 1e-5 * k);
  };
  for (const int broken_at : {0, 1, 7}) {
    auto first = slice(o);
    advance(first, 0, broken_at);
    const auto saved = first.save();
    advance(first, broken_at, 12);
    auto resumed = slice(o);
    resumed.load(saved);
    advance(resumed, broken_at, 12);

    EXPECT_TRUE(same_bits(first.u(), resumed.u()));
    EXPECT_TRUE(same_bits(first.dynamic_pressure(), resumed.dynamic_pressure()));
    EXPECT_TRUE(same_bits(first.q(), resumed.q()));
    EXPECT_EQ(first.time(), resumed.time());
  }
}

TEST(Restart, RefusesTheStateOfAnotherMesh) {
  auto fluid = slice({});
  auto state = fluid.save();
  state.cells.pop_back();
  EXPECT_THAT(message_of([&] { fluid.load(state); }), HasSubstr("lacks cell 95"));
}

TEST(Refusals, NameWhatIsWrongAndWhere) {
  auto fluid = slice({});
  Bed bed;
  bed.eps.assign(96, 0.4);
  bed.eps[10] = 0.0;
  EXPECT_THAT(message_of([&] { fluid.step(1e-3, bed); }),
              HasSubstr("void fraction 0 in cell 10 at (-0.0009375,"));
  EXPECT_THAT(message_of([&] { fluid.step(1e-3, {.eps = {0.5}}); }),
              HasSubstr("1 values; this rank owns 96 cells"));
  EXPECT_THAT(message_of([&] { fluid.step(0.0, {}); }), HasSubstr("not above 0"));
  FluidOptions o;
  o.crank_nicolson = 1.5;
  EXPECT_THAT(message_of([&] { slice(o); }), HasSubstr("crank_nicolson = 1.5"));
}

TEST(Refusals, ClosedColumnThatIsSqueezed) {
  FluidOptions o;
  o.boundaries.outlet = Wall{};
  auto fluid = slice(o);
  EXPECT_THAT(message_of([&] { fluid.step(1e-3, {}, 7.9e-3); }),
              HasSubstr("has no outlet and does not fit"));
}

TEST(Refusals, SolvesThatStallStopTheRunWithTheirHistory) {
  FluidOptions o;
  o.boundaries.inlet = Inlet{FlowProgram::steady(2e-3)};
  o.pressure_tolerance = 1e-15;
  o.most_iterations = 1;
  auto fluid = slice(o);
  fluid.start(bed_of(fluid), std::vector<Vec3>(fluid.domain().own()), 0.0);

  const auto told = message_of([&] { fluid.step(1e-3, bed_of(fluid)); });

  EXPECT_THAT(told, HasSubstr("the solve for the pressure does not reach a residual of "));
  EXPECT_THAT(told, HasSubstr("preconditioner kept: 1 iterations from "));
  EXPECT_THAT(told, HasSubstr("; preconditioner made anew: 1 iterations from "));
  EXPECT_THAT(told, HasSubstr("; plain: 20 iterations from "));
}

// The depth of a slice, one cell of an empty direction, is nothing to the liquid.
TEST(EmptyDirection, DoesNotCount) {
  const auto flow = [](double depth) {
    FluidOptions o;
    o.pressure_tolerance = o.momentum_tolerance = 1e-13;
    o.boundaries.inlet = Inlet{FlowProgram::steady(5e-3)};
    auto fluid = make_fluid(o, BoxCase{{4e-3, depth, 8e-3}, {8, 1, 12}}.mesh());
    const auto bed = bed_of(fluid);
    fluid.start(bed, std::vector<Vec3>(fluid.domain().own()), 0.0);
    for (int k = 0; k < 5; ++k) fluid.step(1e-2, bed);
    return fluid;
  };
  const auto thin = flow(0.2e-3);
  const auto deep = flow(20e-3);

  for (std::size_t c = 0; c < thin.domain().own(); ++c) {
    EXPECT_EQ(thin.u()[c].y, 0.0);
    EXPECT_EQ(deep.u()[c].y, 0.0);
    EXPECT_LT(norm(thin.u()[c] - deep.u()[c]), 1e-12);
  }
  EXPECT_NEAR(pressure_drop(thin), pressure_drop(deep), 1e-9 * pressure_drop(deep));
}

}  // namespace
}  // namespace packbed::fluid
