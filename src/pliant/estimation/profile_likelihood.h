#pragma once

#include "pliant/estimation/component_fit.h"
#include "pliant/estimation/fit_result.h"

namespace pliant {

/// Profile likelihood of one unknown of a component fit: it is held at a row of values around its
/// estimate, all others are fitted again, and the rise of chi squared is told in units of the
/// residual variance (correlation of the residuals counted in). Where it passes 3.84 lies the 95 %
/// interval, which need not be symmetric.
/// @param index  of the unknown, law first
Profile profile_likelihood(const ComponentProblem& problem, const ComponentFit& fit,
                           Eigen::Index index, const StopToken& stop);

}  // namespace pliant
