// SPDX-License-Identifier: BSD-3-Clause
#include "core/quantity.hpp"

#include <clocale>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "tests/support/message_of.hpp"

namespace packbed {
namespace {

using enum Dimension;
using testing::HasSubstr;

class Quantities : public testing::Test {
 protected:
  double si(std::string_view text, Dimension dimension) const {
    return units_.to_si(text, dimension);
  }
  std::string refusal(std::string_view text, Dimension dimension) const {
    return test::message_of([&] { (void)units_.to_si(text, dimension); });
  }
  UnitSystem units_;
};

// Expected values are the definitions of the units, written as the nearest double.
TEST_F(Quantities, OfTheFieldAreReadToTheLastBit) {
  EXPECT_EQ(si("90 um", length), 9e-5);
  EXPECT_EQ(si("86.9 um", length), 8.69e-5);
  EXPECT_EQ(si("90um", length), 9e-5);
  EXPECT_EQ(si("90 µm", length), 9e-5);       // U+00B5
  EXPECT_EQ(si("90 \u03BCm", length), 9e-5);  // Greek mu
  EXPECT_EQ(si("31 mm", length), 0.031);
  EXPECT_EQ(si("20 mm/min", velocity), 20.0 / 60000.0);
  EXPECT_EQ(si("2763 cm/h", velocity), 2763.0 / 360000.0);
  EXPECT_EQ(si("300 cm h-1", velocity), 300.0 / 360000.0);
  EXPECT_EQ(si("1 mPa s", viscosity), 1e-3);
  EXPECT_EQ(si("1 mPas", viscosity), 1e-3);
  EXPECT_EQ(si("1 cP", viscosity), 1e-3);
  EXPECT_EQ(si("3 bar", pressure), 3e5);
  EXPECT_EQ(si("30 MPa", pressure), 3e7);
  EXPECT_EQ(si("20 degC", temperature), 293.15);
  EXPECT_EQ(si("1.14 g/cm3", density), 1140.0);
  EXPECT_EQ(si("50 uN", force), 5e-5);
  EXPECT_EQ(si("4 %", fraction), 0.04);
  EXPECT_EQ(si("0.38", fraction), 0.38);
  EXPECT_EQ(si("1e-4 m", length), 1e-4);
  EXPECT_EQ(si("-2.5E3 um", length), -2.5e-3);
  EXPECT_EQ(si("+0.5 s", time), 0.5);
}

TEST_F(Quantities, FlowRateInLitersPerHour) {
  // 1: two divisions by 3.6e6 written in another order
  EXPECT_DOUBLE_EQ(si("2 L/h", volume_flow), 2e-3 / 3600.0);
}

TEST_F(Quantities, WithoutUnitAreRefused) {
  EXPECT_THAT(refusal("90", length), HasSubstr("no unit"));
}

TEST_F(Quantities, OfAnotherDimensionAreNamed) {
  EXPECT_EQ(refusal("5 kg/m3", length), "it is a density, not a length");
  EXPECT_EQ(refusal("10 m/s", length), "it is a velocity, not a length");
  EXPECT_EQ(refusal("2 L/h", velocity), "it is a volume flow, not a velocity");
  EXPECT_THAT(refusal("5 mol", length), HasSubstr("is not a unit of length"));
}

TEST_F(Quantities, ReciprocalUnitsAreAnotherDimension) {
  EXPECT_THAT(refusal("10 Hz", time), HasSubstr("it is a frequency, not a time"));
}

TEST_F(Quantities, UnknownUnitsAreNamed) {
  EXPECT_EQ(refusal("90 mn", length), "the unit \"mn\" is not known");
}

TEST_F(Quantities, ThatAreNoSingleNumberAreRefused) {
  EXPECT_THAT(refusal("wide", length), HasSubstr("does not start with a number"));
  EXPECT_THAT(refusal("", length), HasSubstr("does not start with a number"));
  EXPECT_THAT(refusal("nan um", length), HasSubstr("number"));
  EXPECT_THAT(refusal("inf um", length), HasSubstr("number"));
  EXPECT_THAT(refusal("1e999 um", length), HasSubstr("double precision"));
  EXPECT_THAT(refusal("1,5 mm", length), HasSubstr("decimal point"));
  EXPECT_THAT(refusal("90 2 um", length), HasSubstr("more than one number"));
  EXPECT_THAT(refusal("90 um 2", length), HasSubstr("more than one number"));
  EXPECT_THAT(refusal("5 mL/10 min", volume_flow), HasSubstr("more than one number"));
  EXPECT_THAT(refusal("--5 um", length), HasSubstr("number"));
}

TEST_F(Quantities, TellVelocityFromFlowRate) {
  EXPECT_EQ(units_.dimension_of("2 L/h", velocity), volume_flow);
  EXPECT_EQ(units_.dimension_of("2 cm/h", velocity), velocity);
  EXPECT_EQ(units_.dimension_of("2 nonsense", velocity), velocity);
}

TEST_F(Quantities, EveryDimensionReadsItsOwnExample) {
  for (const auto& d : all_dimensions()) {
    EXPECT_NO_THROW(si(d.example, d.dimension)) << d.name;
  }
}

// The decimal comma of de_DE must not change "1.5"; the locale is made by the test's CMake step.
TEST_F(Quantities, AreReadAlikeUnderADecimalCommaLocale) {
  ASSERT_NE(std::setlocale(LC_ALL, "de_DE.UTF-8"), nullptr) << "LOCPATH must hold de_DE.UTF-8";
  ASSERT_STREQ(std::localeconv()->decimal_point, ",");

  const UnitSystem under_locale;
  const double value = under_locale.to_si("1.5 mm", length);
  const double psi = under_locale.to_si("1.5 psi", pressure);
  std::setlocale(LC_ALL, "C");

  EXPECT_EQ(value, 1.5e-3);
  EXPECT_EQ(psi, si("1.5 psi", pressure));
}

}  // namespace
}  // namespace packbed
