#include "pliant/estimation/sheet/sheet_fitting.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/estimation/sheet/sheet_journal.h"
#include "pliant/estimation/sheet/sheet_options.h"

namespace pliant {

SheetFitting::SheetFitting(const FitSettings& settings, std::vector<SheetStage> plan,
                           const RunContext& context, const Material* start,
                           const KnownComponents& known)
    : settings_(settings),
      context_(context),
      search_(context, begin_journal(context.journal, settings, plan, start)) {
  fit_.material = first_sheet_material(settings, known);
  for (const auto& [component, law] : known) known_.insert(component);
  fit_.groups = groups_of(plan);
  fit_.plan = std::move(plan);
  if (start) {
    fit_.material.components = start->components;
    fitted_ = fit_.groups;
  }
}

void SheetFitting::restore(const State& state) {
  fit_.material = state.material;
  fit_.cords = state.cords;
  fit_.converged = state.converged;
}

SheetProblem SheetFitting::problem_of(const SheetStage& stage) const {
  std::vector<ComponentGroup> groups = going_along(stage.groups);
  std::vector<double> strains;
  for (const ComponentGroup& group : groups) strains.push_back(strain_of(group));
  return {stage.tests, fit_.material, std::move(groups), std::move(strains),
          context_,    fit_.cords,    settings_.fit,     with_cords(stage)};
}

double SheetFitting::solve(const SheetStage& stage) {
  SheetProblem problem = problem_of(stage);
  const StageSearch::Solution found = search_.least(stage, problem);
  problem.keep_cords(found.values, fit_.cords);
  fit_.converged = fit_.converged && found.converged;
  fit_.material = problem.material_at(found.values);
  return found.rms;
}

std::optional<double> SheetFitting::solved(const SheetStage& stage) {
  try {
    return solve(stage);
  } catch (const SolverError&) {
    return std::nullopt;
  }
}

double SheetFitting::solve_and_record(const SheetStage& stage) {
  const double rms = solve(stage);
  record(stage, rms, true);
  return rms;
}

void SheetFitting::record(const SheetStage& stage, double rms, bool accepted) {
  const int points = stiffness_of(stage.groups.front()).size();
  std::string what = points == 0
                         ? "addends alone"
                         : fmt::format("{} control point{}", points, points == 1 ? "" : "s");
  if (stage.groups.size() > 1) what = "together";
  if (stage.kind == StageKind::limit) what += " with a limit of energy";
  if (stage.kind == StageKind::sample) {
    what += fmt::format(" at {} samples", fit_.material.samples.at.size());
  }
  if (stage.kind == StageKind::friction) {
    const bool rubs = law_of(fit_.material, stage.groups.front()).remembers();
    what += rubs ? " and friction" : " and cords";
  }
  fit_.stages.push_back(
      {names_of(stage.groups), what, unit_of(stage), in_unit(stage, rms), accepted});
}

void SheetFitting::record_end(GrowthEnd end) { fit_.stages.back().ended = name_of(end); }

bool SheetFitting::is_fitted(const ComponentGroup& group) const {
  return std::ranges::find(fitted_, group) != fitted_.end();
}

void SheetFitting::mark_fitted(const ComponentGroup& group) {
  if (!is_fitted(group)) fitted_.push_back(group);
}

bool SheetFitting::is_fixed(const ComponentGroup& group) const {
  return fixed_stiffness(settings_.fit, group).has_value() ||
         std::ranges::any_of(group, [&](const auto& name) { return known_.contains(name); });
}

const ScalarCurve& SheetFitting::stiffness_of(const ComponentGroup& group) const {
  return *fit_.material.components.at(group.front()).stiffness;
}

void SheetFitting::give_stiffness(const ComponentGroup& group, const ScalarCurve& stiffness) {
  for (const std::string& component : group) {
    fit_.material.components[component].stiffness = stiffness;
  }
}

std::vector<ComponentGroup> SheetFitting::going_along(std::vector<ComponentGroup> groups) const {
  if (groups.size() != 1 || !is_bending(groups.front().front()) || is_fixed(groups.front())) {
    return groups;
  }
  const auto first = std::ranges::find_if(
      fitted_, [](const ComponentGroup& group) { return is_bending(group.front()); });
  if (first != fitted_.end() && *first != groups.front()) return groups;
  for (const char* component : {"bend.weft", "bend.warp", "bend.diagonal"}) {
    const bool known = std::ranges::any_of(fitted_, [&](const ComponentGroup& group) {
      return std::ranges::find(group, component) != group.end();
    });
    ComponentGroup& group = groups.front();
    const bool own = std::ranges::find(group, component) != group.end();
    if (!known && !own && !is_fixed({component})) group.emplace_back(component);
  }
  return groups;
}

bool SheetFitting::has_friction_stage(const SheetTest& test) const {
  return std::ranges::any_of(fit_.plan, [&](const SheetStage& stage) {
    return stage.kind == StageKind::friction &&
           std::ranges::find(stage.tests, &test) != stage.tests.end();
  });
}

bool SheetFitting::with_cords(const SheetStage& stage) const {
  return stage.kind == StageKind::friction ||
         std::ranges::none_of(stage.tests,
                              [&](const SheetTest* test) { return has_friction_stage(*test); });
}

bool SheetFitting::begin_at_best(const SheetStage& stage, const ComponentGroup& group,
                                 const char* what, const std::vector<ComponentLaw>& laws,
                                 const StartOptions& options) {
  std::vector<std::vector<ComponentLaw>> starts;
  for (const ComponentLaw& law : laws) starts.push_back({law});
  return begin_at_best(stage, std::vector<ComponentGroup>{group}, what, starts, options);
}

bool SheetFitting::begin_at_best(const SheetStage& stage, const std::vector<ComponentGroup>& groups,
                                 const char* what,
                                 const std::vector<std::vector<ComponentLaw>>& starts,
                                 const StartOptions& options) {
  if (starts.empty()) return false;
  const Material before = fit_.material;
  StartRecord record{names_of(groups), what, unit_of(stage), {}, 0, /*followed=*/false};
  const auto give = [&](std::size_t start) {
    for (std::size_t g = 0; g < groups.size(); ++g) {
      set_law(fit_.material, groups[g], starts[start][g]);
    }
  };
  const auto begin = [&](std::size_t start, double least) {
    give(start);
    SheetProblem problem = problem_of(stage);
    const LeastSquaresSummary begun = search_.at_start(stage, problem, least);
    record.ends.push_back(in_unit(stage, problem.rms(begun)));
    return begun.cost;
  };
  const StartSearch search = search_from(starts.size(), begin, options);
  if (search.found()) {
    give(search.best);
  } else {
    fit_.material = before;
  }
  record.reached_best = search.reached_best;
  fit_.starts.push_back(std::move(record));
  return search.found();
}

bool SheetFitting::guess_addends(const SheetStage& stage, const ComponentGroup& group,
                                 bool remembering) {
  return begin_at_best(stage, group, remembering ? "addends that remember" : "elastic addends",
                       first_addends(law_of(fit_.material, group), model_of(settings_, group),
                                     strain_of(group), remembering));
}

double frames_of(const SheetStage& stage) {
  double frames = 0;
  for (const SheetTest* test : stage.tests) frames += test->frame_count();
  return frames;
}

bool is_worth(const SheetStage& stage, int parameters, double without, double with) {
  const double frames = frames_of(stage);
  return is_worth({without, 0, 0, frames}, {with, parameters, 0, frames});
}

const char* unit_of(const SheetStage& stage) { return is_about_positions(stage) ? "mm" : "N"; }
double in_unit(const SheetStage& stage, double rms) {
  return is_about_positions(stage) ? 1e3 * rms : rms;
}

}  // namespace pliant
