#include "pliant/report/page_budget.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace pliant::report {
namespace {

const std::vector<std::string>& measured_components() {
  static const std::vector<std::string> names{
      "stretch.weft", "stretch.warp", "stretch.bias", "shear", "coupling", "area", "bend.weft"};
  return names;
}

/// A fit of some components with so many experiments each, all of which were kept in part.
Results fit_of(std::size_t components, std::size_t experiments) {
  Results results;
  for (std::size_t c = 0; c < components; ++c) {
    const std::string& name = measured_components()[c];
    results.figures.push_back({name, "stiffness_at_rest", "N/m", 1, {}, {}, {}, {}});
    for (std::size_t i = 0; i < experiments; ++i) {
      ResultExperiment e;
      e.component = name;
      e.validation = i % 2 == 1;
      results.experiments.push_back(e);
    }
  }
  return results;
}

TEST(PageBudget, GivesTheLoopsOfASmallFitWhatTheTablesLeave) {
  const PageBudget one = page_budget(fit_of(1, 1), 200, 4);
  EXPECT_EQ(one.loops, 1U);
  EXPECT_EQ(one.experiments, 1U);
  EXPECT_EQ(one.facts, 4U);
  EXPECT_GT(one.height_of_loops, page_budget(fit_of(3, 2), 200, 4).height_of_loops);
}

TEST(PageBudget, LeavesAFitOfManyComponentsOneRowOfLoopsAndSomeExperiments) {
  const PageBudget many = page_budget(fit_of(7, 3), 500, 10);
  EXPECT_EQ(many.loops, 2U);
  EXPECT_GE(many.experiments, 4U);
  EXPECT_LT(many.experiments, 18U);
  EXPECT_GE(many.height_of_loops, 150) << "lower figures cannot be read";
}

}  // namespace
}  // namespace pliant::report
