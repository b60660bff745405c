#include "pliant/base/quantity.h"

#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "pliant/base/number_text.h"

namespace pliant {
namespace {

QuantityError error_of(const std::string& text, Dimension dimension) {
  try {
    parse_quantity(text, dimension);
  } catch (const QuantityError& error) {
    return error;
  }
  ADD_FAILURE() << text << " was accepted";
  return {"", ""};
}

TEST(ParseQuantity, GivesSiValues) {
  EXPECT_DOUBLE_EQ(parse_quantity("100 mm", Dimension::length), 0.1);
  EXPECT_DOUBLE_EQ(parse_quantity("1 in", Dimension::length), 0.0254);
  EXPECT_DOUBLE_EQ(parse_quantity("12 g", Dimension::mass), 0.012);
  EXPECT_DOUBLE_EQ(parse_quantity("6 N", Dimension::force), 6.0);
  EXPECT_DOUBLE_EQ(parse_quantity("100 gf", Dimension::force), 0.980665);
  EXPECT_DOUBLE_EQ(parse_quantity("15 ms", Dimension::time), 0.015);
  EXPECT_DOUBLE_EQ(parse_quantity("30 deg", Dimension::angle), std::numbers::pi / 6);
  EXPECT_DOUBLE_EQ(parse_quantity("300 gsm", Dimension::area_density), 0.3);
  EXPECT_DOUBLE_EQ(parse_quantity("0.143 kg/m^2", Dimension::area_density), 0.143);
  EXPECT_DOUBLE_EQ(parse_quantity("1 gf/cm", Dimension::force_per_length), 0.980665);
  EXPECT_DOUBLE_EQ(parse_quantity("1 gf cm^2/cm", Dimension::bending_stiffness), 9.80665e-5);
  EXPECT_DOUBLE_EQ(parse_quantity("2 1/cm", Dimension::curvature), 200.0);
  EXPECT_DOUBLE_EQ(parse_quantity("1.5 MPa", Dimension::stress), 1.5e6);
  EXPECT_DOUBLE_EQ(parse_quantity("20 degC", Dimension::temperature), 293.15);
  EXPECT_NEAR(parse_quantity("68 degF", Dimension::temperature), 293.15, 1e-12);  // rounding
  EXPECT_DOUBLE_EQ(parse_quantity("65 %", Dimension::fraction), 0.65);
  EXPECT_DOUBLE_EQ(parse_quantity("-2.5e3", Dimension::number), -2500.0);
}

TEST(ParseQuantity, TakesUnitsWithoutSpaceAndWithSignsAndExponents) {
  EXPECT_DOUBLE_EQ(parse_quantity(" 100mm ", Dimension::length), 0.1);
  EXPECT_DOUBLE_EQ(parse_quantity("+1e2mm", Dimension::length), 0.1);
  EXPECT_DOUBLE_EQ(parse_quantity("-.5 m", Dimension::length), -0.5);
}

TEST(ParseQuantity, NamesTheUnitsForABareNumber) {
  const QuantityError error = error_of("100", Dimension::length);
  EXPECT_EQ(error.problem(), "\"100\" has no unit");
  EXPECT_EQ(error.expected(), "a length with its unit (m, cm, mm, um, in)");
}

TEST(ParseQuantity, RefusesUnitsOfAnotherDimension) {
  EXPECT_EQ(error_of("3 kg", Dimension::force).problem(), "\"3 kg\": \"kg\" is no unit of force");
  EXPECT_EQ(error_of("3 N", Dimension::number).expected(), "a number");
  EXPECT_EQ(error_of("3 MM", Dimension::length).problem(), "\"3 MM\": \"MM\" is no unit of length");
}

TEST(ParseQuantity, RefusesWhatIsNoFiniteNumber) {
  for (const char* text : {"", "mm", "nan mm", "inf mm", "-Inf mm", "1e999 mm", "0x10 mm", "--1 mm",
                           "1.2.3 mm", "1,5 mm", "1 000 mm"}) {
    error_of(text, Dimension::length);
  }
  error_of("1.7e308 kN", Dimension::force);  // overflows in SI
  error_of("nan", Dimension::number);
}

TEST(ParseQuantity, SaysThatADecimalCommaIsNotRead) {
  EXPECT_EQ(error_of("1,5 mm", Dimension::length).problem(), "\"1,5 mm\" has a decimal comma");
}

TEST(UnitScale, KnowsTheSpellingsOfColumnNames) {
  EXPECT_EQ(unit_scale("N_per_m", Dimension::force_per_length), 1.0);
  EXPECT_EQ(unit_scale("1_per_m", Dimension::curvature), 1.0);
  EXPECT_EQ(unit_scale("mm2", Dimension::area), 1e-6);
  EXPECT_EQ(unit_scale("mm\u00b2", Dimension::area), 1e-6);
  EXPECT_EQ(unit_scale("\u00b5m", Dimension::length), 1e-6);
  EXPECT_EQ(unit_scale("N*m", Dimension::bending_stiffness), 1.0);
  EXPECT_EQ(unit_scale("gf.cm/cm", Dimension::force), unit_scale("gf cm/cm", Dimension::force));
  EXPECT_EQ(unit_scale("percent", Dimension::fraction), 1e-2);
  EXPECT_EQ(unit_scale("\u00b0", Dimension::angle), unit_scale("deg", Dimension::angle));
  EXPECT_EQ(unit_scale("Sec", Dimension::time), 1.0);  // of testing machines
  EXPECT_EQ(unit_scale("furlong", Dimension::length), std::nullopt);
}

TEST(UnitScale, KnowsUnitsInLettersOfAnotherCase) {
  EXPECT_EQ(unit_scale("MM", Dimension::length), 1e-3);
  EXPECT_EQ(unit_scale("n", Dimension::force), 1.0);
  EXPECT_EQ(unit_scale("KN", Dimension::force), 1e3);
  EXPECT_EQ(unit_scale("N/MM", Dimension::force_per_length), 1e3);
  EXPECT_EQ(unit_scale("mpa", Dimension::stress), 1e6);
  EXPECT_EQ(unit_scale("Newton", Dimension::force), 1.0);
  EXPECT_EQ(unit_scale("Millimetres", Dimension::length), 1e-3);
}

TEST(UnitScale, TellsMilliFromMegaByTheirCase) {
  EXPECT_EQ(unit_scale("mn", Dimension::force), 1e-3);
  EXPECT_EQ(unit_scale("MN", Dimension::force), std::nullopt);
  EXPECT_EQ(unit_scale("MN/m", Dimension::force_per_length), std::nullopt);
  EXPECT_EQ(unit_scale("mPa", Dimension::stress), std::nullopt);
  EXPECT_FALSE(is_unit("M"));  // a moment's column
}

TEST(UnitScale, IsNoneForUnitsWithAnOffset) {
  EXPECT_EQ(unit_scale("degC", Dimension::temperature), std::nullopt);
  EXPECT_EQ(unit_scale("K", Dimension::temperature), 1.0);
  EXPECT_EQ(unit_conversion("\u00b0C", Dimension::temperature)->to_si(0.0), 273.15);
}

TEST(Units, OfEveryDimensionAreReadBack) {
  for (int i = 0; i <= static_cast<int>(Dimension::fraction); ++i) {
    const auto dimension = static_cast<Dimension>(i);
    for (const std::string& unit : units_of(dimension)) {
      EXPECT_TRUE(unit_conversion(unit, dimension)) << unit;
      EXPECT_NO_THROW(parse_quantity("1 " + unit, dimension)) << unit;
      EXPECT_TRUE(is_unit(unit)) << unit;
    }
    if (!si_unit(dimension).empty()) {
      EXPECT_EQ(unit_scale(si_unit(dimension), dimension), 1.0) << si_unit(dimension);
    }
  }
}

TEST(FormatQuantity, ChoosesAReadableUnit) {
  EXPECT_EQ(format_quantity(0.1, Dimension::length), "100 mm");
  EXPECT_EQ(format_quantity(2.0, Dimension::length), "2 m");
  EXPECT_EQ(format_quantity(1 - 1e-9, Dimension::area), "1 m^2") << "rounded before its unit";
  EXPECT_EQ(format_quantity(0.9998, Dimension::area), "9998 cm^2");
  EXPECT_EQ(format_quantity(0.3, Dimension::area_density), "300 g/m^2");
  EXPECT_EQ(format_quantity(6.2e-6, Dimension::bending_stiffness), "6.2 uN m");
  EXPECT_EQ(format_quantity(-0.05, Dimension::force), "-50 mN");
  EXPECT_EQ(format_quantity(293.15, Dimension::temperature), "20 degC");
  EXPECT_EQ(format_quantity(0.0, Dimension::length), "0 m");
  EXPECT_EQ(format_quantity(0.65, Dimension::fraction), "65 %");
}

TEST(FormatQuantity, KeepsTheDigitsAskedFor) {
  const double length = 0.123456789012345;
  const std::string text = format_quantity(length, Dimension::length, 15);
  EXPECT_EQ(text, "123.456789012345 mm");
  // 15 digits in mm and one rounding on the way back.
  EXPECT_NEAR(parse_quantity(text, Dimension::length), length, 1e-15);
}

TEST(ParseNumber, TakesWholeFiniteNumbersOnly) {
  EXPECT_EQ(parse_number("1.5"), 1.5);
  EXPECT_EQ(parse_number("+1.5e-3"), 1.5e-3);
  EXPECT_EQ(parse_number("-0"), 0.0);
  for (const char* text :
       {"", "+", "-", "+-1", " 1", "1 ", "1x", "nan", "inf", "infinity", "1e400", "0x1p3", "1,5"}) {
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
  }
}

TEST(ParseInteger, TakesWholeNumbersOnly) {
  EXPECT_EQ(parse_integer("-12"), -12);
  EXPECT_EQ(parse_integer("+3"), 3);
  for (const char* text : {"", "1.0", "1e3", "99999999999999999999", "a"}) {
    EXPECT_EQ(parse_integer(text), std::nullopt) << text;
  }
}

TEST(FormatNumber, IsTheShortestTextThatReadsBack) {
  for (const double value : {0.1, 1.0 / 3.0, 6.02e23, -1e-300, 5e-324, 1.7976931348623157e308}) {
    EXPECT_EQ(parse_number(format_number(value)), value);
  }
  EXPECT_EQ(format_number(0.1), "0.1");
  EXPECT_EQ(format_number(2.0 / 3.0, 3), "0.667");
}

}  // namespace
}  // namespace pliant
