#pragma once

#include <vector>

#include "pliant/estimation/component_problem.h"
#include "pliant/material/component_law.h"

namespace pliant {

/// A law found without iteration, to start a fit from.
struct LinearStart {
  ComponentLaw law;
  double cost = 0;  ///< sum of squared force errors, each experiment relative to its peak
};

/// For a fixed tau the force is linear in stiffness values, a and b, and in a factor of each
/// addend: solves for them along the measured path, none of them negative, with a force offset for
/// each experiment that has one as nuisance parameter. Slackness is left to the fit.
/// @param shape  stiffness curve, friction law and addends; of its values those of the addends
/// alone
///               are used
/// @param tau    strain constant of friction; unused without friction
/// @throws Interrupted
LinearStart linear_start(const ComponentProblem& problem, const ComponentLaw& shape, double tau);

/// Linear starts all over a range of tau, for all of the addends' beginnings; without friction one
/// for each of these.
std::vector<LinearStart> linear_starts_over_tau(const ComponentProblem& problem,
                                                const ComponentLaw& shape);

/// Linear starts at the local minima of their cost over a range of tau, for all of the addends'
/// beginnings, the best first, at most `most` of them.
std::vector<LinearStart> linear_starts(const ComponentProblem& problem, const ComponentLaw& shape,
                                       int most);

}  // namespace pliant
