#pragma once

#include <vector>

#include "pliant/estimation/component_fit.h"
#include "pliant/estimation/fit_result.h"

namespace pliant {

/// Fits the parameterisations of [T] Fig. 5.3 and the purely elastic law with the control points of
/// a fit, and ranks them by AIC and BIC, in which rows whose residuals go together count as one.
std::vector<ModelRank> compare_friction(const ComponentProblem& problem, const ComponentFit& fit,
                                        const ComponentPlan& plan);

}  // namespace pliant
