#include "pliant/estimation/verdict.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/estimation/fit_result.h"

namespace pliant {
namespace {

using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

ExperimentResult experiment(const std::string& name, double percent,
                            ExperimentRole role = ExperimentRole::fit) {
  ExperimentResult e;
  e.name = e.component = name;
  e.quantity = {"force_N", "force", "N", 1};
  e.rms_percent = percent;
  e.role = role;
  e.unloads = true;
  return e;
}

ParameterEstimate parameter(const std::string& name, bool identified) {
  ParameterEstimate p;
  p.name = name;
  p.owner = "stretch.bias";
  p.identified = identified;
  p.of_friction = name.find(".friction.") != std::string::npos;
  return p;
}

StudyResult result_of(std::vector<ExperimentResult> experiments,
                      std::vector<ParameterEstimate> parameters = {}) {
  StudyResult result;
  result.experiments = std::move(experiments);
  result.parameters = std::move(parameters);
  return result;
}

std::string verdict_of(const StudyResult& result, const Acceptance& accept = {}) {
  return verdict(result, accept, /*evaluation=*/false);
}

TEST(Verdict, TellsOfSheetsBesideStripsByTheirDistance) {
  ExperimentResult sheet = experiment("overhang", 1);
  sheet.sheet.emplace();
  sheet.quantity = {"height_mm", "distance", "mm", 1e3};
  sheet.rms = 0.17e-3;
  EXPECT_THAT(
      verdict_of(result_of({experiment("a", 1.4), sheet})),
      HasSubstr("In 1 experiment the sheets lie within 0.17 mm (RMS) of the predicted ones"));
}

TEST(Verdict, CountsFitsAndPredictionsWithTheirLargestErrors) {
  EXPECT_EQ(verdict_of(result_of({experiment("a", 1.4), experiment("b", 0.6),
                                  experiment("c", 3.0, ExperimentRole::validate),
                                  experiment("d", 5.7, ExperimentRole::validate)})),
            "The material reproduces 2 of 2 fitted experiments within 1.4 % of peak force. "
            "2 validation experiments are predicted within 5.7 % of peak force.");
}

TEST(Verdict, NamesAFittedExperimentThatIsNotReproduced) {
  EXPECT_EQ(verdict_of(result_of({experiment("a", 1.4), experiment("b", 12.0)})),
            "The material reproduces 1 of 2 fitted experiments within 1.4 % of peak force, but not "
            "b (12 %).");
}

TEST(Verdict, TakesForReproducedWhatTheStudyAccepts) {
  EXPECT_EQ(verdict_of(result_of({experiment("a", 1.4), experiment("b", 12.0)}), {.rms = 0.15}),
            "The material reproduces 2 of 2 fitted experiments within 12 % of peak force.");
}

TEST(Verdict, CutsALongListOfMisses) {
  StudyResult result = result_of({experiment("good", 1.0)});
  for (const char* name : {"a", "b", "c", "d", "e", "f"}) {
    result.experiments.push_back(experiment(name, 12.0));
  }
  EXPECT_THAT(verdict_of(result), HasSubstr("but not a (12 %), b (12 %), c (12 %) and 3 more."));
}

TEST(Verdict, SaysWhenNothingIsReproduced) {
  EXPECT_EQ(verdict_of(result_of({experiment("a", 31.0)})),
            "The material reproduces none of 1 fitted experiment within 5 % of peak force; the RMS "
            "error reaches 31 %.");
}

TEST(Verdict, AFitThatDidNotConvergeSaysSoFirst) {
  StudyResult result = result_of({experiment("a", 1.0)});
  result.converged = false;
  EXPECT_THAT(verdict_of(result), StartsWith("The fit did not converge"));
}

TEST(Verdict, AnEvaluationPredictsAndFitsNothing) {
  EXPECT_EQ(verdict(result_of({experiment("a", 4.0)}), {}, /*evaluation=*/true),
            "1 experiment is predicted within 4 % of peak force.");
}

TEST(Verdict, TakesLengthsAsPercentageOfTheirRange) {
  ExperimentResult lengths = experiment("a", 1.4);
  lengths.quantity = {"length_mm", "length", "mm", 1e3};
  EXPECT_EQ(verdict_of(result_of({lengths})),
            "The material reproduces 1 of 1 fitted experiment within 1.4 % of the range "
            "of the lengths.");
}

TEST(Verdict, GivesLengthsWithoutRangeInMillimetres) {
  ExperimentResult lengths = experiment("a", std::numeric_limits<double>::infinity());
  lengths.quantity = {"length_mm", "length", "mm", 1e3};
  lengths.rms = 0.113e-3;
  EXPECT_EQ(verdict_of(result_of({lengths})),
            "In 1 experiment the RMS error of the lengths is at most 0.11 mm.");
}

TEST(Verdict, SaysWhatTheDataDoNotDetermine) {
  EXPECT_THAT(verdict_of(result_of({}, {parameter("stretch.bias.friction.a", false)})),
              HasSubstr("The data do not determine friction of stretch.bias."));
}

TEST(Verdict, SaysNothingWithoutExperiments) { EXPECT_THAT(verdict_of(result_of({})), IsEmpty()); }

TEST(Undetermined, NamesAWholeGroupOnce) {
  EXPECT_THAT(undetermined(result_of({}, {parameter("stretch.bias.k1", true),
                                          parameter("stretch.bias.friction.a", false),
                                          parameter("stretch.bias.friction.b", false)}),
                           false),
              ElementsAre("friction of stretch.bias"));
}

TEST(Undetermined, NamesSingleParametersOfAGroup) {
  EXPECT_THAT(undetermined(result_of({}, {parameter("stretch.bias.friction.a", true),
                                          parameter("stretch.bias.friction.b", false)}),
                           false),
              ElementsAre("stretch.bias.friction.b"));
}

TEST(Undetermined, NamesFrictionOfDataThatNeverUnload) {
  StudyResult result = result_of({experiment("stretch.warp", 1.0)});
  result.experiments[0].unloads = false;
  EXPECT_THAT(undetermined(result, false), ElementsAre("friction of stretch.warp"));
  EXPECT_THAT(undetermined_with_reasons(result, false),
              ElementsAre("friction of stretch.warp: its data never unload"));
}

TEST(Undetermined, TakesTheReasonsOfTheFitAndWhatElseItNames) {
  StudyResult result = result_of({}, {parameter("stretch.bias.friction.a", false),
                                      parameter("stretch.bias.friction.b", true)});
  result.undetermined = {"stretch.bias.friction.a (its 95 % interval includes zero)",
                         "stretch.bias.friction.b (the data pushes it to its bound)"};
  EXPECT_THAT(undetermined_with_reasons(result, false), ElementsAreArray(result.undetermined));
}

TEST(Undetermined, LeavesFixedParametersOut) {
  ParameterEstimate fixed = parameter("stretch.bias.k1", false);
  fixed.fixed = true;
  EXPECT_THAT(undetermined(result_of({}, {fixed}), false), IsEmpty());
}

}  // namespace
}  // namespace pliant
