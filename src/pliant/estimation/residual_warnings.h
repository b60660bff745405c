#pragma once

#include <string>
#include <vector>

#include "pliant/estimation/fit_result.h"

namespace pliant {

/// What the residuals of a fitted experiment say of its data: that they go with the specimens, the
/// repeats, the sides or the order of its rows and not with the law, or that its readings are
/// coarse. A sentence each, the cause that explains most alone where several would.
/// @param path  of the experiment's rows
std::vector<std::string> residual_warnings(const ExperimentResult& experiment,
                                           const MeasuredPath& path);

}  // namespace pliant
