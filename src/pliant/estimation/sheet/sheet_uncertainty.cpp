#include "pliant/estimation/sheet/sheet_uncertainty.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "pliant/base/assert.h"
#include "pliant/estimation/mesh_error.h"
#include "pliant/estimation/sheet/sheet_problem.h"

namespace pliant {
namespace {

/// The tests of a plan, in its order, and the last stage of each.
std::vector<std::pair<const SheetTest*, const SheetStage*>> last_stages(
    const std::vector<SheetStage>& plan) {
  std::vector<std::pair<const SheetTest*, const SheetStage*>> tests;
  for (const SheetTest* test : tests_of(plan)) {
    const SheetStage* last = nullptr;
    for (const SheetStage& stage : plan) {
      if (std::ranges::find(stage.tests, test) != stage.tests.end()) last = &stage;
    }
    tests.emplace_back(test, last);
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

const SheetStage* limit_stage(const std::vector<SheetStage>& plan) {
  const auto found = std::ranges::find(plan, StageKind::limit, &SheetStage::kind);
  PLIANT_ASSERT(found != plan.end(), "a limit is fitted by a stage of its own");
  return &*found;
}

/// The tests that stand for those of a problem, where they are the same frames of them.
std::vector<const SheetTest*> in_place_of(const std::vector<const SheetTest*>& tests,
                                          const std::vector<const SheetTest*>& others) {
  std::vector<const SheetTest*> result;
  for (const SheetTest* test : tests) {
    const auto found = std::ranges::find_if(others, [&](const SheetTest* other) {
      return other->name() == test->name() && other->frame_count() == test->frame_count();
    });
    result.push_back(found == others.end() ? test : *found);
  }
  return result;
}

/// How far the free unknowns move on other meshes; empty where these have no equilibria.
Eigen::VectorXd shift_on(const std::vector<const SheetTest*>& coarser, const Problem& problem,
                         const Material& material, const SheetUncertainty& fine,
                         const ToldUnknowns& told, const RunContext& context,
                         EquilibriumWork& work) {
  const Uncertainty& known = fine.uncertainty;
  std::vector<ProblemPart> parts;
  std::vector<Eigen::VectorXd> weight;
  for (std::size_t t = 0; t < coarser.size(); ++t) {
    const ExperimentNoise& noise = known.noise.of[t];
    parts.push_back({coarser[t], coarser[t]->predictor(material)});
    weight.push_back(coarser[t]->weights() * problem.emphasis(t) /
                     (noise.sd * std::sqrt(noise.correlation_length)));
  }
  const Problem coarse(std::move(parts), fine.unknowns, {context.threads, context.stop});
  const Eigen::VectorXd moved = moved_on(coarse, weight, problem, fine.values, known, told);
  if (moved.size() > 0) work += coarse.work();
  return moved;
}

}  // namespace

// docs/estimation.md: The statistics of a fit ([Bell2002]), The error of the mesh.
SheetUncertainty sheet_uncertainty(const SheetFit& fit, const FitOptions& options,
                                   const RunContext& context,
                                   const std::vector<const SheetTest*>& coarser) {
  SheetUncertainty result;
  std::vector<const SheetStage*> stage_of;  // of each unknown
  for (const ComponentGroup& group : fit.groups) {
    const std::vector<Unknown> own =
        unknowns_of(fit.material, {group}, {largest_strain(fit, group)},
                    shortest_edge(*fit.plan.front().tests.front()));
    result.unknowns.insert(result.unknowns.end(), own.begin(), own.end());
    stage_of.insert(stage_of.end(), own.size(), last_stage(fit.plan, group));
  }
  for (const std::size_t limit : limits_of(fit.material, fit.groups)) {
    result.unknowns.push_back(unknown_of(fit.material.limits[limit], fit.material.kind));
    stage_of.push_back(limit_stage(fit.plan));
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
  if (coarser.empty()) return result;
  std::vector<const SheetTest*> used;
  for (const auto& [test, stage] : tests) used.push_back(test);
  result.mesh_error = shift_on(in_place_of(used, coarser), problem, fit.material, result, told,
                               context, result.work);
  if (result.mesh_error.size() > 0) {
    add_systematic(result.mesh_error, result.unknowns, result.values, result.uncertainty);
  }
  return result;
}

}  // namespace pliant
