#pragma once

#include "pliant/base/run_context.h"
#include "pliant/estimation/component_problem.h"
#include "pliant/estimation/fit_settings.h"
#include "pliant/estimation/start_search.h"

namespace pliant {

/// A law of one shape fitted to a component's experiments.
struct LawFit {
  ComponentLaw law;
  Eigen::VectorXd nuisance;
  std::vector<Unknown> unknowns;
  bool monotone_stress = false;  ///< the elastic stress may not fall where strain rises
  LeastSquaresSummary solution;
  double rms = 0;  ///< of the weighted residuals, per degree of freedom: a useless parameter does
                   ///< not lower it
  StartRecord starts;  ///< ends as `rms`; one without hope was left on its way
};

/// Where a search begins.
struct LawStart {
  ComponentLaw law;
  Eigen::VectorXd nuisance = {};  ///< empty: where the unknowns begin
};

/// Fits stiffness values, friction and nuisance parameters of a law by bounded least squares, from
/// several starting points.
///
/// Starts are the linear fits at the local minima over tau (see linear_starts) and the same with
/// friction spread over a wider and a narrower strain, so that the result does not hang on one
/// guess; all of it is deterministic.
/// @param shape  stiffness curve and friction law; its values are not used
/// @param extra  further starting points (e.g. a fit of a simpler shape); may be empty
LawFit fit_law(const ComponentProblem& problem, const ComponentLaw& shape,
               const FitOptions& options, const std::vector<LawStart>& extra = {});

/// The same from these starts alone.
/// @param starts  at least one; all of one shape
LawFit fit_law_from(const ComponentProblem& problem, const std::vector<LawStart>& starts,
                    const FitOptions& options);

/// The same to the few digits that a comparison needs.
LawFit fit_law_roughly(const ComponentProblem& problem, const ComponentLaw& shape,
                       const FitOptions& options, const std::vector<LawStart>& extra = {});

/// Fits again from the solution itself, after the problem's noise has changed.
LawFit refit(const ComponentProblem& problem, const LawFit& fit);

/// The unit of the weighted residuals while the noise is not known yet: they are weighed by stated
/// noise, or by 1 % of the measured range.
std::string unit_of_residuals(const ComponentProblem& problem);

/// The same fit, its cost in units of the problem's new noise: for a noise that has changed by one
/// factor, which moves no minimum.
LawFit reweighed(const ComponentProblem& problem, const LawFit& fit);

/// The least-squares problem of a fit.
Problem problem_of(const ComponentProblem& problem, const LawFit& fit);

/// Component name that the problem's experiments share.
const std::string& component_of(const ComponentProblem& problem);

}  // namespace pliant
