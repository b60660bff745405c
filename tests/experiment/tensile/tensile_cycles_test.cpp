#include "pliant/experiment/tensile/tensile_cycles.h"

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/math/check_derivatives.h"

#include "io/input_error_of.h"
#include "support/random_laws.h"
#include "support/study_folder.h"

namespace pliant {
namespace {

using test::parameter_scales;
using test::random_law;
using test::StudyFolder;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string entry(const std::string& more = "") {
  return "{name: warp, type: tensile-cycles, direction: warp, data: t.csv, length: 80 mm, "
         "width: 50 mm" +
         more + "}";
}

/// Two sparse cycles from the gauge length.
constexpr const char* kCycles =
    "force_N,length_mm,cycle\n"
    "0,80,1\n1,84,1\n2,88,1\n0.5,83,1\n0.1,80.5,1\n"
    "1,85,2\n3,92,2\n1,86,2\n0.1,81,2\n";
const std::vector<double> kCycleLengths{80, 84, 88, 83, 80.5, 85, 92, 86, 81};

const ComponentLaw kLaw = [] {
  RandomStream random(71);
  return random_law(random, CurveKind::affine);
}();

std::vector<std::string> nuisance_names(const ComponentExperiment& experiment) {
  std::vector<std::string> names;
  for (const NuisanceParameter& nuisance : experiment.nuisance()) names.push_back(nuisance.name);
  return names;
}

Eigen::VectorXd no_nuisance(const ComponentExperiment& experiment) {
  return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(experiment.nuisance().size()));
}

TEST(TensileCycles, TurnsRoundAPullThatIsCountedNegative) {
  const StudyFolder folder;
  folder.write("t.csv", "force_N,extension_mm\n0.01,0\n-1,-4\n-2,-8\n-0.5,-3\n");
  const auto experiment = folder.experiment(entry());
  EXPECT_EQ(experiment->measured()(2), 2);
  EXPECT_DOUBLE_EQ(experiment->loop(experiment->measured())->abscissa(2), 0.088);
  EXPECT_THAT(experiment->info().handled, Contains(HasSubstr("count a pull negative")));
  EXPECT_THAT(experiment->info().questions, IsEmpty());
}

TEST(TensileCycles, RefusesAnExtensionAloneThatIsCountedNegative) {
  const StudyFolder folder;
  folder.write("t.csv", "force_N,extension_mm\n0,0\n1,-4\n2,-8\n0.5,-3\n");
  EXPECT_THAT(test::input_error_of([&] { folder.experiment(entry()); }).what(),
              HasSubstr("t.csv:4: extension: a pull is counted negative, and its force is not"));
}

TEST(TensileCycles, ReadsTheDocumentedColumns) {
  const StudyFolder folder;
  folder.write("t.csv", kCycles);
  const auto experiment = folder.experiment(entry());
  EXPECT_EQ(experiment->rows(), 9);
  EXPECT_EQ(experiment->measured()(6), 3);
  EXPECT_EQ(experiment->info().component, "stretch.warp");
  EXPECT_EQ(experiment->info().quantity.name, "force_N");
  EXPECT_THAT(experiment->info().used, Each(1));
  EXPECT_THAT(experiment->info().warnings, IsEmpty());
  EXPECT_DOUBLE_EQ(experiment->loop(experiment->measured())->abscissa(6), 0.092);
  EXPECT_THAT(experiment->path().direction, ElementsAre(1, 1, 1, -1, -1, 1, 1, -1, -1));
  EXPECT_THAT(experiment->path().anchor, ElementsAre(0, 0, 0, 2, 2, 4, 4, 6, 6));
}

TEST(TensileCycles, ExtensionIsLengthLessTheGaugeLength) {
  const StudyFolder folder;
  folder.write("t.csv", "Load [cN];extension_mm\n0;-1,5\n100;4\n200;8,25\n");
  const auto experiment = folder.experiment(
      "{name: warp, type: tensile-cycles, direction: warp, length: 80 mm, width: 50 mm, "
      "data: {file: t.csv, columns: {force: \"Load [cN]\"}}}");
  const LoopSeries loop = *experiment->loop(experiment->measured());
  EXPECT_NEAR(loop.abscissa(0), 0.0785, 1e-16);
  EXPECT_NEAR(loop.abscissa(2), 0.08825, 1e-16);
  EXPECT_NEAR(loop.ordinate(2), 2, 1e-15);
}

TEST(TensileCycles, PredictsTheForceOfAPulledStrip) {
  const StudyFolder folder;
  folder.write("t.csv", kCycles);
  const auto experiment = folder.experiment(entry(", initial_friction: rest"));
  const auto prediction = experiment->predict(kLaw, Eigen::VectorXd::Constant(1, 0.2), false);
  ASSERT_TRUE(prediction);
  FrictionState state;
  for (Eigen::Index row = 0; row < 7; ++row) {  // up to the second peak it is never slack
    const double stretch = kCycleLengths[static_cast<size_t>(row)] / 80;
    const double strain = (stretch * stretch - 1) / 2;
    state = {strain, kLaw.friction_stress(strain, state).stress};
    const double stress = kLaw.elastic_stress(strain) + state.stress;
    if (stress < 0) break;
    EXPECT_NEAR(prediction->value(row), 0.05 * stretch * stress + 0.2, 1e-12);  // rounding
    EXPECT_NEAR(prediction->strain(row), strain, 1e-14);
  }
  EXPECT_EQ(prediction->length_gain.size(), 9);
}

TEST(TensileCycles, NuisanceIsWhatTheStudyLeavesUnknown) {
  const StudyFolder folder;
  folder.write("t.csv", kCycles);
  EXPECT_THAT(nuisance_names(*folder.experiment(entry())),
              ElementsAre("warp.force_offset", "warp.initial_friction"));
  EXPECT_THAT(nuisance_names(*folder.experiment(entry(", initial_friction: rest"))),
              ElementsAre("warp.force_offset"));
  EXPECT_THAT(nuisance_names(*folder.experiment(entry(", pretension: 0.1 N"))),
              ElementsAre("warp.force_offset", "warp.rest_length_change", "warp.initial_friction"));
  EXPECT_THAT(nuisance_names(*folder.experiment(entry(", pretension: 0.1 N, rest_length: known"))),
              ElementsAre("warp.force_offset", "warp.initial_friction"));
}

TEST(TensileCycles, EachSpecimenHasItsOwnNuisanceAndState) {
  const StudyFolder folder;
  folder.write("t.csv",
               "specimen,force_N,length_mm\nA,0,80\nA,2,88\nA,0.1,81\nB,0,80\nB,2,88\nB,0.1,81\n");
  const auto experiment = folder.experiment(entry());
  EXPECT_THAT(nuisance_names(*experiment),
              ElementsAre("warp.A.force_offset", "warp.A.initial_friction", "warp.B.force_offset",
                          "warp.B.initial_friction"));
  const auto prediction = experiment->predict(kLaw, Eigen::Vector4d(0.1, 0, 0.3, 0), false);
  ASSERT_TRUE(prediction);
  const Eigen::VectorXd difference = prediction->value.tail(3) - prediction->value.head(3);
  EXPECT_LT((difference.array() - 0.2).abs().maxCoeff(), 1e-14);  // rounding
}

TEST(TensileCycles, NuisanceStartsWithinItsBounds) {
  const StudyFolder folder;
  folder.write("t.csv", kCycles);
  const auto experiment = folder.experiment(entry(", pretension: 0.1 N"));
  for (const NuisanceParameter& nuisance : experiment->nuisance()) {
    SCOPED_TRACE(nuisance.name);
    EXPECT_LT(nuisance.lower, nuisance.upper);
    EXPECT_GE(nuisance.start, nuisance.lower);
    EXPECT_LE(nuisance.start, nuisance.upper);
    EXPECT_GT(nuisance.scale, 0);
    EXPECT_FALSE(nuisance.unit.empty());
  }
}

/// A dense cycle that starts with six slack rows under a force offset of 0.25 N.
std::string slack_csv() {
  std::string text = "force_N,length_mm\n";
  for (int i = 0; i <= 40; ++i) {
    const double length = 78 + 0.25 * i;
    text += fmt::format("{},{}\n", 0.25 + std::max(0.0, length - 80) * 0.3, length);
  }
  for (int i = 39; i >= 8; --i) text += fmt::format("{},{}\n", 0.25, 78 + 0.25 * i);
  return text;
}

TEST(TensileCycles, ReadsTheForceOffsetOffTheSlackRows) {
  const StudyFolder folder;
  folder.write("t.csv", slack_csv());
  const auto experiment = folder.experiment(entry());
  EXPECT_NEAR(experiment->unfitted_nuisance(kLaw)(0), 0.25, 1e-15);
  EXPECT_EQ(experiment->unfitted_nuisance(kLaw)(1), 0);
  EXPECT_NEAR(experiment->nuisance()[0].start, 0.25, 1e-15);
  EXPECT_THAT(experiment->info().handled, Contains(HasSubstr("slack")));
  const auto prediction = experiment->predict(kLaw, experiment->unfitted_nuisance(kLaw), false);
  EXPECT_NEAR(prediction->value(0), 0.25, 1e-15);
}

TEST(TensileCycles, WithoutSlackTheOffsetIsNotReadOff) {
  const StudyFolder folder;
  folder.write("t.csv", kCycles);
  const auto experiment = folder.experiment(entry());
  EXPECT_EQ(experiment->unfitted_nuisance(kLaw), no_nuisance(*experiment));
}

TEST(TensileCycles, PreconditioningCyclesAreCarriedAndNotFitted) {
  const StudyFolder folder;
  folder.write("t.csv", kCycles);
  const auto all = folder.experiment(entry());
  const auto experiment = folder.experiment(entry(", precondition_cycles: 1"));
  EXPECT_THAT(experiment->info().used, ElementsAre(0, 0, 0, 0, 0, 1, 1, 1, 1));
  EXPECT_EQ(experiment->predict(kLaw, no_nuisance(*experiment), false)->value,
            all->predict(kLaw, no_nuisance(*all), false)->value);
  EXPECT_THAT(experiment->info().handled, Contains(HasSubstr("first 1 cycle")));
}

TEST(TensileCycles, PreconditioningIsOfEverySpecimen) {
  const StudyFolder folder;
  folder.write("t.csv",
               "specimen,force_N,length_mm\nA,0,80\nA,2,88\nA,0.1,81\nA,2,88\nA,0.1,81\n"
               "B,0,80\nB,2,88\nB,0.1,81\nB,2,88\nB,0.1,81\n");
  EXPECT_THAT(folder.experiment(entry(", precondition_cycles: 1"))->info().used,
              ElementsAre(0, 0, 0, 1, 1, 0, 0, 0, 1, 1));
}

TEST(TensileCycles, FrictionOfTheApparatusOpposesTheClamps) {
  const StudyFolder folder;
  folder.write("t.csv", kCycles);
  const auto ideal = folder.experiment(entry());
  const auto real = folder.experiment(entry(", apparatus_friction: 0.1 N"));
  const Eigen::VectorXd difference = real->predict(kLaw, no_nuisance(*real), false)->value -
                                     ideal->predict(kLaw, no_nuisance(*ideal), false)->value;
  const std::vector<int>& direction = real->path().direction;
  for (size_t i = 0; i < direction.size(); ++i) {
    EXPECT_NEAR(difference(static_cast<Eigen::Index>(i)), 0.1 * direction[i], 1e-15);
    EXPECT_NEAR(ideal->path().force[i] - real->path().force[i], 0.1 * direction[i], 1e-15);
  }
  EXPECT_THAT(real->info().handled, Contains(HasSubstr("0.1 N")));
  EXPECT_THAT(ideal->info().handled,
              Contains(HasSubstr("friction of the apparatus is not stated")));
}

TEST(TensileCycles, DerivativesAreThoseOfDifferences) {
  const StudyFolder folder;
  std::string text = "specimen,force_N,length_mm\n";
  for (const char* specimen : {"A", "B"}) {
    for (const double length : kCycleLengths) {
      text += fmt::format("{},{},{}\n", specimen, length - 80, length + (*specimen == 'A' ? 0 : 1));
    }
  }
  folder.write("t.csv", text);
  const auto experiment = folder.experiment(entry(", rest_length: unknown"));
  ASSERT_EQ(experiment->nuisance().size(), 6U);
  for (const FrictionLaw friction :
       {FrictionLaw::none, FrictionLaw::dahl, FrictionLaw::constant_slope}) {
    RandomStream random(72);
    const ComponentLaw law = random_law(random, CurveKind::hermite, friction);
    const int count = law.parameter_count();
    Eigen::VectorXd at(count + 6), scale(count + 6);
    at << law.parameters(), 0.05, -4e-4, 0.3, -0.1, -3e-4, 0.5;
    // Small changes: no row may pass the length at which the strip goes slack.
    scale << parameter_scales(law) * 0.01, 0.01, 1e-6, 1e-3, 0.01, 1e-6, 1e-3;
    const auto prediction = experiment->predict(law, at.tail(6), true);
    ASSERT_TRUE(prediction);
    const VectorFunction forces = [&](const Eigen::VectorXd& x) {
      return experiment->predict(law.with_parameters(x), x.tail(6), false)->value;
    };
    const DerivativeCheck check = check_derivatives(forces, prediction->jacobian, at, scale);
    // Differences over so small steps keep seven digits; a wrong term shows at 1e-3 and more.
    EXPECT_LT(check.error, 1e-6) << check.describe();
  }
}

TEST(TensileCycles, ExtraColumnsAreToldAndNobodyMustActOnThem) {
  const StudyFolder folder;
  folder.write("t.csv",
               "time_s,force_N,length_mm,extension_mm,operator\n0,0,80,0,KL\n1,2,88,8,KL\n"
               "2,0,81,1,KL\n");
  const ExperimentInfo info = folder.experiment(entry())->info();
  EXPECT_THAT(info.handled, Contains(HasSubstr("\"extension_mm\" is not used")));
  EXPECT_THAT(info.handled, Contains(HasSubstr("\"operator\" is not used")));
  EXPECT_THAT(info.warnings, IsEmpty());
  EXPECT_EQ(info.columns.size(), 5U);
  EXPECT_THAT(info.time, ElementsAre(0, 1, 2));
}

TEST(TensileCycles, DenseReversalsBetweenSamplesAreToldAndTaken) {
  const StudyFolder folder;
  std::string text = "force_N,length_mm\n";
  // Turns at 90 mm, 0.1 mm beyond the last sample.
  for (int i = 0; i < 34; ++i) text += fmt::format("{},{}\n", i, 80 + 0.3 * i);
  for (int i = 0; i < 30; ++i) text += fmt::format("{},{}\n", 30 - i, 89.8 - 0.3 * i);
  folder.write("t.csv", text);
  EXPECT_THAT(folder.experiment(entry())->info().handled,
              Contains(AllOf(HasSubstr("between samples"), HasSubstr("0.1 mm"))));
}

TEST(TensileCycles, ValidationExperimentsAreNotFitted) {
  const StudyFolder folder;
  folder.write("t.csv", kCycles);
  EXPECT_EQ(folder.experiment(entry())->info().role, ExperimentRole::fit);
  EXPECT_EQ(folder.experiment(entry(), "validate: [\"w*\"]\n")->info().role,
            ExperimentRole::validate);
}

}  // namespace
}  // namespace pliant
