#pragma once

#include <string>
#include <vector>

#include "pliant/estimation/component_fit.h"

namespace pliant {

/// What the fit of a component says of its apparatus without having been asked: numbers of an
/// experiment that undo each other (a force offset and the friction at the start), lengths that are
/// read too coarsely, and stated gauge lengths that the data contradict.
std::vector<std::string> nuisance_warnings(const ComponentProblem& problem,
                                           const ComponentFit& fit);

}  // namespace pliant
