// SPDX-License-Identifier: BSD-3-Clause
// What must hold for every contact law, whichever it is.
#include <cmath>
#include <type_traits>

#include <gtest/gtest.h>

#include "dem/contact/contact_law.hpp"

namespace packbed::dem {
namespace {

template <class Law>
Law example();  // one set of ordinary parameters per law; a new law does not link without it

template <>
Hooke example() {
  return {.characteristic_velocity = 0.1, .restitution = 0.5};
}
template <>
HertzMindlin example() {
  return {.restitution = 0.5};
}
template <>
ViscousHooke example() {
  return {.characteristic_velocity = 0.1,
          .restitution_max = 0.9,
          .critical_stokes = 0.3,
          .viscosity = 1e-3};
}

template <class Variant>
struct AsTypes;
template <class... Laws>
struct AsTypes<std::variant<Laws...>> : std::type_identity<testing::Types<Laws...>> {};

template <class Law>
class ContactLaws : public testing::Test {
 protected:
  static constexpr Material gel{.youngs_modulus = 4e6, .poisson_ratio = 0.2};
  Law law = example<Law>();
  Pair pair{.i = gel, .j = gel, .r_eff = 2e-5, .m_eff = 2e-10, .m_scaled = 2e-10};
  Coefficients k = law.coefficients(pair);
};
TYPED_TEST_SUITE(ContactLaws, AsTypes<ContactLaw>::type);

TYPED_TEST(ContactLaws, RepelsAtRest) {
  for (const double overlap : {1e-12, 1e-9, 1e-6}) {
    EXPECT_GT(this->law(overlap, 0.0, this->k).f_n, 0.0) << overlap;
  }
}

TYPED_TEST(ContactLaws, HasNoForceApart) {
  for (const double gap : {0.0, 1e-12, 1e-6}) {
    for (const double v_n : {-1.0, 0.0, 1.0}) EXPECT_EQ(this->law(-gap, v_n, this->k).f_n, 0.0);
  }
}

TYPED_TEST(ContactLaws, DampsApproachAndSeparation) {
  const double rest = this->law(1e-7, 0.0, this->k).f_n;
  EXPECT_GT(this->law(1e-7, -1e-3, this->k).f_n, rest);
  EXPECT_LT(this->law(1e-7, 1e-3, this->k).f_n, rest);
}

TYPED_TEST(ContactLaws, PullsOnlyWithTension) {
  auto pulling = this->law;
  pulling.tension = true;
  EXPECT_EQ(this->law(1e-9, 1.0, this->k).f_n, 0.0);
  EXPECT_LT(pulling(1e-9, 1.0, this->k).f_n, 0.0);
}

TYPED_TEST(ContactLaws, StiffnessIsTheSlopeOfTheForce) {
  constexpr double h = 1e-11;
  for (const double overlap : {1e-8, 1e-6}) {
    const double slope =
        (this->law(overlap + h, 0.0, this->k).f_n - this->law(overlap - h, 0.0, this->k).f_n) /
        (2.0 * h);
    // 1e-5: central difference, h / overlap = 1e-3
    EXPECT_NEAR(slope / this->law.stiffness(overlap, this->k), 1.0, 1e-5);
  }
}

TYPED_TEST(ContactLaws, ForceIsTheSlopeOfTheEnergy) {
  constexpr double h = 1e-11;
  for (const double overlap : {1e-8, 1e-6}) {
    const double slope =
        (this->law.energy(overlap + h, this->k) - this->law.energy(overlap - h, this->k)) /
        (2.0 * h);
    EXPECT_NEAR(slope / this->law(overlap, 0.0, this->k).f_n, 1.0, 1e-5);
  }
}

TYPED_TEST(ContactLaws, IsFiniteEverywhere) {
  for (const double overlap : {-1e-5, -1e-12, 0.0, 1e-15, 1e-12, 1e-5}) {
    for (const double v_n : {-10.0, -1e-12, 0.0, 1e-12, 10.0}) {
      const auto r = this->law(overlap, v_n, this->k);
      EXPECT_TRUE(std::isfinite(r.f_n) && std::isfinite(r.k_t) && std::isfinite(r.gamma_t));
      EXPECT_GE(r.k_t, 0.0);
      EXPECT_GE(r.gamma_t, 0.0);
    }
  }
}

TYPED_TEST(ContactLaws, ForceAtEqualStrainScalesWithTheSquareOfTheSize) {  // coarse graining
  auto grain = this->pair;
  grain.r_eff *= 3.0;
  grain.m_eff *= 27.0;
  grain.m_scaled *= 27.0;
  const auto k3 = this->law.coefficients(grain);
  const double ratio = this->law(3e-7, 0.0, k3).f_n / this->law(1e-7, 0.0, this->k).f_n;
  EXPECT_NEAR(ratio, 9.0, 1e-12);
}

TYPED_TEST(ContactLaws, TakesAnIncompressiblePlate) {  // nu = 0.5, E = 10 GPa: thesis table B.2
  auto wall = this->pair;
  wall.j = {.youngs_modulus = 1e10, .poisson_ratio = 0.5};
  EXPECT_GT(this->law(1e-7, 0.0, this->law.coefficients(wall)).f_n,
            this->law(1e-7, 0.0, this->k).f_n);
}

}  // namespace
}  // namespace packbed::dem
