#include "pliant/report/page_one_loops.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pliant::report {
namespace {

using ::testing::ElementsAre;

ResultExperiment experiment(const std::string& name, const std::string& component, int points,
                            bool validation = false) {
  ResultExperiment e;
  e.name = name;
  e.component = component;
  e.points = points;
  e.validation = validation;
  return e;
}

TEST(PageOneLoops, HaveTheValidationBesideTheFitOfTheSameComponent) {
  Results results;
  results.experiments = {experiment("warp", "stretch.warp", 90), experiment("bend", "bend.warp", 9),
                         experiment("warp-2cm", "stretch.warp", 50, /*validation=*/true)};
  EXPECT_THAT(experiments_on_page_one(results), ElementsAre(0, 2, 1));
}

TEST(PageOneLoops, BeginWithTheComponentThatIsMissedMost) {
  Results results;
  results.experiments = {experiment("warp", "stretch.warp", 90), experiment("bend", "bend.warp", 9),
                         experiment("bend-8cm", "bend.warp", 50, /*validation=*/true),
                         experiment("bend-4cm", "bend.warp", 20, /*validation=*/true)};
  results.judgement.misses = {"bend-4cm"};
  EXPECT_THAT(experiments_on_page_one(results), ElementsAre(1, 3, 0));
}

TEST(PageOneLoops, AreFourAtMost) {
  Results results;
  for (const char* component : {"stretch.warp", "stretch.weft", "bend.warp"}) {
    results.experiments.push_back(experiment("fitted", component, 10));
    results.experiments.push_back(experiment("kept", component, 10, /*validation=*/true));
  }
  EXPECT_THAT(experiments_on_page_one(results), ElementsAre(0, 1, 2, 3));
}

}  // namespace
}  // namespace pliant::report
