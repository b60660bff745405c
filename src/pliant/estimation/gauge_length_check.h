#pragma once

#include <string>
#include <vector>

#include "pliant/estimation/component_fit.h"
#include "pliant/estimation/component_problem.h"

namespace pliant {

/// Fits each experiment's law once more with the length of its specimens free. Says where a third
/// of what the fit misses of it, or more, goes with another length than the stated one.
std::vector<std::string> gauge_length_warnings(const ComponentProblem& problem,
                                               const ComponentFit& fit);

}  // namespace pliant
