// SPDX-License-Identifier: BSD-3-Clause
// Drag laws: published values, limits, and what must hold for each.
#include <cmath>

#include <gtest/gtest.h>

#include "continuum/packed_bed.hpp"
#include "coupling/drag/drag_law.hpp"

namespace packbed::coupling {
namespace {

// D1: values of thesis eqs 4.8 and 4.9.
TEST(KochHill, HasTheValuesOfItsEquations) {
  struct Row {
    double a, f0, f3;
  };
  for (const Row& r :
       {Row{0.01, 1.26881669, 0.09381563}, Row{0.1, 2.82322923, 0.12778940},
        Row{0.3, 9.43728034, 0.26893772}, Row{0.4, 18.51851852, 0.45045391}, Row{0.5, 40.0, 0.9157},
        Row{0.6, 93.75, 2.460125}, Row{0.62, 112.99023181, 3.12673278},
        Row{0.64, 137.17421125, 4.03983583}, Row{0.7, 259.25925926, 9.76302510}}) {
    EXPECT_NEAR(KochHill::f0(r.a), r.f0, 1e-8 * std::max(1.0, r.f0)) << r.a;
    EXPECT_NEAR(KochHill::f3(r.a), r.f3, 1e-8) << r.a;
  }
  EXPECT_NEAR(KochHill::f0(0.4 - 1e-14), 18.32751800, 1e-7);  // D2: a jump of 1.0422 %
  EXPECT_NEAR(KochHill::f0(0.4) / KochHill::f0(0.4 - 1e-14), 1.010422, 1e-6);
}

/// Pressure gradient of a bed of beads of one size at rest, form A: dp/dx = n K u_0 / alpha_f^2 [Pa/m].
template <class Law>
double gradient(const Law& law, double eps, double d, double u0, double cg = 1.0) {
  constexpr double eta = 1e-3;
  constexpr double rho = 1000.0;
  const double re = bead_reynolds(rho, eta, d, eps, u0 / eps);
  const double grain = cg * d;
  const double volume = std::numbers::pi / 6.0 * grain * grain * grain;
  const double k = grain_coefficient(law(1.0 - eps, re), eta, grain, cg, eps);
  return (1.0 - eps) / volume * k * u0 / (eps * eps);
}

constexpr double cm_h = 0.01 / 3600.0;

// D3: bead S, porosity 0.38.
TEST(KochHill, IsKozenyCarmanWhenSlow) {
  const double d = 86.9e-6;
  struct Row {
    double speed, kozeny_carman, koch_hill;
  };
  for (const Row& r :
       {Row{100, 46383.45, 46398.94}, Row{637, 295462.6, 296091.2}, Row{2763, 1281575, 1293401}}) {
    const double u0 = r.speed * cm_h;
    EXPECT_NEAR(continuum::kozeny_carman_gradient(0.38, d, 1e-3, u0), r.kozeny_carman,
                1e-6 * r.kozeny_carman);
    EXPECT_NEAR(gradient(KochHill{}, 0.38, d, u0), r.koch_hill, 1e-6 * r.koch_hill);
  }
  const double slow = 1e-9;
  EXPECT_NEAR(
      gradient(KochHill{}, 0.38, d, slow) / continuum::kozeny_carman_gradient(0.38, d, 1e-3, slow),
      1.0, 1e-6);
  EXPECT_NEAR(gradient(Ergun{}, 0.38, d, 2763 * cm_h), 1081382, 2e-2 * 1081382);  // its 150 alone
  EXPECT_NEAR(150.0 / 180.0 * 1281575, 1067979, 1.0);
}

// D4: beads of 93 um, porosity 0.36.
TEST(DragLaws, GiveTheBedOfThePaper) {
  const double u0 = 2763 * cm_h;
  EXPECT_NEAR(gradient(KochHill{}, 0.36, 93e-6, u0), 1.417027e6, 1e-6 * 1.417027e6);
  EXPECT_NEAR(gradient(Ergun{}, 0.36, 93e-6, u0), 1.183779e6, 1e-6 * 1.183779e6);
}

// D8: coarse grains of the same beads give the same pressure drop.
TEST(DragLaws, DoNotDependOnTheCoarseGrain) {
  for (const double cg : {2.0, 3.0}) {
    EXPECT_NEAR(gradient(KochHill{}, 0.38, 87e-6, 5e-3, cg),
                gradient(KochHill{}, 0.38, 87e-6, 5e-3),
                1e-10 * gradient(KochHill{}, 0.38, 87e-6, 5e-3));
  }
}

// D7: per bead, the pressure drop is that of the Sauter mean times <d><d^3> / <d^2>^2.
TEST(DragLaws, OfBeadsOfTwoSizesActOnEachDiameter) {
  const double d[2] = {75e-6, 210e-6};
  const double share[2] = {0.6, 0.4};
  double m1 = 0.0;
  double m2 = 0.0;
  double m3 = 0.0;
  double k = 0.0;
  for (int n = 0; n < 2; ++n) {
    m1 += share[n] * d[n];
    m2 += share[n] * d[n] * d[n];
    m3 += share[n] * d[n] * d[n] * d[n];
    k += share[n] * grain_coefficient(KochHill{}(0.62, 0.0), 1e-3, d[n], 1.0, 0.38);
  }
  const double number = 0.62 / (std::numbers::pi / 6.0 * m3);
  const double mixed = number * k / (0.38 * 0.38);
  const double sauter = continuum::kozeny_carman_gradient(0.38, m3 / m2, 1e-3, 1.0);
  EXPECT_NEAR(mixed / sauter, m1 * m3 / (m2 * m2), 1e-6);
  EXPECT_NEAR(mixed / sauter, 1.156, 1e-3);
}

template <class Law>
struct Limits;  // a new law does not compile without its row
template <>
struct Limits<KochHill> {
  static constexpr double single = 1.0, single_tolerance = 1e-3;
};
template <>
struct Limits<Ergun> {
  static constexpr double single = 0.0, single_tolerance = 1e-3;  // a law of beds
};
template <>
struct Limits<Gidaspow> {
  static constexpr double single = 1.0, single_tolerance = 1e-3;
};
template <>
struct Limits<DiFelice> {
  static constexpr double single = 0.96, single_tolerance = 1e-3;  // 4.8^2 / 24
};
template <>
struct Limits<Beetstra> {
  static constexpr double single = 1.0, single_tolerance = 1e-3;
};

template <class Variant>
struct AsTypes;
template <class... Laws>
struct AsTypes<std::variant<Laws...>> : std::type_identity<testing::Types<Laws...>> {};

template <class Law>
class DragLaws : public testing::Test {};
TYPED_TEST_SUITE(DragLaws, AsTypes<DragLaw>::type);

TYPED_TEST(DragLaws, AreThoseOfASingleBeadWithoutNeighbors) {
  EXPECT_NEAR(TypeParam{}(1e-9, 0.0), Limits<TypeParam>::single,
              Limits<TypeParam>::single_tolerance);
}

TYPED_TEST(DragLaws, GrowWithSolidFractionAndSpeed) {
  for (double re : {0.0, 1e-3, 0.1, 1.0, 100.0}) {
    for (double a = 0.25; a < 0.8; a += 0.01) {
      EXPECT_GT(TypeParam{}(a + 0.01, re), TypeParam{}(a, re)) << a << ' ' << re;
    }
  }
  for (double a : {0.1, 0.3, 0.6, 0.8}) {
    for (double re = 1e-3; re < 100.0; re *= 2.0) {
      EXPECT_GT(2.0 * TypeParam{}(a, 2.0 * re), TypeParam{}(a, re)) << a << ' ' << re;
    }
  }
}

TYPED_TEST(DragLaws, AreContinuousAtRest) {
  for (double a : {0.1, 0.45, 0.62, 0.8}) {
    EXPECT_NEAR(TypeParam{}(a, 1e-12) / TypeParam{}(a, 0.0), 1.0, 1e-5) << a;
  }
}

TYPED_TEST(DragLaws, AgreeWithinAFactorInADenseBed) {
  const double reference = KochHill{}(0.6, 0.01);
  EXPECT_GT(TypeParam{}(0.6, 0.01), 0.6 * reference);
  EXPECT_LT(TypeParam{}(0.6, 0.01), 1.2 * reference);
}

}  // namespace
}  // namespace packbed::coupling
