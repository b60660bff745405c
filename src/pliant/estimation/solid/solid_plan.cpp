#include "pliant/estimation/solid/solid_plan.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/base/name_pattern.h"
#include "pliant/estimation/solid/solid_problem.h"

namespace pliant {
namespace {

std::vector<const Experiment*> experiments_of(const PlanStage& stage,
                                              const std::vector<const Experiment*>& all) {
  std::set<const Experiment*> chosen;
  for (const std::string& pattern : stage.experiments) {
    bool found = false;
    for (const Experiment* experiment : all) {
      if (!matches(pattern, experiment->info().name)) continue;
      chosen.insert(experiment);
      found = true;
    }
    if (found) continue;
    throw InputError(stage.where, quoted_value(pattern) + " matches no experiment that is fitted",
                     "a name or a pattern with *");
  }
  std::vector<const Experiment*> own;
  std::ranges::copy_if(all, std::back_inserter(own),
                       [&](const Experiment* experiment) { return chosen.contains(experiment); });
  return own;
}

void require_components(const PlanStage& stage, const Material& material) {
  for (const std::string& name : stage.components) {
    if (material.components.contains(name)) continue;
    std::vector<std::string> names;
    for (const auto& [own, component] : material.components) names.push_back(own);
    throw InputError(stage.where, quoted_value(name) + " is no component of the model",
                     fmt::format("one of {}", fmt::join(names, ", ")));
  }
}

/// The same study with the numbers of a component as they are.
void hold_numbers(const Material& material, const std::string& component, FitSettings& settings) {
  const ComponentLaw law = law_of(material.components.at(component));
  const std::vector<std::string> names = parameter_names(law, component);
  const Eigen::VectorXd values = law.parameters();
  for (std::size_t i = 0; i < names.size(); ++i) {
    settings.fit.fix[names[i]] = values(static_cast<Eigen::Index>(i));
  }
}

}  // namespace

std::vector<FitStage> follow_plan(const FitSettings& settings,
                                  const std::vector<const Experiment*>& experiments,
                                  const RunContext& context, Material& material) {
  std::vector<FitStage> told;
  std::set<std::string> there;
  for (const auto& [name, component] : material.components) {
    if (is_of_volume(name)) there.insert(name);
  }
  for (const PlanStage& stage : settings.fit.plan) {
    require_components(stage, material);
    there.insert(stage.components.begin(), stage.components.end());
    FitSettings own_settings = settings;
    Material own = material;
    std::erase_if(own.components, [&](const auto& c) { return !there.contains(c.first); });
    for (const auto& [name, component] : own.components) {
      if (std::ranges::find(stage.components, name) == stage.components.end()) {
        hold_numbers(own, name, own_settings);
      }
    }
    SolidProblem problem(own_settings, experiments_of(stage, experiments), context);
    for (const std::string& name : stage.components) {
      if (problem.data_of(name).is_seen()) continue;
      throw InputError(stage.where, quoted_value(name) + " changes in no experiment of the stage",
                       "experiments that strain it");
    }
    const LeastSquaresSummary solution = problem.solve(own);
    const bool found = std::isfinite(solution.cost);
    told.push_back({"solid", fmt::format("stage {}", fmt::join(stage.components, ", ")),
                    kDifferenceUnit, rms_of(solution, problem.rows()), found});
    if (!found) continue;
    for (const std::string& name : stage.components) {
      material.components.at(name) = own.components.at(name);
    }
  }
  return told;
}

}  // namespace pliant
