#include "pliant/study/results.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::TemporaryFolder;
using ::testing::HasSubstr;

Results read_fit_json(const std::string& fit_json) {
  const TemporaryFolder folder;
  folder.write("fit.json", fit_json);
  return read_results(folder.path());
}

TEST(ReadResults, TakesTheFewFieldsThatEveryFitHas) {
  const Results results = read_fit_json(R"({"pliant": "fit/1", "experiments": [{"name": "warp"}],
                                   "parameters": [{"name": "stretch.warp.friction.a"}]})");
  EXPECT_EQ(results.parameters[0].component, "stretch.warp");
  EXPECT_EQ(results.experiments[0].prediction_file, "predictions/warp.csv");
  EXPECT_FALSE(results.parameters[0].value);
}

TEST(ReadResults, RefusesADirectoryWithoutResults) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_results(folder.path()), InputError);
}

TEST(ReadResults, RefusesTruncatedJson) {
  EXPECT_THROW(read_fit_json(R"({"pliant": "fit/1", "experiments": [)"), InputError);
}

TEST(ReadResults, SurvivesDeepNesting) {
  EXPECT_THROW(read_fit_json(R"({"pliant": )" + std::string(100'000, '[')), InputError);
  EXPECT_THROW(
      read_fit_json(R"({"pliant": )" + std::string(100'000, '[') + std::string(100'000, ']') + "}"),
      InputError);
}

TEST(ReadResults, RefusesAnotherDocument) {
  EXPECT_THAT(input_error_of([] { read_fit_json(R"({"pliant": "fit/2"})"); }).what(),
              HasSubstr("fit/2"));
}

TEST(ReadResults, NamesTheFieldThatIsNotANumber) {
  const InputError error = input_error_of([] {
    read_fit_json(
        R"({"pliant": "fit/1", "parameters": [{"name": "a"}, {"name": "b", "value": "4"}]})");
  });
  EXPECT_EQ(error.where().field, "parameters[1].value");
}

TEST(ReadResults, KnowsWhatIsNotDeterminedFromResultsThatDoNotJudge) {
  const Results results =
      read_fit_json(R"({"pliant": "fit/1", "undetermined": ["friction of shear"]})");
  EXPECT_THAT(results.judgement.undetermined, ::testing::ElementsAre("friction of shear"));
}

TEST(ReadResults, RefusesACovarianceOfTheWrongSize) {
  const InputError error = input_error_of([] {
    read_fit_json(R"({"pliant": "fit/1", "parameters": [{"name": "a"}], "covariance": [[1, 2]]})");
  });
  EXPECT_EQ(error.where().field, "covariance");
}

TEST(ReadResults, ReadsNoPredictionsFromOutsideTheDirectory) {
  for (const char* file : {"/etc/passwd", "../other.csv"}) {
    const InputError error = input_error_of([&] {
      read_fit_json(
          std::string(R"({"pliant": "fit/1", "experiments": [{"name": "a", "prediction_file": ")") +
          file + R"("}]})");
    });
    EXPECT_EQ(error.where().field, "experiments[0].prediction_file");
  }
}

TEST(ReadResults, ReadsTheRigidityOfABendingLoopInPlaceOfAModulus) {
  const Results results = read_fit_json(
      R"({"pliant": "fit/1", "experiments": [{"name": "kes", "loop": {
          "measured": {"secant_modulus_N_per_m": null, "secant_rigidity_N_m": 5e-5},
          "predicted": {"secant_modulus_N_per_m": null, "secant_rigidity_N_m": 4e-5}}}]})");
  const ResultExperiment& kes = results.experiments.at(0);
  EXPECT_FALSE(kes.measured_loop->secant_modulus);
  EXPECT_EQ(kes.measured_loop->secant_rigidity, 5e-5);
  EXPECT_EQ(kes.predicted_loop->secant_rigidity, 4e-5);
}

}  // namespace
}  // namespace pliant
