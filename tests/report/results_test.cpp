#include "pliant/report/results.h"

#include <functional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/report/report_data.h"

#include "report/sample_results.h"

namespace pliant::report {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryFolder;
using testing::write_sample_results;
using testing::write_text;

Results read(const std::string& fit_json) {
  const TemporaryFolder folder;
  write_text(folder.path() / "fit.json", fit_json);
  return read_results(folder.path());
}

InputError error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error;
  }
  throw std::logic_error("no InputError");
}

TEST(ReadResults, TakesTheFewFieldsThatEveryFitHas) {
  const Results results = read(R"({"pliant": "fit/1", "experiments": [{"name": "warp"}],
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
  EXPECT_THROW(read(R"({"pliant": "fit/1", "experiments": [)"), InputError);
}

TEST(ReadResults, SurvivesDeepNesting) {
  EXPECT_THROW(read(R"({"pliant": )" + std::string(100'000, '[')), InputError);
  EXPECT_THROW(read(R"({"pliant": )" + std::string(100'000, '[') + std::string(100'000, ']') + "}"),
               InputError);
}

TEST(ReadResults, RefusesAnotherDocument) {
  EXPECT_THAT(error_of([] { read(R"({"pliant": "fit/2"})"); }).what(), HasSubstr("fit/2"));
}

TEST(ReadResults, NamesTheFieldThatIsNotANumber) {
  const InputError error = error_of([] {
    read(R"({"pliant": "fit/1", "parameters": [{"name": "a"}, {"name": "b", "value": "4"}]})");
  });
  EXPECT_EQ(error.where().field, "parameters[1].value");
}

TEST(ReadResults, KnowsWhatIsNotDeterminedFromResultsThatDoNotJudge) {
  const Results results = read(R"({"pliant": "fit/1", "undetermined": ["friction of shear"]})");
  EXPECT_THAT(results.judgement.undetermined, ::testing::ElementsAre("friction of shear"));
}

TEST(ReadResults, RefusesACovarianceOfTheWrongSize) {
  const InputError error = error_of([] {
    read(R"({"pliant": "fit/1", "parameters": [{"name": "a"}], "covariance": [[1, 2]]})");
  });
  EXPECT_EQ(error.where().field, "covariance");
}

TEST(ReadResults, ReadsNoPredictionsFromOutsideTheDirectory) {
  for (const char* file : {"/etc/passwd", "../other.csv"}) {
    const InputError error = error_of([&] {
      read(
          std::string(R"({"pliant": "fit/1", "experiments": [{"name": "a", "prediction_file": ")") +
          file + R"("}]})");
    });
    EXPECT_EQ(error.where().field, "experiments[0].prediction_file");
  }
}

TEST(ReadResults, ReadsTheRigidityOfABendingLoopInPlaceOfAModulus) {
  const Results results = read(
      R"({"pliant": "fit/1", "experiments": [{"name": "kes", "loop": {
          "measured": {"secant_modulus_N_per_m": null, "secant_rigidity_N_m": 5e-5},
          "predicted": {"secant_modulus_N_per_m": null, "secant_rigidity_N_m": 4e-5}}}]})");
  const ResultExperiment& kes = results.experiments.at(0);
  EXPECT_FALSE(kes.measured_loop->secant_modulus);
  EXPECT_EQ(kes.measured_loop->secant_rigidity, 5e-5);
  EXPECT_EQ(kes.predicted_loop->secant_rigidity, 4e-5);
}

TEST(ReadReportData, TakesAnEmptyBandAsUnknown) {
  const TemporaryFolder folder;
  write_sample_results(folder.path());
  write_text(folder.path() / "curves.csv",
             "component,strain,load,unload,low,high\nshear,0,0,0,,\nshear,0.1,1,1,,\n");
  EXPECT_TRUE(read_report_data(folder.path()).curves.at(0).low.empty());
}

TEST(ReadReportData, NamesAMissingPredictionFile) {
  const TemporaryFolder folder;
  write_sample_results(folder.path());
  std::filesystem::remove(folder.path() / "predictions" / "weft-stretch-8cm.csv");
  EXPECT_THAT(error_of([&] { read_report_data(folder.path()); }).where().file,
              HasSubstr("weft-stretch-8cm.csv"));
}

TEST(ReadReportData, RefusesAnUnknownBranchWithItsLine) {
  const TemporaryFolder folder;
  write_sample_results(folder.path());
  write_text(folder.path() / "predictions" / "warp-stretch-8cm.csv",
             "strain,branch,measured_force_N,predicted_force_N\n0,load,0,0\n0.1,up,1,1\n");
  EXPECT_EQ(error_of([&] { read_report_data(folder.path()); }).where().line, 3);
}

}  // namespace
}  // namespace pliant::report
