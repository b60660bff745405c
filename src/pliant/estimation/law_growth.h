#pragma once

#include <vector>

#include "pliant/estimation/law_fit.h"
#include "pliant/estimation/statistics/model_growth.h"

namespace pliant {

/// One law that growth has tried.
struct GrowthStage {
  int control_points = 0;
  int branches = 0;  ///< of friction; 0: it has none
  double rms = 0;    ///< of the weighted residuals, per degree of freedom
  bool accepted = false;
};

struct GrownFit {
  LawFit fit;
  std::vector<GrowthStage> stages;
  GrowthEnd end = GrowthEnd::not_worth_it;
};

/// How far a law may grow.
struct GrowthLimits {
  int control_points = 0;  ///< of a Hermite stiffness; 0: the stiffness stays as it is
  int branches = 1;        ///< of Dahl friction, where there is any
};

/// Fits a law that grows from one control point and one branch of friction. Each step goes to
/// another control point or to another branch, whichever is worth more; it ends when neither one
/// step nor two are worth it (`is_worth`, [T] 3.4.2). Loops that a law without friction cannot
/// follow hide nothing: what they leave is taken out before.
///
/// The component's own friction is the branch with the least tau; further ones are addends `dahl`
/// in the order of theirs, after the addends of the form.
/// @param form  friction law and addends that are fitted along; its stiffness where that stays
GrownFit grow_law(const ComponentProblem& problem, const ComponentLaw& form,
                  const GrowthLimits& limits, const FitOptions& options);

}  // namespace pliant
