#pragma once

#include <string>
#include <string_view>

#include "pliant/estimation/fit_result.h"

namespace pliant {

/// Compares an experiment's measurement with a law's prediction.
/// @param nuisance  fitted values, or `unfitted_nuisance` for a prediction without a fit
/// @throws SolverError when the law cannot carry the experiment's loads
ExperimentResult compare(const ComponentExperiment& experiment, const ComponentLaw& law,
                         const Eigen::VectorXd& nuisance);

/// What `handled` says of an experiment that is predicted with its `unfitted_nuisance`.
/// @param material  "the material not fitted to it"
std::string unfitted_note(const ExperimentInfo& info, std::string_view material);

/// Adds the prediction of a purely elastic law for comparison; without effect when it cannot carry
/// the loads.
void add_elastic(ExperimentResult& result, const ComponentExperiment& experiment,
                 const ComponentLaw& elastic, const Eigen::VectorXd& nuisance);

}  // namespace pliant
