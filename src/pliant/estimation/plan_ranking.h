#pragma once

#include <string>
#include <vector>

#include "pliant/estimation/component_fit.h"
#include "pliant/estimation/fit_result.h"

namespace pliant {

/// Another way to fit a component.
struct RivalPlan {
  std::string name;
  ComponentPlan plan;
  std::string told_by = {};  ///< the test that would tell it from others
};

/// Fits a component by each plan and ranks them by AIC and BIC, the best first; rows whose
/// residuals go together count as one.
/// @param fit  of the component, which tells how they do
std::vector<ModelRank> rank_plans(const ComponentProblem& problem, const ComponentFit& fit,
                                  const std::vector<RivalPlan>& rivals);

}  // namespace pliant
