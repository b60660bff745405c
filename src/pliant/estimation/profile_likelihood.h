#pragma once

#include "pliant/estimation/component_fit.h"
#include "pliant/estimation/fit_result.h"

namespace pliant {

/// Profile likelihood of one unknown of a component fit: it is held at a row of values around its
/// estimate, all others are fitted again, and the rise of chi squared is told, rows of a
/// correlation length counting as one, in units in which it is that of a known noise. Where it
/// passes 3.84 lies the 95 % interval, which need not be symmetric.
/// @param index  of the unknown, law first
Profile profile_likelihood(const ComponentProblem& problem, const ComponentFit& fit,
                           Eigen::Index index);

/// One-sided 95 % limit of an unknown whose estimate is at its bound, by its profile; nothing where
/// none is found.
std::optional<double> limit_at_bound(const ComponentProblem& problem, const LawFit& fit,
                                     const Uncertainty& uncertainty, Eigen::Index index);

}  // namespace pliant
