#include "pliant/report/curve_figures.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pliant::report {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::StartsWith;

ComponentCurve cycle() {
  ComponentCurve curve;
  curve.component = "stretch.weft";
  curve.strain = {0.0, 0.1, 0.2};
  curve.load = {0.0, 12.0, 22.0};
  curve.unload = {-2.0, 8.0, 18.0};
  curve.elastic = {0.0, 10.0, 20.0};
  curve.max_friction = {2.0, 2.0, 2.0};
  return curve;
}

std::vector<std::string> groups(const Figure& figure) {
  std::vector<std::string> names;
  for (const auto& trace : figure.traces) names.push_back(trace.at("legendgroup"));
  return names;
}

TEST(SheetCurveFigure, DrawsACycleWhereTheComponentHasFriction) {
  const Figure figure = sheet_curve_figure(cycle(), {}, {});
  EXPECT_THAT(groups(figure), Contains("predicted-load"));
  EXPECT_THAT(groups(figure), Contains("predicted-unload"));
  EXPECT_EQ(figure.traces.back().at("y"), nlohmann::json({-2.0, 8.0, 18.0}));
}

TEST(SheetCurveFigure, DrawsOneLineWithoutFriction) {
  ComponentCurve curve = cycle();
  curve.max_friction = {0.0, 0.0, 0.0};
  const Figure figure = sheet_curve_figure(curve, {}, {});
  ASSERT_EQ(figure.traces.size(), 1U);
  EXPECT_EQ(figure.traces.front().at("y"), nlohmann::json({0.0, 10.0, 20.0}));
}

TEST(FrictionFigure, IsTheDistanceOfTheBranchesFromTheElasticPart) {
  const Figure figure = friction_figure(cycle(), {});
  EXPECT_THAT(groups(figure), Contains("predicted-unload"));
  EXPECT_EQ(figure.traces.back().at("y"), nlohmann::json({-2.0, -2.0, -2.0}));
}

TEST(StressStrainFigure, LeavesFrictionOutThatTheDataDoNotDetermine) {
  EXPECT_THAT(groups(stress_strain_figure(cycle(), {}, {}, false)), Each(StartsWith("elastic")));
}

}  // namespace
}  // namespace pliant::report
