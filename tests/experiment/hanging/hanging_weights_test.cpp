#include "pliant/experiment/hanging/hanging_weights.h"

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/quantity.h"
#include "pliant/base/random.h"
#include "pliant/experiment/hanging/weight_path.h"
#include "pliant/math/check_derivatives.h"

#include "support/random_laws.h"
#include "support/study_folder.h"

namespace pliant {
namespace {

using test::parameter_scales;
using test::random_law;
using test::StudyFolder;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* kCsv =
    "repeat,peak_N,step,weight_N,length_mm\n"
    "1,1,0,0,100\n1,1,1,1,103\n1,1,2,0,101\n"
    "1,2,0,0,101\n1,2,1,1,103.2\n1,2,2,2,105\n1,2,3,1,104\n1,2,4,0,101.5\n"
    "2,1,0,0,101.4\n2,1,1,1,103.4\n2,1,2,0,101.5\n";

std::string entry(const std::string& more = "") {
  return "{name: warp, type: hanging-weights, direction: warp, data: w.csv, length: 100 mm, "
         "width: 80 mm" +
         more + "}";
}

std::vector<double> forces_of(const ComponentExperiment& experiment) {
  const LoopSeries loop = *experiment.loop(experiment.measured());
  return {loop.ordinate.begin(), loop.ordinate.end()};
}

const ComponentLaw kLaw = [] {
  RandomStream random(51);
  return random_law(random, CurveKind::affine);
}();

TEST(HangingWeights, ReadsTheDocumentedColumns) {
  const StudyFolder folder;
  folder.write("w.csv", kCsv);
  const auto experiment = folder.experiment(entry());
  EXPECT_EQ(experiment->rows(), 11);
  EXPECT_NEAR(experiment->measured()(4), 0.1032, 1e-16);
  EXPECT_EQ(experiment->info().component, "stretch.warp");
  EXPECT_EQ(experiment->info().quantity.name, "length_mm");
  EXPECT_EQ(experiment->info().quantity.per_si, 1e3);
  EXPECT_THAT(experiment->info().specimens, ElementsAre("w"));
  EXPECT_THAT(experiment->info().used, Each(1));
  EXPECT_THAT(experiment->info().warnings, IsEmpty());
  EXPECT_TRUE(experiment->nuisance().empty());
  const auto loop = experiment->loop(experiment->measured());
  EXPECT_DOUBLE_EQ(loop->width, 0.08);
  EXPECT_DOUBLE_EQ(loop->length, 0.1);
}

TEST(HangingWeights, ClipAndHalfOfTheClothHangToo) {
  const StudyFolder folder;
  folder.write("w.csv", kCsv);
  const std::vector<double> forces = forces_of(*folder.experiment(entry(", clip_mass: 20 g")));
  const double added = (0.020 + 0.15 * 0.1 * 0.08 / 2) * kStandardGravity;
  EXPECT_DOUBLE_EQ(forces[0], added);
  EXPECT_DOUBLE_EQ(forces[5], 2 + added);
}

TEST(HangingWeights, WeightsMayBeMassesAndLengthsCentimetresWithDecimalCommas) {
  const StudyFolder folder;
  folder.write("w.csv", "weight_g;length_cm\n0;10,0\n50,5;10,25\n0;10,05\n");
  const auto experiment = folder.experiment(entry());
  const std::vector<double> forces = forces_of(*experiment);
  EXPECT_NEAR(forces[1] - forces[0], 0.0505 * kStandardGravity, 1e-15);
  EXPECT_NEAR(experiment->measured()(1), 0.1025, 1e-16);
}

TEST(HangingWeights, PredictsTheLengthUnderEachWeight) {
  const StudyFolder folder;
  folder.write("w.csv", kCsv);
  const auto experiment = folder.experiment(entry(", clip_mass: 20 g"));
  const std::vector<double> forces = forces_of(*experiment);
  std::vector<char> rested(forces.size(), 0);
  rested[0] = 1;
  const auto hung = hang_weights(kLaw, {0.1, 0.08, MembraneMeasure::stvk}, forces, rested, false);
  const auto prediction = experiment->predict(kLaw, {}, false);
  ASSERT_TRUE(hung && prediction);
  EXPECT_EQ(prediction->value, hung->length);
  EXPECT_EQ(prediction->strain, hung->strain);
}

TEST(HangingWeights, TheStudysMembraneMeasureIsTheStrain) {
  const StudyFolder folder;
  folder.write("w.csv", kCsv);
  const auto experiment = folder.experiment(entry(), "model: {membrane: soft-constraint}\n");
  EXPECT_NEAR(experiment->path().strain[1], 0.03, 1e-14);  // 103 mm / 100 mm - 1
}

TEST(HangingWeights, DerivativesAreThoseOfDifferences) {
  const StudyFolder folder;
  folder.write("w.csv", kCsv);
  const auto experiment = folder.experiment(entry());
  const auto prediction = experiment->predict(kLaw, {}, true);
  ASSERT_TRUE(prediction);
  const VectorFunction lengths = [&](const Eigen::VectorXd& parameters) {
    return experiment->predict(kLaw.with_parameters(parameters), {}, false)->value;
  };
  const DerivativeCheck check = check_derivatives(lengths, prediction->jacobian, kLaw.parameters(),
                                                  parameter_scales(kLaw) * 0.1);
  // Differences of lengths that are exact to rounding; a wrong term shows at 1e-3 and more.
  EXPECT_LT(check.error, 1e-7) << check.describe();
}

TEST(HangingWeights, RestBetweenRepeatsStartsThemAfresh) {
  const StudyFolder folder;
  folder.write("w.csv", kCsv);
  const auto running = folder.experiment(entry())->predict(kLaw, {}, false);
  const auto rested = folder.experiment(entry(", rested: true"))->predict(kLaw, {}, false);
  ASSERT_TRUE(running && rested);
  EXPECT_EQ(rested->value.head(8), running->value.head(8));
  EXPECT_EQ(rested->value.tail(3), rested->value.head(3));
  EXPECT_GT(running->value(8), rested->value(8) + 1e-5);  // a persistent length is left
}

TEST(HangingWeights, EverySpecimenStartsAtRest) {
  const StudyFolder folder;
  folder.write("w.csv",
               "specimen,weight_N,length_mm\nA,0,100\nA,2,105\nA,0,101\n"
               "B,0,100\nB,2,106\nB,0,102\n");
  const auto experiment = folder.experiment(entry());
  EXPECT_THAT(experiment->info().specimens, ElementsAre("A", "B"));
  EXPECT_THAT(experiment->path().specimen, ElementsAre(0, 0, 0, 1, 1, 1));
  const auto prediction = experiment->predict(kLaw, {}, false);
  EXPECT_EQ(prediction->value.head(3), prediction->value.tail(3));
}

TEST(HangingWeights, AFileOfAPatternIsASpecimen) {
  const StudyFolder folder;
  folder.write("w-1.csv", "weight_N,length_mm\n0,100\n2,105\n0,101\n");
  folder.write("w-2.csv", "weight_N,length_mm\n0,100\n2,106\n0,102\n");
  const auto experiment = folder.experiment(
      "{name: warp, type: hanging-weights, direction: warp, data: \"w-*.csv\", "
      "length: 100 mm, width: 80 mm}");
  EXPECT_THAT(experiment->info().specimens, ElementsAre("w-1", "w-2"));
  EXPECT_EQ(experiment->rows(), 6);
}

TEST(HangingWeights, PathTellsDirectionsAndTurningPoints) {
  const StudyFolder folder;
  folder.write("w.csv", kCsv);
  const MeasuredPath path = folder.experiment(entry())->path();
  EXPECT_THAT(path.direction, ElementsAre(1, 1, -1, -1, 1, 1, -1, -1, -1, 1, -1));
  EXPECT_THAT(path.anchor, ElementsAre(0, 0, 1, 1, 3, 3, 5, 5, 5, 8, 9));
}

TEST(HangingWeights, ExcludedRowsStayOutOfTheFitWithTheirReason) {
  const StudyFolder folder;
  folder.write("w.csv", kCsv);
  const auto experiment = folder.experiment(
      entry(", exclude: [{rows: 2-4, reason: jaw slip}, {rows: 11, reason: draught}]"));
  EXPECT_THAT(experiment->info().used, ElementsAre(1, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0));
  EXPECT_THAT(experiment->info().handled, Contains(HasSubstr("rows 2-4 are left out: jaw slip")));
}

TEST(HangingWeights, KeepsItsOwnColumnsAndTellsWhichItDoesNotUse) {
  const StudyFolder folder;
  folder.write("w.csv", "time_s,weight_N,length_mm,remark\n0,0,100,\n60,1,103,slow\n120,0,101,\n");
  const ExperimentInfo info = folder.experiment(entry())->info();
  EXPECT_THAT(info.time, ElementsAre(0, 60, 120));
  EXPECT_THAT(info.handled, Contains(HasSubstr("\"remark\" is not used")));
  EXPECT_THAT(info.warnings, IsEmpty()) << "nobody must act on it";
  ASSERT_EQ(info.columns.size(), 4U);
  EXPECT_EQ(info.columns[3].header, "remark");
  EXPECT_THAT(info.columns[3].cells, ElementsAre("", "slow", ""));
}

TEST(HangingWeights, SaysWhatItDidNotKnow) {
  const StudyFolder folder;
  folder.write("w.csv", kCsv);
  const Study study = folder.study(entry());
  const ExperimentSpec& spec = study.experiments.front();
  const HangingWeights weightless(spec, DataRows(spec.data), ClothFacts());
  EXPECT_THAT(weightless.info().warnings, Contains(HasSubstr("no density is given")));
  const auto of_length = [&](const char* length) {
    return folder
        .experiment(fmt::format(
            "{{name: warp, type: hanging-weights, direction: warp, data: w.csv, length: {}, "
            "width: 80 mm}}",
            length))
        ->info();
  };
  EXPECT_THAT(of_length("115 mm").warnings, Contains(HasSubstr("far below the gauge length")));
  // A gauge length that cannot be right.
  EXPECT_THAT(of_length("200 mm").questions,
              ElementsAre(HasSubstr("the clamps start at 50 % of the gauge length: are the numbers "
                                    "and units of `length` right?")));
}

TEST(HangingWeights, HasNoPredictionForALawThatCannotCarryTheWeights) {
  const StudyFolder folder;
  folder.write("w.csv", kCsv);
  ComponentLaw weak;
  weak.stiffness = ScalarCurve::constant(1e-4);
  EXPECT_FALSE(folder.experiment(entry())->predict(weak, {}, false));
}

TEST(HangingWeights, CarriesTheStatedNoise) {
  const StudyFolder folder;
  folder.write("w.csv", kCsv);
  const ExperimentInfo info = folder.experiment(entry(", noise: {length: 0.2 mm}"))->info();
  EXPECT_DOUBLE_EQ(info.length_noise.value(), 2e-4);
  EXPECT_FALSE(info.force_noise);
}

}  // namespace
}  // namespace pliant
