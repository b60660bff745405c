#pragma once

#include <string>
#include <vector>

#include "pliant/estimation/component_fit.h"
#include "pliant/estimation/fit_result.h"

namespace pliant {

/// Fits a component again without what it remembers, and with one further law each, and ranks the
/// laws by AIC and BIC. What no row shows is left out: laws that remember where nothing unloads,
/// and those of time where rows have none.
std::vector<ModelRank> compare_laws(const ComponentProblem& problem, const ComponentFit& fit,
                                    const ComponentPlan& plan);

/// What the ranking means for who fitted: whether another law is clearly better, or which tests
/// would tell the best ones apart.
std::vector<std::string> law_advice(const std::vector<ModelRank>& ranks);

}  // namespace pliant
