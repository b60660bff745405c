#pragma once

#include <string>
#include <vector>

#include "pliant/estimation/law_fit.h"

namespace pliant {

/// One step of growing a stiffness curve.
struct GrowthStage {
  int control_points = 0;
  double rms = 0;  ///< of the weighted residuals, per degree of freedom
  bool accepted = false;
};

struct GrownFit {
  LawFit fit;
  std::vector<GrowthStage> stages;
};

/// Fits a Hermite stiffness whose number of control points grows from one to at most
/// `options.control_points`, while one or two more are worth it (`is_worth`, [T] 3.4.2). Loops that
/// a law without friction cannot follow hide nothing: what they leave is taken out before.
///
/// The thesis places them at equal distances. Here each new one splits the interval whose splitting
/// explains most of the data, in its middle, at the median of the data's strains or where half of
/// its rise in stress is reached, whichever is best: a stiff weave with a long toe needs its points
/// where the curve bends.
/// @param form  friction law and addends that are fitted along; its stiffness is not used
GrownFit grow_stiffness(const ComponentProblem& problem, const ComponentLaw& form,
                        const FitOptions& options);

}  // namespace pliant
