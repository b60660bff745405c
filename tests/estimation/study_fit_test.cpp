#include "pliant/study/study_fit.h"

#include <chrono>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/study/result_files.h"
#include "pliant/study/study_evaluation.h"

#include "estimation/virtual_study.h"
#include "io/input_error_of.h"

namespace pliant {
namespace {

using test::estimate_named;
using test::hung_weights;
using test::lab_of;
using test::published_fabric;
using test::strip_cycles;
using test::VirtualStudy;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

/// A fabric that is polyester along the warp and cotton along the weft, hung and pulled, with
/// noise.
VirtualLab both_directions() {
  VirtualLab lab;
  lab.name = "both";
  lab.material = published_fabric("polyester");
  lab.material.components.at("stretch.weft") =
      published_fabric("cotton").components.at("stretch.warp");
  auto weights = hung_weights();
  weights.instrument.length_noise = 0.2e-3;
  auto cycles = strip_cycles({0.05, 0.1});
  cycles.direction = "weft";
  cycles.instrument.force_noise = 5e-3;
  lab.experiments = lab_of(lab.material, {weights, cycles}).experiments;
  return lab;
}

/// Everything that a fit would write, its duration taken out.
std::string all_results(StudyResult result) {
  result.seconds = 0;
  std::string text;
  for (const auto& [name, content] : fit_files(result, {})) text += name + "\n" + content;
  return text;
}

const StudyFitOptions kEverything{.compare_friction = true, .profiles = {"*"}};

TEST(StudyFit, GivesTheSameBitsTwice) {
  const VirtualStudy study(both_directions());
  EXPECT_EQ(all_results(study.fit(kEverything)), all_results(study.fit(kEverything)));
}

TEST(StudyFit, GivesTheSameBitsOnOneAndTwoThreads) {
  const VirtualStudy study(both_directions());
  EXPECT_EQ(all_results(study.fit(kEverything, 1)), all_results(study.fit(kEverything, 2)));
}

TEST(StudyFit, FitsEachComponentFromItsOwnExperiments) {
  const VirtualLab lab = both_directions();
  const StudyResult both = VirtualStudy(lab).fit();
  VirtualLab warp = lab;
  warp.experiments.pop_back();
  EXPECT_EQ(estimate_named(VirtualStudy(warp).fit(), "stretch.warp.k1").value,
            estimate_named(both, "stretch.warp.k1").value);
  EXPECT_EQ(both.material.components.at("shear").status, ComponentStatus::unmeasured);
  EXPECT_EQ(both.material.components.at("stretch.weft").status, ComponentStatus::measured);
  EXPECT_EQ(both.curves.size(), 2u);
}

TEST(StudyFit, OfABiasStripNamesTheFitThatTellsShear) {
  const auto way = Contains(HasSubstr("model: {strips: sheet}"));
  VirtualLab lab = both_directions();
  EXPECT_THAT(VirtualStudy(lab).fit().undetermined, Not(way));
  lab.material.components["stretch.bias"] = lab.material.components.at("stretch.weft");
  auto bias = strip_cycles({0.05, 0.1});
  bias.direction = "bias";
  lab.experiments = lab_of(lab.material, {bias}).experiments;
  EXPECT_THAT(VirtualStudy(lab).fit().undetermined, way);
}

TEST(StudyFit, NamesAllParametersAtTheirBoundsInOneWarning) {
  VirtualStudy study(both_directions());
  study.add("fit: {bounds: {stretch.warp.k1: [0.1, 0.2], stretch.weft.k: [0.1, 0.2]}}");
  EXPECT_THAT(study.fit().warnings,
              Contains(AllOf(HasSubstr("at their bounds"), HasSubstr("stretch.warp.k1"),
                             HasSubstr("stretch.weft.k")))
                  .Times(1));
}

TEST(StudyFit, NamesANumberOfAnExperimentAtItsBound) {
  VirtualStudy study(both_directions());
  study.add("fit: {bounds: {cycles.force_offset: [0.05, 0.1]}}");  // there is none
  const StudyResult result = study.fit();
  EXPECT_TRUE(estimate_named(result, "cycles.force_offset").at_bound);
  EXPECT_THAT(result.warnings,
              Contains(AllOf(HasSubstr("at their bounds"), HasSubstr("cycles.force_offset"))));
}

TEST(StudyFit, DoesNotDependOnTheOrderOfExperimentsInThePredictionOfEach) {
  VirtualLab lab = both_directions();
  const StudyResult one = VirtualStudy(lab).fit();
  std::swap(lab.experiments[0], lab.experiments[1]);
  const StudyResult other = VirtualStudy(lab).fit();
  EXPECT_EQ(estimate_named(one, "stretch.weft.friction.a").value,
            estimate_named(other, "stretch.weft.friction.a").value);
}

TEST(StudyFit, StopsWithinASecondWhenAsked) {
  // Hundreds of refits of 20,000 rows: half a minute of work.
  auto experiment = strip_cycles({0.02, 0.04, 0.06, 0.08, 0.1, 0.2});
  experiment.samples = 5000;
  experiment.instrument.force_noise = 5e-3;
  const VirtualStudy study(lab_of(published_fabric("spandex"), experiment));
  const Study read = study.study();
  StopFlag flag;
  RunContext context;
  context.stop = flag.token();
  std::chrono::steady_clock::time_point asked;
  std::thread user([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    asked = std::chrono::steady_clock::now();
    flag.request();
  });
  EXPECT_THROW(fit_study(read, kEverything, context), Interrupted);
  user.join();
  const std::chrono::duration<double> late = std::chrono::steady_clock::now() - asked;
  EXPECT_LT(late.count(), 1);  // the promise to the user at the keyboard
}

TEST(StudyFit, PredictsValidationExperimentsWithoutFittingThem) {
  VirtualLab lab = lab_of(published_fabric("polyester"), hung_weights());
  const StudyResult alone = VirtualStudy(lab).fit();
  lab.experiments.push_back(test::AnyTest(strip_cycles({0.1})).test);
  VirtualStudy study(lab);
  study.add("validate: [cycles]");
  const StudyResult result = study.fit();
  EXPECT_EQ(estimate_named(result, "stretch.warp.k1").value,
            estimate_named(alone, "stretch.warp.k1").value);
  EXPECT_TRUE(result.nuisance.empty());
  ASSERT_EQ(result.experiments.size(), 2u);
  EXPECT_EQ(result.experiments[1].role, ExperimentRole::validate);
  // The material is known to 1e-6, and so is its prediction.
  EXPECT_LT(result.experiments[1].rms_percent, 1e-3);
}

TEST(StudyFit, RefusesAStudyWithNothingToFit) {
  VirtualStudy study(lab_of(published_fabric("polyester"), hung_weights()));
  study.add("validate: ['*']");
  const InputError error = test::input_error_of([&] { study.fit(); });
  EXPECT_EQ(error.where().field, "experiments");
}

TEST(StudyFit, RefusesModelsOfSheetsForStripsInOneDimension) {
  const VirtualStudy made(lab_of(published_fabric("polyester"), hung_weights()));
  const auto refuses = [&](const auto& change, const char* field) {
    Study study = made.study();
    change(study.model);
    const InputError error = test::input_error_of([&] { fit_study(study, {}, {}); });
    EXPECT_EQ(error.where().field, field);
    EXPECT_THAT(error.expected(), HasSubstr("strips: sheet"));
  };
  refuses([](ModelOptions& model) { model.components["area"] = {}; }, "model.components.area");
  refuses([](ModelOptions& model) { model.limits = {{"stretch.warp"}}; }, "model.limits");
  refuses(
      [](ModelOptions& model) { model.components["stretch.warp"].stiffness = CurveKind::spline; },
      "model.components.stretch.warp.stiffness");
}

TEST(StudyFit, RefusesAPlanForStripsInOneDimension) {
  VirtualStudy study(lab_of(published_fabric("polyester"), hung_weights()));
  study.add("fit: {plan: [{components: [stretch.warp], experiments: [weights]}]}");
  const InputError error = test::input_error_of([&] { study.fit(); });
  EXPECT_EQ(error.where().file, (study.folder() / "study.yaml").string());
  EXPECT_GT(error.where().line, 0);
  EXPECT_EQ(error.where().field, "fit.plan[0]");
  EXPECT_THAT(error.expected(), HasSubstr("strips: sheet"));
}

TEST(Evaluation, GivesTheErrorsOfTheFit) {
  auto weights = hung_weights();
  weights.instrument.length_noise = 0.2e-3;
  const VirtualStudy study(lab_of(published_fabric("polyester"), weights));
  const StudyResult fit = study.fit();
  const StudyResult evaluation = evaluate_study(study.study(), fit.material, {});
  ASSERT_EQ(evaluation.experiments.size(), 1u);
  // Without nuisance parameters there is nothing that evaluation does not know.
  EXPECT_DOUBLE_EQ(evaluation.experiments[0].rms, fit.experiments[0].rms);
  EXPECT_EQ(evaluation.experiments[0].predicted, fit.experiments[0].predicted);
}

TEST(Evaluation, RefusesAMaterialWithoutTheComponent) {
  VirtualStudy study(lab_of(published_fabric("polyester"), hung_weights()));
  study.set_in_experiment("direction", "weft");
  const InputError error = test::input_error_of(
      [&] { evaluate_study(study.study(), published_fabric("polyester"), {}); });
  EXPECT_THAT(error.problem(), HasSubstr("stretch.weft"));
}

TEST(LoopMetrics, OfTheFitAreThoseOfTheData) {
  VirtualStudy study(lab_of(published_fabric("spandex"), strip_cycles({0.1, 0.2, 0.3})));
  study.set_model("stiffness: affine");
  const ExperimentResult experiment = study.fit().experiments.front();
  ASSERT_TRUE(experiment.measured_loop && experiment.predicted_loop);
  EXPECT_GT(experiment.measured_loop->loop_loss, 0.05);
  // Noise-free: equal to the accuracy of the fit, 1e-6.
  EXPECT_NEAR(experiment.predicted_loop->loop_loss, experiment.measured_loop->loop_loss, 1e-6);
  EXPECT_NEAR(experiment.predicted_loop->hysteresis_ratio,
              experiment.measured_loop->hysteresis_ratio, 1e-6);
}

// A load cell whose zero is off shifts all forces, and no loop is wider for it.
TEST(LoopMetrics, AreFreeOfAnOffsetOfTheForce) {
  VirtualStudy study(lab_of(published_fabric("spandex"), strip_cycles({0.1, 0.2, 0.3})));
  study.set_model("stiffness: affine");
  const ExperimentResult before = study.fit().experiments.front();
  study.edit_rows("cycles.csv", [](VirtualStudy::Rows& rows) {
    for (std::vector<double>& row : rows) row[0] += 0.03;
  });
  const ExperimentResult shifted = study.fit().experiments.front();
  ASSERT_TRUE(before.measured_loop && shifted.measured_loop && shifted.predicted_loop);
  for (const auto& loop : {shifted.measured_loop, shifted.predicted_loop}) {
    // Noise-free: the offset is found to 1e-6.
    EXPECT_NEAR(loop->loop_loss, before.measured_loop->loop_loss, 1e-6);
    EXPECT_NEAR(loop->hysteresis_ratio, before.measured_loop->hysteresis_ratio, 1e-6);
  }
}

}  // namespace
}  // namespace pliant
