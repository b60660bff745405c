#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pliant/base/run_context.h"
#include "pliant/study/virtual_lab.h"

namespace pliant {

/// Names of the sessions of an experiment: its own, or one for each specimen. Each has a directory
/// of that name.
std::vector<std::string> session_names(const VirtualLab& lab, const LabExperiment& experiment);

/// Measures all sessions of a lab, side by side.
/// @return names and contents of their files
/// @throws SolverError that names the session
std::vector<std::pair<std::string, std::string>> make_sessions(const VirtualLab& lab,
                                                               const RunContext& context);

}  // namespace pliant
