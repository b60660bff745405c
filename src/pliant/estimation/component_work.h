#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pliant/estimation/component_fit.h"
#include "pliant/estimation/component_problem.h"
#include "pliant/estimation/fit_result.h"
#include "pliant/experiment/component_experiment.h"

namespace pliant {

/// One component of a study: its experiments, and what was made of them.
struct ComponentWork {
  std::string component;
  std::vector<const ComponentExperiment*> fitted;
  std::vector<const ComponentExperiment*> validated;
  ComponentPlan plan;
  std::optional<ComponentProblem> problem;  ///< none where nothing is fitted
  ComponentFit fit;
  std::vector<ModelRank> models;
  std::vector<Profile> profiles;
  std::vector<std::string> apparatus;  ///< what it takes of the misfit
  std::vector<std::string> lengths;    ///< what the data say against the stated ones
};

/// Adds what a component's fit found out to the result of its study: parameters, comparisons,
/// curve, warnings.
void add_component(const ComponentWork& work, StudyResult& result);

/// Adds the figures of a component of the material that the study determined.
void add_figures(const ComponentWork& work, const Material& material, StudyResult& result);

/// Covariance of all unknowns of a study: parameters of all components first, then all nuisance
/// parameters, as in fit.json.
Eigen::MatrixXd joint_covariance(const std::vector<ComponentWork>& works);

/// The material that a study determined; components without data are unmeasured.
Material material_of(const FitSettings& settings, const std::vector<ComponentWork>& works);

}  // namespace pliant
