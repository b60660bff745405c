#include "pliant/estimation/start_search.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/estimation/fit_result.h"

namespace pliant {
namespace {

using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Follows starts that lead to these costs.
StartSearch searched(const std::vector<double>& costs, const StartOptions& options = {}) {
  return search_from(
      costs.size(), [&](std::size_t start, double) { return costs[start]; }, options);
}

TEST(StartSearch, KeepsWhereEachStartHasLedAndTakesTheFirstOfTheBest) {
  const std::vector<double> costs{3, INFINITY, 2, 2.0001, 2};
  const StartSearch search = searched(costs);
  EXPECT_THAT(search.costs, ElementsAreArray(costs));
  EXPECT_EQ(search.best, 2u);
  EXPECT_EQ(search.reached_best, 3) << "to within 0.1 %";
  EXPECT_EQ(searched(costs, {.exact = 1}).reached_best, 4);
}

TEST(StartSearch, TellsEachStartWhatOthersHaveLedTo) {
  std::vector<double> told;
  const std::vector<double> costs{5, 7, 4, 6};
  search_from(costs.size(), [&](std::size_t start, double least) {
    told.push_back(least);
    return costs[start];
  });
  EXPECT_EQ(told, (std::vector<double>{INFINITY, 5, 5, 4}));
}

TEST(StartSearch, LeavesOutTheRestOfAnOrderThatOnlyGetsWorse) {
  // Those without prediction, a plateau and one that is worse alone end nothing.
  const std::vector<double> costs{INFINITY, INFINITY, 10, 10.5, 8, 9, 7, 8, 9, 1};
  const StartSearch search = searched(costs, {.patience = 2});
  EXPECT_EQ(search.costs.size(), 9u);
  EXPECT_EQ(search.best, 6u);
  EXPECT_EQ(searched(costs).best, 9u);
}

TEST(StartSearch, LeavesOutTheRestWhereEnoughHaveLedToTheBest) {
  const std::vector<double> costs{5, 2, 7, 2.001, 1};
  const StartSearch search = searched(costs, {.enough = 2});
  EXPECT_EQ(search.costs.size(), 4u);
  EXPECT_EQ(search.best, 1u);
}

TEST(StartSearch, FindsNothingWhereNoStartHasAPrediction) {
  EXPECT_FALSE(searched({INFINITY, INFINITY}).found());
  EXPECT_FALSE(searched({}).found());
  EXPECT_TRUE(searched({INFINITY, 1}).found());
}

TEST(StartRecord, IsToldWhereItsBestStartStandsAlone) {
  StudyResult result;
  add_starts({"shear", "law", "N", {1, 2, 3}, 1}, result);
  ASSERT_EQ(result.assumptions.size(), 1u);
  EXPECT_THAT(result.assumptions.front(), HasSubstr("shear: of 3 starts one alone led to the fit"));
  EXPECT_EQ(result.starts.size(), 1u);
}

TEST(StartRecord, SaysNothingOfOneStartOfSeveralThatAgreeAndOfStartsThatWereNotFollowed) {
  StudyResult result;
  add_starts({"shear", "law", "N", {1}, 1}, result);
  add_starts({"shear", "law", "N", {1, 1, 3}, 2}, result);
  add_starts({"shear", "friction", "N", {1, 2, 3}, 1, /*followed=*/false}, result);
  EXPECT_THAT(result.assumptions, IsEmpty());
  EXPECT_EQ(result.starts.size(), 3u);
}

}  // namespace
}  // namespace pliant
