// Bending lengths as experiments of a study.

#include "pliant/experiment/bending_length/overhangs.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/quantity.h"
#include "pliant/experiment/bending_length/bending_length.h"
#include "pliant/experiment/loop_metrics.h"
#include "pliant/material/bending_strain.h"

#include "io/input_error_of.h"
#include "support/study_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::StudyFolder;
using ::testing::Contains;
using ::testing::HasSubstr;

constexpr double kWeight = 0.15 * kStandardGravity;  // of StudyFolder's fabric

ComponentLaw elastic(double k) {
  ComponentLaw law;
  law.stiffness = ScalarCurve::constant(k);
  return law;
}

std::unique_ptr<ComponentExperiment> readings(const StudyFolder& folder, const std::string& csv,
                                              const std::string& more = "") {
  folder.write("data.csv", csv);
  return folder.experiment("{name: l, type: bending-length, direction: weft, data: data.csv" +
                           more + "}");
}

TEST(Overhangs, AreOfBendingInTheirDirection) {
  const StudyFolder folder;
  const auto experiment = readings(folder, "overhang_mm,face,repeat\n46,1,1\n45,bottom,1\n");
  EXPECT_EQ(experiment->info().component, "bend.weft");
  EXPECT_EQ(experiment->info().quantity.name, "overhang_mm");
  EXPECT_DOUBLE_EQ(experiment->measured()(1), 0.045);
  EXPECT_DOUBLE_EQ(experiment->reference(), 0.0455);
  EXPECT_TRUE(experiment->info().warnings.empty());
}

// A strip of rigidity B hangs out by 2.0003 (B / weight)^(1/3), whatever its face.
TEST(Overhangs, ArePredictedByTheHeavyElastica) {
  const StudyFolder folder;
  const auto experiment = readings(folder, "overhang_mm,face\n46,1\n45,2\n");
  const double k = 4e-6;
  const auto prediction = experiment->predict(elastic(k), {}, true);
  ASSERT_TRUE(prediction);
  const double expected = std::cbrt(8.0042 * 3 * k / kWeight);
  EXPECT_NEAR(prediction->value(0), expected, 1e-5 * expected);
  EXPECT_NEAR(prediction->value(1), expected, 1e-5 * expected);
  EXPECT_LT(prediction->strain(0), 0);
  EXPECT_GT(prediction->strain(1), 0);
  EXPECT_NEAR(prediction->jacobian(0, 0), expected / (3 * k), 1e-5 * expected / (3 * k));
}

// The rows of the path say what bent a strip of one rigidity: moment over strain is that rigidity.
TEST(Overhangs, TellARigidityWithoutAFit) {
  const StudyFolder folder;
  const double k = 4e-6;
  for (const char* degrees : {"20", "41.5", "60"}) {
    const double angle = std::stod(degrees) * std::numbers::pi / 180;
    const auto strip = bending_length(elastic(k), 0.15, angle);
    const auto experiment =
        readings(folder, "overhang_m\n" + std::to_string(1e6 * strip->overhang) + "e-6\n",
                 std::string(", angle: ") + degrees + " deg");
    const MeasuredPath& path = experiment->path();
    EXPECT_NEAR(path.force[0] / path.strain[0], k, 1e-5 * k) << degrees;  // digits of the table
    const auto predicted = experiment->predict(elastic(k), {}, false);
    EXPECT_NEAR(path.strain[0], -predicted->strain(0), 1e-5 * path.strain[0]) << degrees;
    EXPECT_FALSE(unloads(path));
  }
}

TEST(Overhangs, TellTheirSpreadAsTheStandardsDo) {
  const StudyFolder folder;
  const auto experiment =
      readings(folder, "overhang_mm,face,repeat\n48,1,1\n52,1,2\n38,2,1\n42,2,2\n");
  // Of 48 and 52 mm: mean 25 mm, standard deviation sqrt(2) mm.
  EXPECT_THAT(experiment->info().handled,
              Contains(HasSubstr("face 1, 2 readings: bending length 25 mm (coefficient of "
                                 "variation 5.7 %)")));
  EXPECT_THAT(experiment->info().handled, Contains(HasSubstr("face 2, 2 readings: ")));
  EXPECT_THAT(experiment->info().handled, Contains(HasSubstr("both faces, 4 readings: ")));
}

TEST(Overhangs, NeedTheDensity) {
  const StudyFolder folder;
  folder.write("data.csv", "overhang_mm\n46\n");
  Study study = folder.study("{name: l, type: bending-length, direction: warp, data: data.csv}");
  study.density = 0;
  const InputError error =
      input_error_of([&] { read_experiment(study.experiments.front(), study); });
  EXPECT_EQ(error.where().line, 5);
  EXPECT_THAT(error.problem(), HasSubstr("states no density"));
  EXPECT_THAT(error.expected(), HasSubstr("`density:` of the study"));
}

TEST(Overhangs, RefuseAnAngleThatNoStripDipsBy) {
  const StudyFolder folder;
  const InputError error =
      input_error_of([&] { readings(folder, "overhang_mm\n46\n", ", angle: 89.9 deg"); });
  EXPECT_EQ(error.where().field, "experiments[0].angle");
}

}  // namespace
}  // namespace pliant
