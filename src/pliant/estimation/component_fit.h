#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pliant/base/run_context.h"
#include "pliant/estimation/fit_result.h"
#include "pliant/estimation/fit_settings.h"
#include "pliant/estimation/law_fit.h"
#include "pliant/estimation/law_uncertainty.h"
#include "pliant/estimation/rest_influence.h"

namespace pliant {

/// How one component is to be fitted.
struct ComponentPlan {
  CurveKind stiffness = CurveKind::hermite;
  FrictionLaw friction = FrictionLaw::dahl;
  int branches = 1;  ///< of friction at most; those beyond the first grow
  bool branches_stated = false;
  std::vector<const AddendKind*> addends;
  FitOptions fit;

  /// The law without its stiffness; the numbers are not yet known.
  ComponentLaw form() const;
};

/// A fitted component with all that is said about it.
struct ComponentFit {
  std::string component;
  LawFit fit;
  Uncertainty uncertainty;
  std::optional<LawFit> elastic;  ///< best purely elastic law with the same control points
  std::vector<FitStage> stages;
  std::vector<std::optional<SpecimenSpread>> specimens;  ///< of the law's parameters
  /// One-sided 95 % limits of unknowns at their bounds, away from them.
  std::vector<std::optional<double>> limits;
  RestInfluence rests;  ///< of strips that may rest in several shapes; its shift is in the errors
};

/// Raises the errors of a law's parameters to what its specimens make them at least.
void raise_errors(ComponentFit& component);

/// The plan that a study and its data imply: affine stiffness where only weights were hung or
/// strips rolled, constant where there are bending lengths or buckled strips alone, else hermite;
/// friction where the data unloads.
/// @param notes  gets a sentence on friction that is left out, and on what one number cannot tell
/// @throws InputError where the study asks for the published estimator of a buckled strip, or of
///         strips that all roll with their weight
ComponentPlan plan_component(const FitSettings& settings,
                             const std::vector<const ComponentExperiment*>& experiments,
                             std::vector<std::string>& notes);

/// A law whose form the data has chosen, as far as the plan leaves it open.
struct FormFit {
  LawFit fit;
  std::vector<FitStage> stages;
};

/// Fits the law of a plan by `path`, control points grown as far as they are worth it.
FormFit fit_form(const ComponentProblem& problem, const ComponentPlan& plan);

/// Fits one component; `problem` keeps the noise that its residuals show.
ComponentFit fit_component(ComponentProblem& problem, const ComponentPlan& plan);

}  // namespace pliant
