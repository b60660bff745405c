#include "pliant/estimation/sheet/sheet_uncertainty.h"

#include <algorithm>
#include <utility>

#include "pliant/estimation/sheet/sheet_problem.h"

namespace pliant {
namespace {

/// The tests of a plan, in its order, and the last stage of each.
std::vector<std::pair<const SheetTest*, const SheetStage*>> last_stages(
    const std::vector<SheetStage>& plan) {
  std::vector<std::pair<const SheetTest*, const SheetStage*>> tests;
  for (const SheetStage& stage : plan) {
    for (const SheetTest* test : stage.tests) {
      const auto known =
          std::ranges::find(tests, test, &std::pair<const SheetTest*, const SheetStage*>::first);
      if (known == tests.end())
        tests.emplace_back(test, &stage);
      else
        known->second = &stage;
    }
  }
  return tests;
}

const SheetStage* last_stage(const std::vector<SheetStage>& plan, const ComponentGroup& group) {
  const SheetStage* last = nullptr;
  for (const SheetStage& stage : plan) {
    if (std::ranges::find(stage.groups, group) != stage.groups.end()) last = &stage;
  }
  return last;
}

}  // namespace

SheetUncertainty sheet_uncertainty(const SheetFit& fit, const FitOptions& options,
                                   const RunContext& context) {
  SheetUncertainty result;
  std::vector<const SheetStage*> stage_of;  // of each unknown
  for (const ComponentGroup& group : fit.groups) {
    const std::vector<Unknown> own =
        unknowns_of(fit.material, {group}, {largest_strain(fit, group)},
                    shortest_edge(*fit.plan.front().tests.front()));
    result.unknowns.insert(result.unknowns.end(), own.begin(), own.end());
    stage_of.insert(stage_of.end(), own.size(), last_stage(fit.plan, group));
  }
  std::vector<ProblemPart> parts;
  const auto tests = last_stages(fit.plan);
  for (const auto& [test, stage] : tests) {
    const std::vector<Unknown> cords = cord_unknowns(*test, fit.cords);
    result.unknowns.insert(result.unknowns.end(), cords.begin(), cords.end());
    stage_of.insert(stage_of.end(), cords.size(), stage);
    parts.push_back({test, test->predictor(fit.material)});
  }
  apply_options(options, result.unknowns);
  result.values = starts_of(result.unknowns);

  ToldUnknowns told;
  for (const auto& [test, stage] : tests) {
    std::vector<char>& own = told.emplace_back();
    for (const SheetStage* last : stage_of) {
      own.push_back(std::ranges::find(last->tests, test) != last->tests.end() ? 1 : 0);
    }
  }
  const Problem problem(std::move(parts), result.unknowns, {context.threads, context.stop});
  result.uncertainty = uncertainty_of(problem, result.values, told);
  result.work = problem.work();
  return result;
}

}  // namespace pliant
