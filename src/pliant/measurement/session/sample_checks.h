#pragma once

#include <string>
#include <vector>

#include "pliant/measurement/session.h"

namespace pliant {

/// Sentences about what no piece of cloth on a test bench is like: its size, its mass per area, its
/// gravity, the name of a test that is a slip, and a sheet that nothing holds.
std::vector<std::string> sample_warnings(const Session& session);

}  // namespace pliant
