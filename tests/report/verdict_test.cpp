#include "pliant/report/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pliant::report {
namespace {

using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

ResultExperiment experiment(const std::string& name, double percent, bool validation = false) {
  ResultExperiment e;
  e.name = name;
  e.rms_percent_of_peak = percent;
  e.validation = validation;
  e.component = name;
  e.quantity = "force_N";
  e.measured_loop = LoopMeasures{};
  return e;
}

ResultParameter parameter(const std::string& name, bool identified) {
  ResultParameter p;
  p.name = name;
  p.component = "stretch.bias";
  p.identified = identified;
  return p;
}

TEST(Verdict, TellsOfSheetsBesideStripsByTheirDistance) {
  Results results;
  ResultExperiment sheet;
  sheet.name = "overhang";
  sheet.sheet_folder = "sheets/overhang";
  sheet.rms_position_mm = 0.17;
  results.experiments = {experiment("a", 1.4), sheet};
  EXPECT_THAT(
      verdict(results),
      HasSubstr("In 1 experiment the sheets lie within 0.17 mm (RMS) of the predicted ones"));
}

TEST(Verdict, CountsFitsAndPredictionsWithTheirLargestErrors) {
  Results results;
  results.experiments = {experiment("a", 1.4), experiment("b", 0.6), experiment("c", 3.0, true),
                         experiment("d", 5.7, true)};
  EXPECT_EQ(verdict(results),
            "The material reproduces 2 of 2 fitted experiments within 1.4 % of peak force. "
            "2 validation experiments are predicted within 5.7 % of peak force.");
}

TEST(Verdict, NamesAFittedExperimentThatIsNotReproduced) {
  Results results;
  results.experiments = {experiment("a", 1.4), experiment("b", 12.0)};
  EXPECT_EQ(verdict(results),
            "The material reproduces 1 of 2 fitted experiments within 1.4 % of peak force, but not "
            "b (12 %).");
}

TEST(Verdict, CutsALongListOfMisses) {
  Results results;
  results.experiments = {experiment("good", 1.0)};
  for (const char* name : {"a", "b", "c", "d", "e", "f"}) {
    results.experiments.push_back(experiment(name, 12.0));
  }
  EXPECT_THAT(verdict(results), HasSubstr("but not a (12 %), b (12 %), c (12 %) and 3 more."));
}

TEST(Verdict, SaysWhenNothingIsReproduced) {
  Results results;
  results.experiments = {experiment("a", 31.0)};
  EXPECT_EQ(verdict(results),
            "The material reproduces none of 1 fitted experiment within 5 % of peak force; the RMS "
            "error reaches 31 %.");
}

TEST(Verdict, AFitThatDidNotConvergeSaysSoFirst) {
  Results results;
  results.converged = false;
  results.experiments = {experiment("a", 1.0)};
  EXPECT_THAT(verdict(results), StartsWith("The fit did not converge"));
}

TEST(Verdict, AnEvaluationPredictsAndFitsNothing) {
  Results results;
  results.evaluation = true;
  results.experiments = {experiment("a", 4.0)};
  EXPECT_EQ(verdict(results), "1 experiment is predicted within 4.0 % of peak force.");
}

TEST(Verdict, TakesLengthsAsPercentageOfTheirRange) {
  Results results;
  results.experiments = {experiment("a", 1.4)};
  results.experiments[0].quantity = "length_mm";
  EXPECT_EQ(verdict(results),
            "The material reproduces 1 of 1 fitted experiment within 1.4 % of the range "
            "of the lengths.");
}

TEST(Verdict, GivesLengthsInMillimetres) {
  Results results;
  ResultExperiment lengths;
  lengths.rms_position_mm = 0.113;
  lengths.measured_loop = LoopMeasures{};
  results.experiments = {lengths};
  EXPECT_EQ(verdict(results), "In 1 experiment the RMS error of the lengths is at most 0.11 mm.");
}

TEST(Verdict, SaysWhatTheDataDoNotDetermine) {
  Results results;
  results.parameters = {parameter("stretch.bias.friction.a", false)};
  EXPECT_THAT(verdict(results), HasSubstr("The data do not determine friction of stretch.bias."));
}

TEST(Undetermined, NamesAWholeGroupOnce) {
  Results results;
  results.parameters = {parameter("stretch.bias.k1", true),
                        parameter("stretch.bias.friction.a", false),
                        parameter("stretch.bias.friction.b", false)};
  EXPECT_THAT(undetermined(results), ElementsAre("friction of stretch.bias"));
}

TEST(Undetermined, NamesSingleParametersOfAGroup) {
  Results results;
  results.parameters = {parameter("stretch.bias.friction.a", true),
                        parameter("stretch.bias.friction.b", false)};
  EXPECT_THAT(undetermined(results), ElementsAre("stretch.bias.friction.b"));
}

TEST(Undetermined, NamesFrictionOfDataThatNeverUnload) {
  Results results;
  results.experiments = {experiment("a", 1.0)};
  results.experiments[0].component = "stretch.warp";
  results.experiments[0].measured_loop.reset();
  EXPECT_THAT(undetermined(results), ElementsAre("friction of stretch.warp"));
  EXPECT_THAT(undetermined_with_reasons(results),
              ElementsAre("friction of stretch.warp: its data never unload"));
}

TEST(Undetermined, TakesTheReasonsOfTheFitAndWhatElseItNames) {
  Results results;
  results.parameters = {parameter("stretch.bias.friction.a", false),
                        parameter("stretch.bias.friction.b", true)};
  results.undetermined = {"stretch.bias.friction.a (its 95 % interval includes zero)",
                          "stretch.bias.friction.b (the data pushes it to its bound)"};
  EXPECT_THAT(undetermined_with_reasons(results), ElementsAreArray(results.undetermined));
}

TEST(Undetermined, LeavesFixedParametersOut) {
  Results results;
  results.parameters = {parameter("stretch.bias.k1", false)};
  results.parameters[0].fixed = true;
  EXPECT_THAT(undetermined(results), IsEmpty());
}

}  // namespace
}  // namespace pliant::report
