#include "pliant/report/readable_unit.h"

#include <limits>

#include <gtest/gtest.h>

namespace pliant::report {
namespace {

TEST(ReadableUnit, OfForcesTakesAPrefix) {
  EXPECT_EQ(readable_unit("N m", 3e-6).name, "µN m");
  EXPECT_DOUBLE_EQ(readable_unit("N m", 3e-6).factor, 1e6);
  EXPECT_EQ(readable_unit("N m", 4e-7).name, "nN m");
  EXPECT_EQ(readable_unit("N", -0.0028).name, "mN");
  EXPECT_EQ(readable_unit("N/m", 3e5).name, "kN/m");
}

TEST(ReadableUnit, OfAPrefixedUnitTakesAnother) {
  EXPECT_EQ(readable_unit("mN", 0.002).name, "µN");
  EXPECT_DOUBLE_EQ(readable_unit("mN", 0.002).factor, 1e3);
}

TEST(ReadableUnit, StaysWhereNumbersAreReadable) {
  for (const double size : {0.1, 57.0, 9999.0, 0.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(readable_unit("N/m", size).name, "N/m") << size;
    EXPECT_EQ(readable_unit("N/m", size).factor, 1) << size;
  }
}

TEST(ReadableUnit, LeavesOtherUnitsAsTheyAre) {
  for (const char* unit : {"1", "1/m", "mm", "%", "°", "s", ""}) {
    EXPECT_EQ(readable_unit(unit, 1e-6).name, unit);
  }
}

TEST(ReadableUnit, WritesSquares) { EXPECT_EQ(readable_unit("N m^2", 7e-9).name, "nN m²"); }

TEST(ReadableAxis, ScalesTheTracesOfItsAxisAlone) {
  Figure figure;
  figure.traces = {{{"x", {1, 2}}, {"y", {0.001, nullptr}}},
                   {{"x", {1, 2}}, {"y", {-0.0028, 0.002}}},
                   {{"x", {1, 2}}, {"y", {40, 50}}, {"yaxis", "y2"}}};
  set_readable_axis(figure, 'y', {"Moment per width", "N"});
  EXPECT_EQ(figure.layout.at("yaxis").at("title").at("text"), "Moment per width (mN)");
  EXPECT_EQ(figure.traces[0].at("y"), nlohmann::json({1.0, nullptr}));
  EXPECT_EQ(figure.traces[1].at("y"), nlohmann::json({-2.8, 2.0}));
  EXPECT_EQ(figure.traces[2].at("y"), nlohmann::json({40, 50}));
}

}  // namespace
}  // namespace pliant::report
