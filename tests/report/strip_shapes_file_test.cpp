#include "pliant/report/strip_shapes_file.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/report/shape_figures.h"
#include "pliant/report/shape_part.h"

#include "report/sample_results.h"

namespace pliant::report {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::TemporaryFolder;
using testing::write_text;

constexpr const char* kHeader =
    "series,radius_mm,profile,specimen,arc_length_mm,x_mm,y_mm,curvature_1_per_m,moment_N,"
    "distance_mm,used\n";

/// Two cylinders, the larger one with two repeats, one point of it left out.
constexpr const char* kRows =
    "measured,20,1,A,0,0,0,30,0,0,0\n"
    "measured,20,1,A,10,9,3,30,0.001,0.1,1\n"
    "measured,20,2,A,0,0,0,31,0,0,0\n"
    "measured,20,2,A,10,8,3,31,0.002,-0.2,0\n"
    "measured,-5,3,A,0,0,0,-90,0,0,0\n"
    "measured,-5,3,A,10,1,-6,-90,0.001,0.05,1\n"
    "predicted,20,,,0,0,0,30,0.001,,\n"
    "predicted,20,,,10,9,3.1,29,0,,\n"
    "predicted,-5,,,0,0,0,-88,0.001,,\n"
    "predicted,-5,,,10,1,-6,-87,0,,\n"
    "bent,20,,,,,,0,0,,\n"
    "bent,20,,,,,,50,0.01,,\n";

StripShapes shapes_of(const std::string& rows) {
  const TemporaryFolder folder;
  write_text(folder.path() / "shapes.csv", kHeader + rows);
  return read_strip_shapes(folder.path() / "shapes.csv");
}

TEST(StripShapes, AreReadProfileByProfile) {
  const StripShapes shapes = shapes_of(kRows);
  EXPECT_EQ(shapes.setting, "radius");
  ASSERT_EQ(shapes.measured.size(), 3u);
  EXPECT_THAT(shapes.measured[1].x_mm, ElementsAre(0, 8));
  EXPECT_THAT(shapes.measured[1].used, ElementsAre(0, 0));
  EXPECT_EQ(shapes.predicted.size(), 2u);
  ASSERT_EQ(shapes.bent.size(), 1u);
  EXPECT_TRUE(std::isnan(shapes.bent[0].x_mm[0]));
  EXPECT_THAT(shapes.settings(), ElementsAre(-5, 20));
}

TEST(StripShapes, RefuseWhatTheFormatDoesNotKnow) {
  EXPECT_THROW(shapes_of("guessed,20,1,A,0,0,0,30,0,0,0\n"), InputError);
  EXPECT_THROW(shapes_of("measured,20,1,A,0,zero,0,30,0,0,0\n"), InputError);
}

TEST(ShapeFigures, ShowACircleAsACircle) {
  EXPECT_EQ(side_view(shapes_of(kRows), {20}, false).layout["yaxis"]["scaleanchor"], "x");
}

TEST(ShapeFigures, DrawTheAskedSettingAloneAndMarkWhatIsLeftOut) {
  const Figure view = side_view(shapes_of(kRows), {20}, false);
  ASSERT_EQ(view.traces.size(), 3u);
  EXPECT_THAT(view.traces[0]["x"], ElementsAre(9));
  EXPECT_EQ(view.traces[1]["name"], "left out");
  EXPECT_THAT(view.traces[1]["x"], ElementsAre(8));
  EXPECT_THAT(view.traces[2]["y"], ElementsAre(0, 3.1));
}

TEST(ShapeFigures, DrawThePathToTheCylinderUnderTheMoments) {
  const Figure figure = moment_figure(shapes_of(kRows));
  // Points of both settings, and the path of the one that has it.
  ASSERT_EQ(figure.traces.size(), 3u);
  EXPECT_THAT(figure.traces[2]["x"], ElementsAre(0, 50));
}

TEST(ShapeFigures, ChooseTheSmallestTheMiddleAndTheLargestOfMany) {
  StripShapes shapes;
  shapes.setting = "overhang";
  for (const double setting : {70.0, 30.0, 100.0, 40.0, 90.0}) {
    shapes.predicted.emplace_back().setting_mm = setting;
  }
  EXPECT_THAT(chosen_settings(shapes), ElementsAre(30, 70, 100));
}

TEST(ShapePart, DrawsEverySettingAndExplainsTheTest) {
  FigureSheet figures(/*can_draw=*/true);
  ResultExperiment experiment;
  experiment.name = "rolls";
  experiment.shape_file = "shapes/rolls.csv";
  const std::string html = shape_part(experiment, shapes_of(kRows), figures);
  for (const char* text :
       {"rolled around a cylinder", "radius -5 mm", "radius 20 mm", "Curvature along the strip",
        "Moment over curvature", "shapes/rolls.csv"}) {
    EXPECT_THAT(html, HasSubstr(text));
  }
  EXPECT_THAT(html, Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace pliant::report
