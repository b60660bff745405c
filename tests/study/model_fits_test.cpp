#include "pliant/study/model_fits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/input_error_of.h"
#include "io/temporary_folder.h"
#include "support/compared_models.h"

namespace pliant {
namespace {

using ::testing::HasSubstr;

ModelFits read_summary(const std::string& text) {
  const test::TemporaryFolder folder;
  folder.write("summary.json", text);
  return read_model_fits(folder.path());
}

TEST(ModelFitsFile, IsReadAsItWasWrittenWithThoseThatFailed) {
  const std::string text = summary_json(test::sample_model_fits());
  const ModelFits fits = read_summary(text);
  EXPECT_EQ(summary_json(fits), text);
  ASSERT_EQ(fits.comparison.fits.size(), 4u);
  ASSERT_EQ(fits.comparison.sessions.size(), 2u);
  EXPECT_EQ(fits.comparison.sessions[0].unit, "N");
  EXPECT_TRUE(fits.comparison.sessions[1].validation);
  EXPECT_EQ(fits.comparison.fits[0].error(0), 0.123);
  EXPECT_EQ(fits.comparison.fits[3].failure, "no grid");
  EXPECT_FALSE(fits.comparison.fits[3].error(0).has_value());
}

TEST(ModelFitsFile, IsJudgedWhereAnEarlierVersionDidNot) {
  nlohmann::json json = nlohmann::json::parse(summary_json(test::sample_model_fits()));
  json.erase("verdict");
  EXPECT_THAT(read_summary(json.dump()).verdict, HasSubstr("followed best by"));
}

TEST(ModelFitsFile, NamesTheFieldThatIsWrong) {
  const InputError error = test::input_error_of(
      [] { read_summary(R"({"pliant": "fits-of-models/1", "fits": [{"model": 3}]})"); });
  EXPECT_THAT(error.what(), HasSubstr("fits[0].model"));
}

TEST(ModelFitsTable, LeavesEmptyWhatAFitThatFailedDoesNotHave) {
  const std::string csv = summary_csv(test::sample_model_fits().comparison);
  EXPECT_THAT(csv, HasSubstr("model,variant,pull_N,corner_N,misfit_percent,parameters,converged,"
                             "seconds,failure\n"
                             "stvk,nonlinear-orthotropic,0.123,0.9,2,10,1,12.3,\n"));
  EXPECT_THAT(csv, HasSubstr("springs,nonlinear-isotropic,,,,,,,no grid\n"));
}

TEST(ModelComparison, HasItsFitsInTheOrderOfTheTables) {
  ModelComparison comparison;
  for (const ModelVariant& combination :
       model_variants({"springs", "stvk"}, {"nonlinear-orthotropic", "linear-isotropic"})) {
    add_fit({combination, "no grid", {}, {}}, comparison);
  }
  std::vector<std::string> names;
  for (const ComparedFit& fit : comparison.fits) names.push_back(fit_title(fit));
  EXPECT_THAT(names, ::testing::ElementsAre("nonlinear orthotropic St. Venant-Kirchhoff",
                                            "nonlinear orthotropic springs",
                                            "linear isotropic St. Venant-Kirchhoff",
                                            "linear isotropic springs"));
}

}  // namespace
}  // namespace pliant
