#pragma once

#include <string>
#include <vector>

#include "pliant/estimation/component_fit.h"

namespace pliant {

/// What slip, compliance and rest lengths that were estimated along take of a misfit, and what of
/// the material changes by it: a sentence each. The component is fitted again without them.
std::vector<std::string> apparatus_shares(const ComponentProblem& problem, const ComponentFit& fit);

}  // namespace pliant
